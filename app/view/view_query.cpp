#include "app/view/view_query.h"

#include <nlohmann/json.hpp>

#include "app/view/view_manifest.h"
#include "core/analysis/ending.h"
#include "render/web/query_blocks.h"
#include "scenes/text/utf8.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

Json groups_json(const TraceHeader& header) {
    const std::vector<render::EndingGroup> light =
                                               render::ending_groups(header, render::light_theme),
                                           dark = render::ending_groups(header, render::dark_theme);
    Json groups = Json::array();
    for (std::size_t i = 0; i < light.size(); ++i) {
        // Those at which the triangles of two leaves were tested, which are drawn in their place.
        const bool triangles =
            std::all_of(light[i].endings.begin(), light[i].endings.end(), [](Outcome ending) {
                return ending == Outcome::triangles_apart || ending == Outcome::triangles_meet;
            });
        const bool finds =
            std::any_of(light[i].endings.begin(), light[i].endings.end(), [](Outcome ending) {
                return ending == Outcome::triangles_meet || ending == Outcome::found;
            });
        groups.push_back({{"label", scenes::printable(light[i].label)},
                          {"light", color_json(light[i].color)},
                          {"dark", color_json(dark[i].color)},
                          {"triangles", triangles},
                          {"finds", finds},
                          {"rejects", is_rejection(light[i].endings.front())}});
    }
    return groups;
}

}  // namespace

Json view_query_json(QuerySource& source, const LevelTrees& trees, render::BlockStore& store) {
    const TraceHeader& header = source.header();
    const std::vector<render::EndingGroup> groups =
        render::ending_groups(header, render::light_theme);
    const std::array<std::size_t, 2> places = {source.body_index(0), source.body_index(1)};
    render::QueryBodies bodies;
    for (std::size_t side = 0; side < 2; ++side)
        bodies[side].tree = trees.bodies[places[side]].tree.get();
    Json frames = Json::array();
    for (const int number : source.frames()) {
        const TraceFrame& frame = source.frame(number);
        const render::QueryBlocks blocks =
            render::query_blocks(bodies, header, frame, groups, store);
        Json entry = {{"frame", number},
                      {"n_v", frame.found.n_v},
                      {"n_p", frame.found.n_p},
                      {"pairs", frame.found.pairs.size()},
                      {"outcomes", blocks.outcomes},
                      {"pair_block", blocks.pairs}};
        if (blocks.nodes) entry["nodes"] = *blocks.nodes;
        frames.push_back(std::move(entry));
    }
    return {{"bodies", places},
            {"objects", pairs_are_nodes(header)},
            {"groups", groups_json(header)},
            {"frames", std::move(frames)}};
}

}  // namespace scb::app
