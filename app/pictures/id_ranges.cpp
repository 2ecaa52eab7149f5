#include "app/pictures/id_ranges.h"

#include <optional>

#include "scb/error.h"
#include "scenes/text/utf8.h"

namespace scb::app {
namespace {

/// The place of an id in a range.
std::optional<std::uint32_t> index_in(const IdRange& range, std::uint32_t id) {
    if (id < range.first || id - range.first >= range.count) return std::nullopt;
    return id - range.first;
}

}  // namespace

IdRanges id_ranges(const SceneQuery& query) {
    const std::array<std::size_t, 2> bodies = {query.a, query.b};
    IdRanges ids;
    std::size_t next = 1;
    const auto take = [&next](std::size_t count) {
        const IdRange range = {static_cast<std::uint32_t>(next), count};
        next += count;
        if (next >= 0x80000000u)
            throw InputError(
                "the scene has more nodes and triangles than ids; use smaller meshes.");
        return range;
    };
    for (std::size_t side = 0; side < 2; ++side)
        ids.nodes[side] = take(topology_of(query.hierarchy(bodies[side])).nodes.size());
    for (std::size_t side = 0; side < 2; ++side)
        ids.triangles[side] = take(query.mesh(bodies[side]).triangles.size());
    ids.first_free = static_cast<std::uint32_t>(next);
    return ids;
}

std::vector<IdRange> pair_id_ranges(const IdRanges& ids, const QueryFrames& frames) {
    std::vector<IdRange> ranges;
    std::uint32_t first = ids.first_free;
    for (const TraceFrame* frame : frames) {
        ranges.push_back({first, frame->found.pairs.size()});
        first += static_cast<std::uint32_t>(frame->found.pairs.size());
    }
    return ranges;
}

std::string id_text(const IdRanges& ids, const SceneQuery& query, const QueryFrames& frames,
                    std::uint32_t id) {
    const std::array<std::size_t, 2> bodies = {query.a, query.b};
    const auto name = [&](std::size_t side) {
        return " of " + scenes::printable(query.scene.bodies[bodies[side]].name);
    };
    for (std::size_t side = 0; side < 2; ++side) {
        if (const auto node = index_in(ids.nodes[side], id)) {
            const Topology& topology = topology_of(query.hierarchy(bodies[side]));
            const std::uint32_t count = topology.nodes[*node].count;
            return "node " + std::to_string(*node) + name(side) + ", depth " +
                   std::to_string(node_depths(topology)[*node]) + ", " + std::to_string(count) +
                   (count == 1 ? " triangle" : " triangles");
        }
        if (const auto triangle = index_in(ids.triangles[side], id))
            return "triangle " + std::to_string(*triangle) + name(side);
    }
    const std::vector<IdRange> pairs = pair_id_ranges(ids, frames);
    for (std::size_t i = 0; i < pairs.size(); ++i)
        if (const auto index = index_in(pairs[i], id)) {
            const IndexPair pair = frames[i]->found.pairs[*index];
            return "triangles " + std::to_string(pair.a) + " and " + std::to_string(pair.b) +
                   " meet";
        }
    return "nothing";
}

}  // namespace scb::app
