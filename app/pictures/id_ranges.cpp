#include "app/pictures/id_ranges.h"

#include <algorithm>
#include <optional>

#include "core/platform/utf8.h"
#include "scb/error.h"

namespace scb::app {
namespace {

/// The place of an id in a range.
std::optional<std::uint32_t> index_in(const IdRange& range, std::uint32_t id) {
    if (id < range.first || id - range.first >= range.count) return std::nullopt;
    return id - range.first;
}

}  // namespace

IdRanges id_ranges(const QuerySources& sources) {
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
    // Trees and meshes of recordings may change.
    const auto most = [&](std::size_t side, const auto& count_of) {
        std::size_t count = 0;
        for (const QuerySource& source : sources)
            for (const int frame : source.frames()) {
                count = std::max(count, count_of(source.body(side, frame)));
                if (!source.is_recording()) break;
            }
        return count;
    };
    using Body = BodyAtFrame;
    for (std::size_t side = 0; side < 2; ++side)
        ids.nodes[side] = take(most(side, [](const Body& body) { return body.tree->size(); }));
    for (std::size_t side = 0; side < 2; ++side)
        ids.triangles[side] =
            take(most(side, [](const Body& body) { return body.mesh->triangles.size(); }));
    ids.first_free = static_cast<std::uint32_t>(next);
    return ids;
}

std::vector<std::uint32_t> numbers_by_id(const Tree& tree) {
    std::vector<std::uint32_t> numbers;
    if (!tree.has_own_numbers()) return numbers;
    for (std::uint32_t node = 0; node < tree.size(); ++node) numbers.push_back(tree.number(node));
    return numbers;
}

std::vector<IdRange> pair_id_ranges(const IdRanges& ids, const QueryFrames& frames) {
    std::vector<IdRange> ranges;
    std::uint32_t first = ids.first_free;
    for (const QueryTrace* frame : frames) {
        ranges.push_back({first, frame->found.pairs.size()});
        first += static_cast<std::uint32_t>(frame->found.pairs.size());
    }
    return ranges;
}

std::string id_text(const IdRanges& ids, const QuerySource& source, const QueryFrames& frames,
                    std::uint32_t id) {
    for (std::size_t side = 0; side < 2; ++side) {
        const BodyAtFrame body = source.body(side, frames.front()->frame);
        const std::string of_body = " of " + printable(body.name);
        if (const auto node = index_in(ids.nodes[side], id)) {
            const TreeShape& shape = body.tree->shape();
            const std::uint32_t count = items_below(shape)[*node];
            return printable(body.tree->node_words(*node)) + of_body + ", depth " +
                   std::to_string(shape.depths[*node]) + ", " + std::to_string(count) +
                   (count == 1 ? " triangle" : " triangles");
        }
        if (const auto triangle = index_in(ids.triangles[side], id))
            return "triangle " + std::to_string(*triangle) + of_body;
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
