#include "app/view/view_page.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/command_text.h"
#include "app/cli/progress.h"
#include "app/cli/version.h"
#include "app/pictures/level_bodies.h"
#include "app/query/output_guard.h"
#include "app/query/recording_verdict.h"
#include "app/report/scene_report.h"
#include "app/study/scene_setup.h"
#include "app/view/view_commands.h"
#include "app/view/view_manifest.h"
#include "app/view/view_query.h"
#include "core/base/text_format.h"
#include "core/platform/utf8.h"
#include "render/draw/renderer.h"
#include "render/figures/level_figure.h"
#include "render/files/image_file.h"
#include "render/overlay/overlay.h"
#include "render/view/palette.h"
#include "render/web/web_page.h"
#include "scb/error.h"
#include "scenes/recordings/recording_input.h"

namespace scb::app {
namespace {

/// The deepest level whose volumes are still few enough to be told apart.
int first_level(const ViewSubject& subject, const std::string& asked) {
    if (asked != "auto") {
        const int level = parse_level(asked, subject.deepest, "--level");
        return level == leaf_level ? subject.deepest : level;
    }
    constexpr std::size_t most = 500;
    int level = 0;
    for (int next = 1; next <= subject.deepest; ++next) {
        std::size_t count = 0;
        for (const BodyAtFrame& body : subject.columns[0].bodies)
            count += level_cover(body.tree->shape(), next).size();
        if (count > most * subject.columns[0].bodies.size()) break;
        level = next;
    }
    return level;
}

/// The picture for browsers that cannot draw the page.
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

/// The verdict on one frame of a recording, with the frame's number.
std::vector<std::string> verdict_of(const SceneOptions& scene, int frame) {
    std::vector<std::string> lines = verdict_lines(scenes::judge_recording(
        *scene.recording_file(), [frame](int number) { return number == frame; },
        [](bool) { return true; }));
    lines.front() = "Frame " + std::to_string(frame) + ": " + lines.front();
    return lines;
}

}  // namespace

void ViewOptions::note_given(const Command& command) {
    scene = given_text(command, {"--pose", "--poses", "--models"});
    bodies = given_text(command, query.distance
                                     ? std::vector<std::string>{"--bodies"}
                                     : std::vector<std::string>{"--bodies", "--query", "--tag"});
    hierarchies = given_text(command, {"--growth", "--margin", "--split"});
    tests = given_text(command, {"--test", "--threshold"});
    of_packed = given_text(command, {"SCENE", "--pose", "--poses", "--models", "--bodies",
                                     "--volume", "--growth", "--margin", "--split"});
    layout = given_text(command, {"--layout", "--leaf"});
    has_theme = !given_text(command, {"--background"}).empty();
}

bool ViewOptions::has_two_scenes() const {
    const std::vector<std::string>& names = level.scene.names;
    return names.size() == 2 && std::all_of(names.begin(), names.end(), scenes::names_scene);
}

void ViewOptions::check() const {
    if (!level.picture.output.ends_with(".html"))
        throw InputError("-o " + level.picture.output +
                         ": the page is one HTML file; give a "
                         "name that ends in .html.");
    level.check();
    if (level.color_by == render::ColorBy::surface)
        throw InputError(
            "--color-by surface: these colors are of one level, and the page has all; give "
            "another, or draw pictures with `scb render levels`.");
    check_output(level.picture.output, "-o");
    if (steps < 0) throw InputError("--steps " + std::to_string(steps) + ": give 0 or more tests.");
}

std::string view_page(const ViewOptions& options, const Console& console) {
    const LevelOptions& asked = options.level;
    ViewSubject subject;
    try {
        subject = view_subject({asked.scene,
                                asked.hierarchy,
                                options.query,
                                options.queries,
                                {options.compare, asked.recording}},
                               console.notes());
    } catch (const InputError& error) {
        // Here, the option of the queries' frames is --queries.
        const std::string frames = "--frames " + options.queries + ":", text = error.what();
        if (options.queries == "auto" || !text.starts_with(frames)) throw;
        throw InputError("--queries" + text.substr(std::string_view("--frames").size()));
    }
    const std::vector<BodyAtFrame>& first = subject.columns[0].bodies;
    const scenes::Scene& first_scene = *subject.columns[0].scene;
    ViewStart start;
    start.level = first_level(subject, asked.levels);
    start.style = level_style(asked, first, subject.deepest);
    std::vector<render::LevelBody> bodies = level_bodies(first, {});
    const scenes::CameraView wish = camera_view_for(asked.camera, first_scene);
    std::vector<render::LevelBody> held = bodies;
    if (options.has_two_scenes())
        for (std::size_t k = 1; k < subject.columns.size(); ++k)
            for (render::LevelBody& body : level_bodies(subject.columns[k].bodies, {}))
                held.push_back(std::move(body));
    const render::Support support = render::support_of_levels(held, {start.level});
    start.aspect = render::aspect_of(asked.picture.layout().view);
    start.camera = camera_for(wish, support, start.aspect);
    start.center = render::center_of(support);
    start.up = wish.up.value_or(Vec3::UnitZ());
    start.commands = view_commands(options, subject);
    for (ViewColumn& column : subject.columns) {
        column.explain = explain_command(options, column);
        const bool in_memory = asked.scene.recorded != nullptr;
        if (!column.is_recorded() || (!in_memory && !scenes::names_recording(column.scene->file)))
            continue;
        SceneOptions of_column = asked.scene;
        if (!in_memory) of_column.names = {column.scene->file.string()};
        column.verdict = verdict_of(of_column, subject.frame);
    }

    std::string scene, titles;
    for (ViewColumn& column : subject.columns) {
        std::string name = printable(column.scene->name);
        if (column.bodies.size() == 2)
            name = scene_title(name, column.bodies[0].name, column.bodies[1].name);
        if (&column == &subject.columns.front()) scene = name;
        if (options.has_two_scenes()) column.title = name + ", " + column.title;
        titles += (titles.empty() ? "" : " | ") + column.title;
    }
    render::BlockStore store;
    render::WebPage page;
    page.title = (options.has_two_scenes() ? "" : scene + " · ") + printable(titles);
    page.description = counted(first.size(), "body", "bodies") + ", " +
                       counted(static_cast<std::uint64_t>(subject.deepest + 1), "level", "levels") +
                       ", scb " SCB_VERSION;
    if (options.has_theme) page.theme = start.style.theme == &render::dark_theme ? "dark" : "light";
    nlohmann::ordered_json manifest = view_manifest(subject, start, store);
    const auto queries =
        static_cast<std::size_t>(std::count_if(subject.columns.begin(), subject.columns.end(),
                                               [](const ViewColumn& c) { return c.query; }));
    std::size_t frames = 0;
    for (const ViewColumn& column : subject.columns)
        if (column.query) frames += column.query->frames().size();
    Progress progress(console, frames);
    const auto step = [&progress] { progress.step("queries"); };
    for (std::size_t k = 0; k < subject.columns.size(); ++k)
        if (subject.columns[k].query)
            manifest["columns"][k]["query"] =
                view_query_json(subject.columns[k], subject.frames,
                                static_cast<std::size_t>(options.steps) / queries, store, step);
    page.manifest = manifest.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    page.still = still_of(asked, subject, start, std::move(bodies), page.title);
    return render::web_page(page, store);
}

}  // namespace scb::app
