#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/study/scene_setup.h"
#include "scb/collide.h"
#include "scb/distance.h"

namespace scb::app {

/// What a query measures in place of overlap.
struct DistanceQuery {
    DistanceOptions limits;
    std::optional<double> within;  ///< all triangles that are at most this far apart

    QueryKind kind() const { return within ? QueryKind::within : QueryKind::distance; }
    /// The limits of a query that ends at the first triangles that are `within`.
    DistanceOptions up_to_first() const;
};

/// Parameters of queries, besides the scene and its hierarchies.
struct QueryOptions {
    std::string test{overlap_test_name(OverlapOptions{}.test)};
    double threshold = OverlapOptions{}.threshold;
    DescentRule descent = CollideOptions{}.descent;
    std::string frames = "all";
    std::string bodies{};
    std::optional<DistanceQuery> distance{};  ///< none: the triangles that intersect

    QueryKind kind() const { return distance ? distance->kind() : QueryKind::collide; }
    /// The overlap tests named, each once; throws InputError for an unknown name.
    std::vector<OverlapTest> tests() const;
    /// The one test named, and its threshold; throws InputError.
    OverlapOptions overlap() const;
    /// The options of a query with that test; throws InputError.
    CollideOptions collide() const;
};

/// Limits at which a query ends before it has found everything.
struct QueryLimits {
    std::int64_t max_pairs = 100'000'000;
    std::string levels{};  ///< one level; empty: none

    /// Sets CollideOptions::max_pairs and stop_level. Throws InputError if the number of pairs is
    /// below 1, or the level does not exist. `deepest_level`: the scene's.
    void apply(CollideOptions& options, int deepest_level) const;
};

/// Notes surprising options: `printed` among the tests, and options without effect on hierarchies
/// of these kinds.
void note_doubts(const QueryOptions& options, const std::vector<VolumeKind>& kinds,
                 const Note& note);

/// Whether a recording is to be shown as recorded: no given option sets how hierarchies are built
/// or tested. Otherwise its meshes and poses are used as a scene.
bool asks_for_recorded(const std::vector<std::string>& given);

}  // namespace scb::app
