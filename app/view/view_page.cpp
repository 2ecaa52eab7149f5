#include "app/view/view_page.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "app/cli/command_text.h"
#include "app/cli/version.h"
#include "app/pictures/level_bodies.h"
#include "app/query/level_list.h"
#include "app/query/output_guard.h"
#include "app/query/scene_title.h"
#include "app/view/view_manifest.h"
#include "app/view/view_query.h"
#include "core/base/text_format.h"
#include "render/draw/renderer.h"
#include "render/figures/level_figure.h"
#include "render/files/image_file.h"
#include "render/overlay/overlay.h"
#include "render/web/web_page.h"
#include "scb/error.h"
#include "scenes/text/utf8.h"
#include "scenes/traces/trace_input.h"

namespace scb::app {
namespace {

bool has_two_scenes(const ViewOptions& options) {
    const std::vector<std::string>& names = options.level.scene.names;
    return names.size() == 2 && std::all_of(names.begin(), names.end(), scenes::names_scene);
}

/// The deepest level of which a reader can still tell the volumes.
int first_level(const ViewSubject& subject, const std::string& asked) {
    if (asked != "auto") {
        const int level = parse_level(asked, subject.deepest);
        return level == leaf_level ? subject.deepest : level;
    }
    constexpr std::size_t most = 500;
    int level = 0;
    for (int next = 1; next <= subject.deepest; ++next) {
        std::size_t count = 0;
        for (const scenes::BodyAtFrame& body : subject.columns[0].bodies)
            count += level_cover(body.tree->shape(), next).size();
        if (count > most * subject.columns[0].bodies.size()) break;
        level = next;
    }
    return level;
}

/// What a browser shows that cannot draw.
std::vector<std::uint8_t> still_of(const LevelOptions& options, const ViewSubject& subject,
                                   const ViewStart& start, std::vector<render::LevelBody> bodies,
                                   const std::string& title) {
    const render::Context context(options.picture.backend());
    render::Renderer renderer(context);
    if (start.style.mesh)
        for (render::LevelBody& body : bodies) body.handle = renderer.upload(*body.mesh);
    render::LevelFigure figure;
    figure.title = title;
    figure.subtitle =
        "level " + std::to_string(start.level) + " of 0 to " + std::to_string(subject.deepest);
    figure.bodies = std::move(bodies);
    figure.level = start.level;
    figure.style = start.style;
    figure.camera = start.camera;
    figure.center = start.center;
    render::Overlay overlay;
    const render::Picture picture =
        render::compose(figure, options.picture.width(), options.picture.height(),
                        options.picture.samples, overlay);
    return render::encode_png(renderer.draw(picture, &overlay).image);
}

std::string words_of(const std::vector<std::string>& names) {
    std::string words;
    for (const std::string& name : names) words += " " + file_word(name);
    return words;
}

/// The names of volumes, each once, with commas.
std::string kinds_of(const ViewSubject& subject) {
    std::string kinds;
    std::set<std::string> seen;
    for (const ViewColumn& column : subject.columns)
        if (!column.kind.empty() && seen.insert(column.kind).second)
            kinds += (kinds.empty() ? "" : ",") + column.kind;
    return kinds;
}

/// The commands of pictures of the same, by mode of the page.
std::map<std::string, std::vector<std::string>> commands_of(const ViewOptions& options,
                                                            const ViewSubject& subject) {
    const std::vector<std::string>& names = options.level.scene.names;
    std::vector<std::vector<std::string>> scenes = {names};
    if (has_two_scenes(options)) scenes = {{names[0]}, {names[1]}};
    const std::string kinds = kinds_of(subject);
    const bool one = subject.columns.size() == scenes.size();
    std::string asked = options.volumes;
    if (!options.compare.empty())
        asked = " --compare " + options.compare;
    else if (!one && kinds.find(',') != std::string::npos)
        asked = " --compare " + kinds;
    std::map<std::string, std::vector<std::string>> commands;
    for (const std::vector<std::string>& scene : scenes) {
        std::vector<std::string> of_levels = scene;
        std::string volumes = options.volumes;
        if (const QuerySource* query = subject.columns[0].query;
            query && scenes::names_trace(scene[0])) {
            of_levels = query->header().source;
            volumes = " --volume " + kinds;
        }
        commands["levels"].push_back("scb render levels" + words_of(of_levels) + options.scene +
                                     volumes + options.hierarchies + options.levels);
        // Pictures compare two at a time.
        if (subject.columns.size() > 2 * scenes.size()) continue;
        for (const auto& [mode, picture] : {std::pair{"rejections", "rejections"},
                                            {"pairs", "pairs"},
                                            {"tests", "pairs --heat volumes"},
                                            {"wasted", "pairs --heat wasted"},
                                            {"traversal", "traversal"}})
            commands[mode].push_back(std::string("scb render ") + picture + words_of(scene) +
                                     options.scene + options.bodies + asked + options.hierarchies +
                                     options.queries_asked);
        commands["verdicts"].push_back("scb inspect" + words_of(scene) + options.scene +
                                       options.bodies + (one ? options.volumes : "") +
                                       options.hierarchies + options.queries_asked);
    }
    return commands;
}

/// The command that explains a test of the column, but for frame and nodes.
std::string explain_command(const ViewOptions& options, const ViewColumn& column) {
    if (!column.query || column.query->is_recording()) return "";
    std::string command = "scb explain" + words_of(column.names) + options.scene + options.bodies;
    if (scenes::names_trace(column.names[0])) return command;
    command += " --volume " + column.kind;
    // Of what is compared; else it is among what was given.
    std::string queries = options.queries_asked;
    if (overlap_test_of(options.compare.substr(0, options.compare.find(','))))
        queries +=
            " --test " + std::string(overlap_test_name(column.query->query().options.overlap.test));
    return command + options.hierarchies + queries;
}

}  // namespace

void ViewOptions::check() const {
    level.check();
    if (level.color_by == render::ColorBy::surface)
        throw InputError(
            "--color-by surface: these colors are of one level, and the page has all; give "
            "another, or draw pictures with `scb render levels`.");
    if (!level.picture.output.ends_with(".html"))
        throw InputError("-o " + level.picture.output +
                         ": the page is one HTML file; give a "
                         "name that ends in .html.");
    check_output(level.picture.output, "-o " + level.picture.output);
    if (steps < 0) throw InputError("--steps " + std::to_string(steps) + ": give 0 or more tests.");
}

std::string view_page(const ViewOptions& options, const Console& console) {
    const LevelOptions& asked = options.level;
    ViewSubject subject = view_subject({asked.scene,
                                        asked.hierarchy,
                                        options.query,
                                        options.queries,
                                        {options.compare, options.recording}},
                                       console);
    const std::vector<scenes::BodyAtFrame>& first = subject.columns[0].bodies;
    const scenes::Scene& first_scene = *subject.columns[0].scene;
    ViewStart start;
    start.level = first_level(subject, asked.levels);
    start.style = level_style(asked, first, subject.deepest);
    std::vector<render::LevelBody> bodies = level_bodies(first, {});
    const scenes::CameraView wish = camera_view_for(asked.camera, first_scene);
    std::vector<render::LevelBody> held = bodies;
    if (has_two_scenes(options))
        for (std::size_t k = 1; k < subject.columns.size(); ++k)
            for (render::LevelBody& body : level_bodies(subject.columns[k].bodies, {}))
                held.push_back(std::move(body));
    const render::Support support = render::support_of_levels(held, {start.level});
    start.aspect = render::aspect_of(asked.picture.layout().view);
    start.camera = camera_for(wish, support, start.aspect);
    start.center = render::center_of(support);
    start.up = wish.up.value_or(Vec3::UnitZ());
    start.commands = commands_of(options, subject);
    for (ViewColumn& column : subject.columns) column.explain = explain_command(options, column);

    std::string scene, titles;
    for (ViewColumn& column : subject.columns) {
        std::string name = scenes::printable(column.scene->name);
        if (column.bodies.size() == 2)
            name = scene_title(name, column.bodies[0].name, column.bodies[1].name);
        if (&column == &subject.columns.front()) scene = name;
        if (has_two_scenes(options)) column.title = name + ", " + column.title;
        titles += (titles.empty() ? "" : " | ") + column.title;
    }
    render::BlockStore store;
    render::WebPage page;
    page.title = (has_two_scenes(options) ? "" : scene + " · ") + scenes::printable(titles);
    page.description = format("%zu %s, %d levels, scb ", first.size(),
                              first.size() == 1 ? "body" : "bodies", subject.deepest + 1) +
                       SCB_VERSION;
    nlohmann::ordered_json manifest = view_manifest(subject, start, store);
    const auto queries =
        static_cast<std::size_t>(std::count_if(subject.columns.begin(), subject.columns.end(),
                                               [](const ViewColumn& c) { return c.query; }));
    for (std::size_t k = 0; k < subject.columns.size(); ++k)
        if (subject.columns[k].query)
            manifest["columns"][k]["query"] =
                view_query_json(subject.columns[k], subject.frames,
                                static_cast<std::size_t>(options.steps) / queries, store);
    page.manifest = manifest.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    page.still = still_of(asked, subject, start, std::move(bodies), page.title);
    return render::web_page(page, store);
}

}  // namespace scb::app
