#pragma once

#include <string>
#include <variant>
#include <vector>

#include "scb/any_packed.h"
#include "tests/core/hierarchy/built_mesh.h"

namespace scb {

/// A layout as a type for tests of all of them.
template <class Codec_>
struct LayoutOf {
    using Codec = Codec_;
};

/// Calls `each` with a LayoutOf for every layout, and its name.
template <class Each>
void for_each_layout(Each each) {
    each(LayoutOf<FloatCodec<2>>(), "float, 2 wide");
    each(LayoutOf<FloatCodec<4>>(), "float, 4 wide");
    each(LayoutOf<FloatCodec<8>>(), "float, 8 wide");
    each(LayoutOf<QuantizedCodec<2>>(), "quantized, 2 wide");
    each(LayoutOf<QuantizedCodec<4>>(), "quantized, 4 wide");
    each(LayoutOf<QuantizedCodec<8>>(), "quantized, 8 wide");
    each(LayoutOf<FloatCodec<2, Scb2>>(), "two slabs, float, 2 wide");
    each(LayoutOf<FloatCodec<4, Scb2>>(), "two slabs, float, 4 wide");
    each(LayoutOf<FloatCodec<8, Scb2>>(), "two slabs, float, 8 wide");
    each(LayoutOf<QuantizedCodec<2, Scb2>>(), "two slabs, quantized, 2 wide");
    each(LayoutOf<QuantizedCodec<4, Scb2>>(), "two slabs, quantized, 4 wide");
    each(LayoutOf<QuantizedCodec<8, Scb2>>(), "two slabs, quantized, 8 wide");
}

/// The reference hierarchy of slab cut balls, or of V.
template <class V = Scb>
const Hierarchy<V>& scb_of(const BuiltMesh& built) {
    for (const AnyHierarchy& hierarchy : built.hierarchies)
        if (const auto* scb = std::get_if<Hierarchy<V>>(&hierarchy)) return *scb;
    std::abort();
}

/// The reference hierarchies of all volumes that can be packed.
inline std::vector<AnyHierarchy> packable(const BuiltMesh& built) {
    return {scb_of<Scb>(built), scb_of<Scb2>(built)};
}

}  // namespace scb
