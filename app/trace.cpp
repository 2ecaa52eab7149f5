#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>

#include "app/commands.h"
#include "app/count_table.h"
#include "app/exit_status.h"
#include "app/interrupt.h"
#include "app/number_list.h"
#include "app/progress.h"
#include "app/scene_query.h"
#include "app/trace_input.h"
#include "app/trace_report.h"
#include "core/error.h"
#include "render/image_file.h"
#include "scenes/utf8.h"

namespace scb {
namespace {

struct Options {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    QueryOptions query;
    std::int64_t max_pairs = 100'000'000;
    std::optional<int> level;
    bool json = false, events = false;
    std::string output;
};

TraceHeader header_of(const Options& options, const SceneQuery& query, VolumeKind kind) {
    TraceHeader header;
    header.scb_version = SCB_VERSION;
    for (const std::string& name : options.scene.names) header.source.push_back(as_utf8(name));
    header.scene = query.scene.name;
    for (std::size_t side = 0; side < 2; ++side) {
        const std::size_t body = side == 0 ? query.a : query.b;
        header.bodies[side] = {query.scene.bodies[body].name, fingerprint(query.mesh(body))};
    }
    const FitOptions fit = options.hierarchy.fit();
    header.volume = kind;
    header.growth = fit.growth;
    header.margin = fit.margin;
    header.options = query.options;
    return header;
}

int record(const Options& options, const Console& console) {
    if (options.output.empty())
        throw InputError("there is nowhere to write the trace; give -o FILE.scbtrace.");
    if (options.json || options.events)
        throw InputError(std::string(options.json ? "--json" : "--events") +
                         " prints a trace that exists; record it first, then give its file.");
    if (options.max_pairs < 1)
        throw InputError("--max-pairs " + std::to_string(options.max_pairs) + ": give at least 1.");
    const VolumeKind kind = options.hierarchy.kind();
    SceneQuery query = open_query(options.scene, options.hierarchy, options.query, kind, console);
    const std::vector<int> frames =
        parse_frames(options.query.frames, query.scene.frames, query.scene.name);
    const int deepest_level = deepest(query.topologies);
    if (options.level && (*options.level < 0 || *options.level > deepest_level))
        throw InputError("--level " + std::to_string(*options.level) +
                         ": this scene's hierarchies have the levels 0 to " +
                         std::to_string(deepest_level) + "; give one of these.");
    query.options.max_pairs = static_cast<std::size_t>(options.max_pairs);
    query.options.stop_level = options.level.value_or(-1);
    warn_of_printed(options.query, console);

    const InterruptWatch watch;
    TraceWriter writer(header_of(options, query, kind));
    Progress progress(console, frames.size());
    std::size_t done = 0;
    std::uint64_t tests = 0;
    EventRecorder recorder;
    for (; done < frames.size() && watch.signal() == 0; ++done) {
        recorder.events.volume_tests.clear();
        recorder.events.triangle_tests.clear();
        TraceFrame frame{frames[done], query.b_to_a(frames[done]), {}, {}};
        frame.found = query.collide(frame.frame, recorder);
        std::swap(frame.events, recorder.events);
        writer.add(frame);
        tests += frame.found.n_v;
        std::swap(frame.events, recorder.events);
        progress.step("frames");
    }
    if (done > 0) {
        const std::vector<std::uint8_t> bytes = writer.finish();
        write_file_whole(options.output, bytes);
        console.note("scb: " + options.output + ": " + std::to_string(done) +
                     (done == 1 ? " frame, " : " frames, ") + std::to_string(tests) +
                     " volume tests, " + std::to_string(bytes.size()) + " bytes.");
    }
    if (watch.signal() == 0) return exit_done;
    console.note("scb: interrupted; " + std::to_string(done) + " of " +
                 std::to_string(frames.size()) + " frames are in the trace.");
    return 128 + watch.signal();
}

/// The frames that were asked for, ascending; all of them where nothing was.
std::vector<int> chosen_frames(const Options& options) {
    const std::string& path = options.scene.names[0];
    TraceInput input(path);
    std::vector<int> all;
    while (const TraceFrame* frame = input.reader.next()) all.push_back(frame->frame);
    if (options.query.frames == "all" || all.empty()) return all;
    const std::vector<int> wanted =
        parse_frames(options.query.frames, all.back() + 1, input.reader.header().scene);
    for (const int frame : wanted)
        if (!std::binary_search(all.begin(), all.end(), frame))
            throw InputError("--frames " + options.query.frames + ": " + path + " has no frame " +
                             std::to_string(frame) + "; it has " + std::to_string(all.size()) +
                             " from " + std::to_string(all.front()) + " to " +
                             std::to_string(all.back()) + ".");
    return wanted;
}

int print(const Options& options) {
    const std::string& path = options.scene.names[0];
    if (!options.output.empty())
        throw InputError(path + " is a trace already; give a scene to record, or leave out -o.");
    // Reads all frames once before anything is printed, so that a bad file gives no half answer.
    const std::vector<int> wanted = chosen_frames(options);
    TraceInput input(path);
    const TraceHeader& header = input.reader.header();
    std::vector<Stage> stages = counted_stages(header.volume, header.options.overlap);
    // The sixteen of boxes make no table.
    if (!options.json && stages.size() > 8) stages.clear();
    const std::string table_header = count_table_header(stages);
    if (options.json) {
        std::string start = trace_header_json(header).dump(
            2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
        start.erase(start.size() - 2);  // the brace that closes it
        print_result(start + ",\n  \"frames\": [");
    } else {
        print_result(trace_header_text(header) + "\n" + (options.events ? "" : table_header));
    }
    std::size_t printed = 0;
    while (const TraceFrame* frame = input.reader.next()) {
        if (!std::binary_search(wanted.begin(), wanted.end(), frame->frame)) continue;
        if (options.json) {
            nlohmann::ordered_json row = count_json(frame->frame, frame->found, stages);
            if (options.events) row["tests"] = trace_events_json(header, *frame);
            print_result((printed == 0 ? "\n    " : ",\n    ") + row.dump());
        } else {
            const std::string row = count_table_row(frame->frame, frame->found, stages);
            print_result(options.events ? (printed == 0 ? "" : "\n") + table_header + row + "\n" +
                                              trace_events_text(header, *frame)
                                        : row);
        }
        ++printed;
    }
    if (options.json) print_result("\n  ]\n}\n");
    return exit_done;
}

}  // namespace

void add_trace(CLI::App& program, const Console& console, Action& action) {
    CLI::App* command = program.add_subcommand(
        "trace", "Record every test of collision queries to a file, or print such a file");
    const auto options = std::make_shared<Options>();
    add_scene_options(*command, options->scene, false);
    add_hierarchy_options(*command, options->hierarchy, false);
    add_query_options(*command, options->query, false);
    command->add_option("--max-pairs", options->max_pairs, "End a query at this many pairs")
        ->type_name("K")
        ->capture_default_str();
    command
        ->add_option("--level", options->level,
                     "Stop at this level: pairs of nodes, and no triangle tests")
        ->type_name("K");
    command->add_option("-o,--output", options->output, "Write the trace to this file")
        ->type_name("FILE.scbtrace");
    command->add_flag("--events", options->events, "Print every test of the trace");
    command->add_flag("--json", options->json, "Print the trace as JSON");
    command->footer(
        "A scene is recorded to -o FILE; in place of SCENE, such a file is printed: what was "
        "asked, "
        "then the counts\n"
        "of every frame. Parents are numbers of tests. Ctrl-C leaves the frames that were "
        "finished, and exits with 130.\n\n"
        "Examples:\n"
        "  scb trace spheres-l1 --frames 0:499:50 -o spheres.scbtrace\n"
        "  scb trace spheres.scbtrace --frames 250 --events");
    command->callback([&action, &console, options] {
        action = [&console, options] {
            const std::vector<std::string>& names = options->scene.names;
            return names.size() == 1 && names_trace(names[0]) ? print(*options)
                                                              : record(*options, console);
        };
    });
}

}  // namespace scb
