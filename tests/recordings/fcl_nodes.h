#pragma once

#include "tests/peers/fcl_model.h"
#include "tests/recordings/recorded_engine.h"

namespace scb {

/// The number of the triangle of a leaf of FCL.
template <class Model>
std::uint32_t triangle_of(const Model& model, int leaf) {
    return static_cast<std::uint32_t>(model.getBV(leaf).primitiveId());
}

/// Builds FCL's tree of a mesh, and records it as body `number`. `values_of`: the numbers of a
/// node's volume.
template <class Model, class ValuesOf>
void record_fcl_body(scb_recorder& recorder, std::uint32_t number, const PeerMesh& mesh,
                     Model& model, scb_record_kind kind, const ValuesOf& values_of) {
    build(mesh, model);
    record_body(recorder, number, mesh);
    for (int i = 0; i < model.getNumBVs(); ++i) {
        const auto& node = model.getBV(i);
        std::vector<std::uint32_t> children, items;
        if (node.isLeaf())
            items = {triangle_of(model, i)};
        else
            children = {static_cast<std::uint32_t>(node.leftChild()),
                        static_cast<std::uint32_t>(node.rightChild())};
        record_node(recorder, number, static_cast<std::uint32_t>(i), children, items, kind,
                    values_of(node.bv));
    }
}

}  // namespace scb
