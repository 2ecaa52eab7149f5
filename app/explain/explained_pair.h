#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/query/query_source.h"
#include "core/explain/pair_explanation.h"
#include "render/view/any_volume.h"
#include "scenes/scene/raw_pairs.h"

namespace scb::app {

/// A node of a body's hierarchy.
struct ExplainedNode {
    std::string body;
    std::uint32_t index = 0;
    int depth = 0;
    std::uint32_t triangles = 0;  ///< below it
    bool are_objects = false;     ///< these are no triangles, but an engine's objects
    std::string remark{};         ///< what else there is to say of it, in words
};

/// Two volumes, what an overlap test says of them step by step, and the exact answer.
struct ExplainedPair {
    VolumeKind kind{};
    render::AnyVolume a, b;  ///< of one type, each in its own frame
    Placement placed;
    OverlapOptions options;
    PairExplanation found;
    std::vector<std::string> notes{};                     ///< see RawPair; how hierarchies were
                                                          ///< built where that is unusual
    std::optional<std::array<ExplainedNode, 2>> nodes{};  ///< whose volumes they are
};

/// Two nodes of hierarchies of this kind, placed as in a query. `nodes` must be there; `build` is
/// how both were built.
ExplainedPair explained_nodes(VolumeKind kind, const AnyHierarchy& a, const AnyHierarchy& b,
                              const Pose& b_to_a, const OverlapOptions& options,
                              const BuildOptions& build, const std::array<ExplainedNode, 2>& nodes);

/// A node of a hierarchy. Throws InputError where there is none; `option` is what named it.
ExplainedNode explained_node(const AnyHierarchy& hierarchy, const std::string& body,
                             std::int64_t node, const std::string& option);

/// Two nodes of the query's bodies, placed as in the query itself. Throws InputError where there is
/// no such node; `option` is what named them.
ExplainedPair explained_nodes(const SceneQuery& query, int frame,
                              const std::array<std::int64_t, 2>& nodes, const std::string& option);

ExplainedPair explained_volumes(const scenes::AnyRawPair& pair, const OverlapOptions& options);

/// B as seen from A.
render::AnyVolume b_seen_from_a(const ExplainedPair& pair);

/// The angle between the normals of two slab cut balls, in degrees, without the digits in which C
/// libraries differ.
double normal_angle(const ExplainedPair& pair);

}  // namespace scb::app
