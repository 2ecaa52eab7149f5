#include <memory>

#include "app/commands.h"
#include "app/exit_status.h"
#include "app/inspect_report.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "app/query_source.h"
#include "core/error.h"

namespace scb {
namespace {

struct Options {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    QueryOptions query;
    QueryLimits limits;
    std::vector<std::string> recording;  ///< see given_recording_options
    std::optional<int> frame;
    int top = 10;
    bool json = false;

    void check() {
        hierarchy.kind();
        hierarchy.fit();
        query.collide();
        if (top < 1 || top > 10000)
            throw InputError("--top " + std::to_string(top) + ": give 1 to 10000 pairs.");
        for (const std::string& name : scene.names)
            if (names_trace(name)) refuse_for_trace(recording, name);
        if (frame) query.frames = std::to_string(*frame);
    }
};

int run(Options& options, const Console& console) {
    options.check();
    QuerySource source(options.scene, options.hierarchy, options.query, options.limits);
    const SceneQuery& query = source.query();
    note_doubts(options.scene, options.query, {query.kind}, console);
    const AnyHierarchy &a = query.hierarchy(query.a), &b = query.hierarchy(query.b);
    const Mesh &mesh_a = query.mesh(query.a), &mesh_b = query.mesh(query.b);

    InspectReport report;
    report.header = source.header();
    const auto top = static_cast<std::size_t>(options.top);
    WorstPairs weak_tests(PassReason::weak_test, top), loose_fits(PassReason::loose_fit, top);
    for (const OverlapOptions& other : other_tests(report.header)) {
        report.others.emplace_back();
        report.others.back().overlap = other;
    }
    const InterruptWatch watch;
    Progress progress(console, source.frames().size());
    for (const int number : source.frames()) {
        if (watch.signal() != 0) break;
        const TraceFrame& frame = source.frame(number);
        const TestTree tree = test_tree(report.header, frame);
        const Attribution attribution =
            attribute(a, b, report.header, frame, tree,
                      all_contacts(a, mesh_a, b, mesh_b, report.header, frame));
        report.frames.push_back({number, inspection(frame, tree, attribution)});
        for (const std::uint32_t test : attribution.wrongly_rejected)
            if (report.wrong.size() < top)
                report.wrong.push_back({number, frame.events.volume_tests[test]});
        weak_tests.add(frame, attribution);
        loose_fits.add(frame, attribution);
        for (OtherTest& other : report.others)
            other.add(try_other_test(a, mesh_a, b, mesh_b, report.header, frame, attribution,
                                     other.overlap));
        progress.step("frames");
    }
    report.weak_tests = weak_tests.pairs();
    report.loose_fits = loose_fits.pairs();
    for (const InspectedFrame& frame : report.frames) report.sum += frame.found;
    sort_by_waste(report.frames);
    print_result(options.json ? inspect_json(report).dump(
                                    2, ' ', false, nlohmann::json::error_handler_t::replace) +
                                    "\n"
                              : inspect_text(report));
    if (watch.signal() != 0) {
        console.note("scb: interrupted; " + std::to_string(report.frames.size()) + " of " +
                     std::to_string(source.frames().size()) + " frames were inspected.");
        return exit_interrupted(watch.signal());
    }
    if (report.sum.counts.wrongly_rejected > 0) {
        console.alarm("scb: the test rejected " +
                      std::to_string(report.sum.counts.wrongly_rejected) +
                      " pairs of volumes that overlap; collisions may be missing.");
        return exit_different;
    }
    return exit_done;
}

}  // namespace

void add_inspect(CLI::App& program, const Console& console, Action& action) {
    CLI::App* command = program.add_subcommand(
        "inspect", "Which pairs passed the overlap test that should not have, and what that cost");
    const auto options = std::make_shared<Options>();
    add_scene_options(*command, options->scene, false);
    command->get_option("SCENE")->description(
        "A built-in scene (see `scb scenes`), a scene file, two mesh files, or a trace (see `scb "
        "trace`)");
    add_hierarchy_options(*command, options->hierarchy, false);
    add_query_options(*command, options->query, false);
    add_query_limits(*command, options->limits);
    CLI::Option* frames = command->get_option("--frames");
    command->add_option("--frame", options->frame, "One frame")
        ->check(decimal_number())
        ->excludes(frames)
        ->type_name("N");
    command
        ->add_option("--top", options->top, "How many of the worst pairs to list, of each reason")
        ->check(decimal_number())
        ->type_name("K")
        ->capture_default_str();
    command->add_flag("--json", options->json, "Print JSON");
    command->footer(
        "A pair of nodes passes the test for one of three reasons: triangles below it intersect "
        "(true); its volumes\n"
        "meet, but no triangles do (fit: the volumes are too loose); or not even the volumes meet "
        "(test: too weak).\n"
        "What it led to is wasted but in the first case. The volumes are decided exactly, each "
        "verdict with a proof.\n"
        "Exit status 1 where the test rejected volumes that overlap, as --test printed does.\n\n"
        "Examples:\n"
        "  scb inspect spheres-l1 --frames 0:499:50\n"
        "  scb inspect knots-l1 --frame 0 --top 20 --json");
    command->callback([&action, &console, command, options] {
        options->recording = given_recording_options(*command);
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb
