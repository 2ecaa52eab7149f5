#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/study/query_source.h"
#include "core/explain/pair_explanation.h"
#include "core/volumes/any_volume.h"
#include "scenes/scene/raw_pairs.h"

namespace scb::app {

/// A node of a body's hierarchy.
struct ExplainedNode {
    std::string body;
    std::uint32_t index = 0;
    int depth = 0;
    std::uint32_t triangles = 0;  ///< below it
    bool are_objects = false;     ///< `triangles` counts an engine's objects
    std::string remark{};         ///< further remarks, as text
};

/// Two volumes, the steps of an overlap test, and the exact answer.
struct ExplainedPair {
    VolumeKind kind{};
    AnyVolume a, b;  ///< of one type, each in its own frame
    Placement placed;
    OverlapOptions options;
    PairExplanation found;
    std::vector<std::string> notes{};  ///< see RawPair; also unusual build options
    std::optional<std::array<ExplainedNode, 2>> nodes{};  ///< the nodes that have these volumes
};

/// Two nodes of hierarchies of this kind, placed as in a query. `nodes` must exist; `build` is how
/// both hierarchies were built.
ExplainedPair explained_nodes(VolumeKind kind, const AnyHierarchy& a, const AnyHierarchy& b,
                              const Pose& b_to_a, const OverlapOptions& options,
                              const BuildOptions& build, const std::array<ExplainedNode, 2>& nodes);

/// A node of a hierarchy. Throws InputError if it does not exist; `option`: the option that named
/// it.
ExplainedNode explained_node(const AnyHierarchy& hierarchy, const std::string& body,
                             std::int64_t node, const std::string& option);

/// Two nodes of the query's bodies, placed as in the query itself. Throws InputError if a node does
/// not exist; `option`: the option that named them.
ExplainedPair explained_nodes(const SceneQuery& query, int frame,
                              const std::array<std::int64_t, 2>& nodes, const std::string& option);

ExplainedPair explained_volumes(const scenes::AnyRawPair& pair, const OverlapOptions& options);

/// B in A's frame.
AnyVolume b_seen_from_a(const ExplainedPair& pair);

/// The angle between the normals of two slab cut balls, in degrees, without the digits in which C
/// libraries differ.
double normal_angle(const ExplainedPair& pair);

}  // namespace scb::app
