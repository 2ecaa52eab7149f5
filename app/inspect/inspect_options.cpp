#include "app/inspect/inspect_options.h"

#include "app/study/query_sources.h"
#include "scb/error.h"
#include "scenes/recordings/recording_input.h"

namespace scb::app {
namespace {

/// Limit with -o: more pictures would only fill the disk.
constexpr int most_pictured = 200;

}  // namespace

bool InspectOptions::take_layout(const Console& console, const InterruptWatch& watch) {
    if (!layout.packed(hierarchy, query, limits)) {
        layout.note_doubts(console.notes());
        return false;
    }
    refuse_with_shard(picture.shards, true, "--layout " + layout.layout,
                      "queries of packed hierarchies are judged as a whole");
    scene = packed_queries(scene, hierarchy, query, limits, layout, console, watch);
    // The recording has these bodies as A and B.
    query.bodies.clear();
    recording.clear();
    return true;
}

void InspectOptions::check() {
    hierarchy.kind();
    hierarchy.build();
    query.collide();
    if (top < 1 || top > 10000)
        throw InputError("--top " + std::to_string(top) + ": give 1 to 10000 pairs.");
    for (const std::string& name : scene.names)
        if (scenes::names_trace(name)) refuse_for_trace(recording, name);
    picture.check();
    if (!draws() && !of_pictures.empty())
        throw InputError(of_pictures[0] + ": it is of pictures; say where with -o DIR.");
    if (!draws()) return;
    if (top > most_pictured)
        throw InputError("--top " + std::to_string(top) + ": with -o, give 1 to " +
                         std::to_string(most_pictured) + " pairs, each of which is drawn.");
}

}  // namespace scb::app
