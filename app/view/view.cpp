#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/command_text.h"
#include "app/cli/commands.h"
#include "app/cli/open_file.h"
#include "app/cli/version.h"
#include "app/pictures/level_bodies.h"
#include "app/pictures/level_options.h"
#include "app/query/level_list.h"
#include "app/query/output_guard.h"
#include "app/query/query_options.h"
#include "app/view/view_manifest.h"
#include "app/view/view_query.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "render/draw/renderer.h"
#include "render/figures/level_figure.h"
#include "render/files/image_file.h"
#include "render/files/output_file.h"
#include "render/overlay/overlay.h"
#include "render/web/web_page.h"
#include "scb/error.h"
#include "scenes/text/utf8.h"

namespace scb::app {
namespace {

/// How the page is asked for, but for what LevelOptions have.
struct ViewOptions {
    LevelOptions level;
    QueryOptions query;
    std::string queries = "auto";  ///< frames, auto or none
    // As given_text has it, what was given: of the scene, the volumes, other things of hierarchies
    // that all pictures take, and of levels alone.
    std::string scene, volumes, hierarchies, levels;

    void check() const {
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
    }
};

/// The deepest level of which a reader can still tell the volumes.
int first_level(const LevelSubject& subject, const std::string& asked) {
    if (asked != "auto") return std::max(0, parse_level(asked, subject.deepest));
    constexpr std::size_t most = 500;
    int level = 0;
    for (int next = 1; next <= subject.deepest; ++next) {
        std::size_t count = 0;
        for (const scenes::BodyAtFrame& body : subject.trees[0].bodies)
            count += level_cover(body.tree->shape(), next).size();
        if (count > most * subject.trees[0].bodies.size()) break;
        level = next;
    }
    return level;
}

/// What a browser shows that cannot draw.
std::vector<std::uint8_t> still_of(const LevelOptions& options, const LevelSubject& subject,
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

/// The queries of each kind, where there are two bodies; else none.
nlohmann::ordered_json queries_of(const ViewOptions& options, const LevelSubject& subject,
                                  render::BlockStore& store) {
    nlohmann::ordered_json queries = nlohmann::ordered_json::array();
    if (options.queries == "none") return queries;
    if (subject.scene.bodies.size() != 2) {
        if (options.queries != "auto")
            throw InputError("--queries " + options.queries +
                             ": the scene has no two bodies, and so no query; leave it out.");
        return queries;
    }
    if (subject.recorded && options.queries != "auto")
        throw InputError("--queries " + options.queries +
                         ": of a recording the page has the query of one frame; name that with "
                         "--frames.");
    for (const LevelTrees& kind : subject.trees) {
        QueryOptions query = options.query;
        query.frames = options.queries == "auto" ? std::to_string(subject.frame) : options.queries;
        HierarchyOptions hierarchy = options.level.hierarchy;
        if (!subject.recorded) hierarchy.volumes = kind.name;
        try {
            QuerySource source(options.level.scene, hierarchy, query, {}, subject.recorded);
            queries.push_back(view_query_json(source, kind, store));
        } catch (const InputError&) {
            // A recording may have no query at this frame.
            if (!subject.recorded) throw;
        }
    }
    return queries;
}

int run(const ViewOptions& options, const Console& console) {
    options.check();
    const LevelOptions& asked = options.level;
    const LevelSubject subject =
        level_subject(asked.scene, asked.hierarchy, "all", asked.recording, console);
    const std::vector<scenes::BodyAtFrame>& first = subject.trees[0].bodies;
    constexpr int most_frames = 20'000;
    if (subject.scene.frames > most_frames && !subject.recorded && subject.scene.listed.empty())
        throw InputError("the scene has " + std::to_string(subject.scene.frames) +
                         " frames; a page holds the poses of 20,000 at most.");
    ViewStart start;
    start.level = first_level(subject, asked.levels);
    start.style = level_style(asked, first, subject.deepest);
    std::vector<render::LevelBody> bodies = level_bodies(first, {});
    const scenes::CameraView wish = camera_view_for(asked.camera, subject.scene);
    const render::Support support = render::support_of_levels(bodies, {start.level});
    start.aspect = render::aspect_of(asked.picture.layout().view);
    start.camera = camera_for(wish, support, start.aspect);
    start.center = render::center_of(support);
    start.up = wish.up.value_or(Vec3::UnitZ());
    start.commands["levels"] = "scb render levels" + options.scene + options.volumes +
                               options.hierarchies + options.levels;
    const std::size_t kinds_count = subject.trees.size();
    if (kinds_count <= 2)
        for (const auto& [mode, picture] : {std::pair{"rejections", "rejections"},
                                            {"pairs", "pairs"},
                                            {"tests", "pairs --heat volumes"},
                                            {"wasted", "pairs --heat wasted"},
                                            {"traversal", "traversal"}})
            start.commands[mode] =
                std::string("scb render ") + picture + options.scene +
                (kinds_count == 1 ? options.volumes : " --compare " + asked.hierarchy.volumes) +
                options.hierarchies;

    const std::string scene = scenes::printable(subject.scene.name);
    std::string kinds;
    for (const LevelTrees& kind : subject.trees) kinds += (kinds.empty() ? "" : ", ") + kind.title;
    render::BlockStore store;
    render::WebPage page;
    page.title = scene + " · " + scenes::printable(kinds);
    page.description = format("%zu %s, %d levels, scb ", first.size(),
                              first.size() == 1 ? "body" : "bodies", subject.deepest + 1) +
                       SCB_VERSION;
    nlohmann::ordered_json manifest = view_manifest(subject, start, store);
    manifest["queries"] = queries_of(options, subject, store);
    page.manifest = manifest.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    page.still = still_of(asked, subject, start, std::move(bodies), page.title);
    const std::string html = render::web_page(page, store);
    check_output(asked.picture.output, "-o " + asked.picture.output);
    render::write_file_whole(asked.picture.output, html);
    print_result(asked.picture.output + "\n");
    console.note("scb: " + asked.picture.output + ": " +
                 format("%.1f MB.", static_cast<double>(html.size()) / 1e6));
    if (asked.picture.open) open_file(asked.picture.output, console);
    return exit_done;
}

}  // namespace

void add_view(const Command& program, const Console& console, Action& action) {
    const Command command = program.add_subcommand(
        "view", "Make one HTML file that any browser opens: turn, ask, go from level to level");
    const auto options = std::make_shared<ViewOptions>();
    LevelOptions& level = options->level;
    level.picture.output = "view.html";
    add_scene_options(command, level.scene, true);
    add_hierarchy_options(command, level.hierarchy);
    command
        .add_option("--level", level.levels,
                    "The level that is shown first; auto: the deepest with 500 volumes a body")
        .type_name("LEVEL")
        .show_default();
    command
        .add_option("--queries", options->queries,
                    "Frames whose query is in the page, test by test: a list, all, none; auto: "
                    "the frame that is shown first. Of scenes with two bodies")
        .type_name("FRAMES")
        .show_default();
    add_overlap_options(command, options->query, false);
    add_page_options(command, level.picture, level.camera, "The page");
    add_level_look(command, level);
    command.footer(
        "The page has the hierarchies, the meshes and the poses of all frames in it, and fetches "
        "nothing. Its volumes are drawn\n"
        "by the shaders of the pictures, in the same colors; what is shown is in its address, so "
        "that a link opens the same view.\n\n"
        "Examples:\n"
        "  scb view spheres-l1 -o spheres.html\n"
        "  scb view part.stl --volume scb2,obb --level 6 --color-by thickness -o part.html");
    command.callback([&action, &console, command, options] {
        options->level.recording = given_hierarchy_options(command);
        options->scene = given_text(command, {"SCENE", "--pose", "--models"});
        options->volumes = given_text(command, {"--volume"});
        options->hierarchies = given_text(
            command, {"--growth", "--margin", "--split", "--test", "--threshold", "--up"});
        options->levels = given_text(command, {"--color-by"});
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
