#include "app/pictures/query_comparison.h"

#include <nlohmann/json.hpp>

#include "app/pictures/query_index.h"

namespace scb::app {

render::ComparedQueries compared_queries(const QueryView& view, const QuerySources& sources,
                                         const QueryFrames& frames) {
    render::ComparedQueries queries;
    for (std::size_t i = 0; i < 2; ++i) {
        queries[i] = {view.bodies(frames[i]->frame, i), &sources[i].header(), frames[i], {}};
        queries[i].contact =
            render::contact_segments(queries[i].bodies, *queries[i].header, *queries[i].frame);
    }
    return queries;
}

void draw_comparison(const QueryView& view, const render::ComparedQueries& queries,
                     const render::PairsOfOne& only_here, std::array<render::ComparedView, 2> views,
                     const std::string& title, const std::string& what,
                     const QueryViewOptions& options, PictureRun& pictures) {
    const QueryFrames frames = {queries[0].frame, queries[1].frame};
    std::vector<AnyVolume> region;
    for (const render::ComparedQuery& query : queries) {
        const std::vector<AnyVolume> contact =
            render::contact_region(query.bodies, *query.header, *query.frame, query.contact);
        region.insert(region.end(), contact.begin(), contact.end());
    }
    render::ComparisonFigure figure;
    const render::Camera camera = view.camera(region);
    nlohmann::ordered_json entry = query_index_entry(view, frames, camera);
    entry["only_in_one"] = nlohmann::ordered_json::array();
    for (const std::vector<IndexPair>& pairs : only_here)
        entry["only_in_one"].push_back(pairs.size());
    if (what == "pairs") entry["pair_ids"] = pair_ids_json(view, frames);
    entry["outlined"] = views[0].outlined ? nlohmann::ordered_json(*views[0].outlined) : nullptr;
    for (std::size_t i = 0; i < 2; ++i) {
        views[i].caption = view.labels()[i].caption;
        views[i].pane.camera = camera;
    }
    figure.title = view.title(title + " compared");
    figure.subtitle = view.subtitle(frames[0]->frame);
    for (const render::ComparedView& each : views)
        pictures.explain(
            figure.title + " · " + view.labels()[0].caption + " / " + view.labels()[1].caption,
            each.legend);
    figure.views = std::move(views);
    figure.center = view.center(region);
    figure.theme = options.picture.theme();
    const render::Picture picture =
        render::compose(std::move(figure), *view.layout(), options.picture.width(),
                        options.picture.height(), options.picture.samples, pictures.overlay());
    const std::string name = view.picture_name(what, frames[0]->frame);
    pictures.draw(name, picture, std::move(entry));
    view.tell_pick(pictures, name, frames);
}

}  // namespace scb::app
