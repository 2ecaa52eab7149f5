#include "app/pictures/query_index.h"

#include <nlohmann/json.hpp>

#include "app/report/count_table.h"
#include "app/report/scene_report.h"
#include "app/report/trace_report.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

void add_ids(Json& list, const QueryView& view, const char* what,
             const std::array<IdRange, 2>& ranges) {
    const TraceHeader& header = view.sources().front().header();
    for (std::size_t side = 0; side < 2; ++side)
        list.push_back({{"what", what},
                        {"body", header.bodies[side].name},
                        {"first", ranges[side].first},
                        {"count", ranges[side].count}});
}

/// The engine's node numbers, for the ids of nodes.
void add_node_numbers(Json& entry, const QueryTrace& frame) {
    Json numbers = Json::array();
    bool own = false;
    for (const std::shared_ptr<const Tree>& tree : frame.trees) {
        if (!tree) return;
        own |= tree->has_own_numbers();
        numbers.push_back(numbers_by_id(*tree));
    }
    if (own) entry["node_numbers"] = std::move(numbers);
}

}  // namespace

Json query_index_head(const QueryView& view, const std::string& command) {
    const QuerySources& sources = view.sources();
    const PictureOptions& picture = view.options().picture;
    const bool shows_bodies = view.options().shown != Shown::nothing;
    Json head = {{"command", command}};
    Json asked = Json::array();
    for (const QuerySource& source : sources) {
        asked.push_back(trace_header_json(source.header()));
        asked.back().erase("version");
    }
    if (view.compares()) {
        head["compare"] = {view.labels()[0].name, view.labels()[1].name};
        head["queries"] = std::move(asked);
    } else {
        head.update(asked[0]);
    }
    head["frames"] = sources.front().frames();
    head["poses"] = poses_json(sources.front().scene(), sources.front().frames());
    if (shows_bodies) {
        Json& ids = head["ids"] = Json::array();
        add_ids(ids, view, "node", view.ids().nodes);
        add_ids(ids, view, "triangle", view.ids().triangles);
    }
    Json& options = head["options"];
    options["size"] = {picture.width(), picture.height()};
    if (shows_bodies) options["samples"] = picture.samples;
    options["background"] = picture.background;
    if (shows_bodies && !view.follows_contact())
        head["camera"] = scenes::camera_json(view.camera_view(view.camera({})));
    if (const auto& sought = view.sought())
        head["sought_direction"] = {{"azimuth", sought->direction.azimuth},
                                    {"elevation", sought->direction.elevation},
                                    {"tried", render::tried_directions},
                                    {"frame", sought->frame},
                                    {"score", sought->direction.score}};
    return head;
}

Json query_index_entry(const QueryView& view, const QueryFrames& frames) {
    Json counts = Json::array();
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const TraceHeader& header = view.sources()[i].header();
        const QueryTrace& frame = *frames[i];
        counts.push_back(count_json(header, frame));
    }
    if (!view.compares()) return counts[0];
    return {{"frame", frames[0]->frame}, {"queries", std::move(counts)}};
}

Json query_index_entry(const QueryView& view, const QueryFrames& frames,
                       const render::Camera& camera) {
    Json entry = query_index_entry(view, frames);
    for (std::size_t i = 0; i < frames.size() && view.options().picture.ids; ++i)
        add_node_numbers(view.compares() ? entry["queries"][i] : entry, *frames[i]);
    if (view.follows_contact() || !view.is_whole(camera))
        entry["camera"] = scenes::camera_json(view.camera_view(camera));
    return entry;
}

Json pair_ids_json(const QueryView& view, const QueryFrames& frames) {
    Json ids = Json::array();
    for (const IdRange& range : pair_id_ranges(view.ids(), frames))
        ids.push_back({{"first", range.first}, {"count", range.count}});
    return ids;
}

}  // namespace scb::app
