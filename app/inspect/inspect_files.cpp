#include "app/inspect/inspect_files.h"

#include <nlohmann/json.hpp>
#include <set>

#include "app/cli/progress.h"
#include "app/explain/explain_report.h"
#include "app/inspect/inspect_bodies.h"
#include "app/inspect/inspect_csv.h"
#include "app/inspect/inspect_page.h"
#include "app/inspect/inspect_triangles.h"
#include "app/inspect/recording_pictures.h"
#include "app/report/scene_report.h"
#include "core/platform/number_list.h"
#include "scb/error.h"
#include "scenes/recordings/recording_input.h"

namespace scb::app {
namespace {

/// Sets the file names of the report, with the options that affect it.
void name_files(InspectedQueries& inspected, const InspectOptions& options) {
    const InspectOptions usual;
    InspectReport& report = inspected.report;
    report.stem = options.scene.file_stem(report.header.scene);
    report.named = {};
    report.named_frames = {};
    std::size_t all = 0;
    if (!inspected.sources.empty()) {
        const QuerySource& source = inspected.sources.front();
        name_query(report.named, source, source);
        all = inspected.file ? inspected.file->summary.frames.size()
                             : static_cast<std::size_t>(source.query().scene.frames);
    }
    name_picture(report.named, options.picture);
    if (all != 0 && inspected.frames.size() != all)
        name_frames(report.named_frames, inspected.frames);
    NamedOptions of_page;
    of_page.add_if(options.top != usual.top, "top", std::to_string(options.top));
    of_page.add_if(options.time, "time");
    report.files = inspect_name(report, of_page);
}

/// The page of `scb view` with the frames of the pairs in the report; without pairs, the worst
/// frame.
std::string report_view(const InspectOptions& options, const InspectReport& report,
                        const Console& console) {
    std::set<int> frames;
    for (const WorstOfReason& worst : report.worst)
        for (const FalsePair& pair : worst.pairs) frames.insert(pair.frame);
    for (const WronglyRejectedPair& pair : report.wrong) frames.insert(pair.frame);
    if (frames.empty()) frames.insert(report.frames.front().frame);
    ViewOptions view = options.view;
    view.level.scene = options.scene;
    view.level.hierarchy = options.hierarchy;
    view.level.picture.background = options.picture.background;
    view.level.picture.gl = options.picture.gl;
    view.query = options.query;
    view.kind = options.kind;
    view.level.recording = options.recording;
    if (report.recording) {
        // The page has one frame of a recording, and one pair of bodies.
        view.query.bodies = report.header.bodies[0].name + "," + report.header.bodies[1].name;
        view.level.scene.frames = std::to_string(report.frames.front().frame);
        return view_page(view, console);
    }
    view.queries = list_text({frames.begin(), frames.end()});
    if (!scenes::names_trace(options.scene.names[0]))
        view.level.scene.frames = std::to_string(*frames.begin());
    return view_page(view, console);
}

/// Draws the pictures of the waste, writes its tables, and makes the page `view` of `scb view`.
/// Returns whether everything was drawn.
bool write_waste(PictureRun& pictures, const InspectedQueries& inspected, InspectPage& page,
                 std::string& view, const InspectOptions& options, const ExplainedPairs& explained,
                 const Console& console, const InterruptWatch& watch) {
    const InspectReport& report = inspected.report;
    std::size_t pairs = report.wrong.size();
    for (const WorstOfReason& worst : report.worst) pairs += worst.pairs.size();
    if (is_of_distance(report.header.kind)) pairs = 0;
    Progress progress(console, 2 + pairs);
    const auto step = [&] {
        progress.step("pictures");
        return watch.signal() == 0;
    };
    const QuerySource& source = inspected.sources.front();
    if (!draw_inspection(pictures, options.picture, source, report, explained, step)) return false;
    page.bodies = draw_bodies(pictures, options.picture, inspected.sources, report);
    if (!step()) return false;
    pictures.write(report.files + "_frames.csv", frames_csv(report));
    pictures.write(report.files + "_pairs.csv", pairs_csv(report));
    const Table triangles = triangles_table(report);
    pictures.write(report.files + "_triangles.csv", triangles.csv_header() + triangles.csv_rows());
    // The page of `scb view` needs whole queries.
    const bool all = inspected.file || (source.query().options.stop_level < 0 &&
                                        options.limits.max_pairs == QueryLimits{}.max_pairs);
    if (!all || options.no_view) return true;
    // That page has queries for the smallest distance only, and none of a recording.
    if (report.header.kind == QueryKind::within ||
        (inspected.file && is_of_distance(report.header.kind)))
        return true;
    if (!inspected.file && source.query().is_self()) {
        console.note("scb: there is no page of `scb view`, which shows queries of two bodies.");
        return true;
    }
    try {
        view = report_view(options, report, console);
        page.view = report.files + "_view.html";
    } catch (const InputError& error) {
        console.note("scb: there is no page of `scb view`: " + std::string(error.what()));
    }
    return true;
}

}  // namespace

void begin_pictures(std::optional<PictureRun>& pictures, InspectedQueries& inspected,
                    const InspectOptions& options) {
    name_files(inspected, options);
    const std::string& files = inspected.report.files;
    pictures.emplace(
        options.picture,
        inspected.file ? scenes::file_name_of(inspected.report.header.engine->name)
                       : inspected.sources.front().scene().name,
        std::vector<std::string>{files + ".html", files + "_view.html", files + "_frames.csv",
                                 files + "_pairs.csv", files + "_triangles.csv"});
}

bool write_report(PictureRun& pictures, InspectedQueries& inspected, const InspectOptions& options,
                  const ExplainedPairs& explained, const Console& console,
                  const InterruptWatch& watch) {
    InspectReport& report = inspected.report;
    InspectPage page;
    page.summary = inspect_name(report) + ".png";
    page.width = options.picture.width();
    page.height = options.picture.height();
    page.light = options.picture.theme() == &render::light_theme;
    page.command = options.command;
    page.explain = options.explain;
    if (inspected.file && inspected.recording)
        report.recording->pictures = draw_problems(pictures, options.picture, *inspected.recording,
                                                   report.recording->judged);
    report.drawn = report.has_waste && !is_of_distance(report.header.kind);
    std::string view;
    if (report.has_waste &&
        !write_waste(pictures, inspected, page, view, options, explained, console, watch)) {
        report.drawn = false;
        return false;
    }
    pictures.write(report.files + ".html", inspect_html(report, page));
    if (!page.view.empty()) pictures.write(page.view, view);
    const nlohmann::ordered_json json = inspect_json(report);
    if (options.picture.json)
        pictures.print_instead(json_text(json, 2) + "\n");
    else
        pictures.say(inspect_text(report, options.full));
    nlohmann::ordered_json head = {{"command", "inspect"}};
    head.update(json);
    if (!inspected.file)
        head["poses"] = poses_json(inspected.sources.front().query().scene, inspected.frames);
    pictures.finish(std::move(head), console);
    return true;
}

}  // namespace scb::app
