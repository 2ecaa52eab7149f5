#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/query/distance_options.h"
#include "app/query/layout_options.h"
#include "app/query/output_guard.h"
#include "app/query/query_options.h"
#include "app/report/count_table.h"
#include "app/report/trace_report.h"
#include "app/study/query_source.h"
#include "app/study/recorded_query.h"
#include "app/study/scene_query.h"
#include "core/analysis/trace_words.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "core/platform/number_list.h"
#include "core/platform/output_file.h"
#include "core/platform/utf8.h"
#include "scb/error.h"
#include "scenes/recordings/recording_input.h"
#include "scenes/recordings/test_input.h"
#include "scenes/recordings/trace_recording.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

struct TraceOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy;
    QueryOptions query;
    QueryLimits limits;
    LayoutOptions layout;
    KindOptions kind;
    bool first = false;
    bool json = false, events = false, records = false;
    std::string output;
};

int record(const TraceOptions& options, const Console& console) {
    if (options.output.empty()) {
        options.scene.load();  // throws if there is no such scene
        throw InputError("there is nowhere to write the trace; give -o FILE.scbrec.");
    }
    if (options.json || options.events)
        throw InputError(std::string(options.json ? "--json" : "--events") +
                         " prints a trace that exists; record it first, then give its file.");
    if (options.output.ends_with(".scbtrace"))
        throw InputError("-o " + options.output +
                         ": only scb 1.0 wrote such files; name a file .scbrec.");
    if (const std::filesystem::path output = options.output;
        output.has_extension() && output.extension() != ".scbrec")
        throw InputError("-o " + options.output + ": a trace is a .scbrec file; name it so.");
    const std::optional<PackedLayout> layout =
        options.layout.packed(options.hierarchy, options.query, options.limits);
    // A compact trace is read beside the binary hierarchies of its scene.
    const bool records = options.records || layout;
    // A trace names its recording, which is opened again without a selection.
    if (!records && !options.scene.selection.empty())
        throw InputError(options.scene.selection.words() +
                         ": a trace does not keep the selection; add --records, which writes the "
                         "meshes and poses, too.");
    check_output(options.output, "-o");
    SceneQuery query = open_query(options.scene, options.hierarchy, options.query, options.limits);
    check_output(options.output, "-o");
    note_doubts(options.hierarchy, {query.kind}, console.notes());
    note_doubts(options.scene, query.scene, options.query, {query.kind}, console.notes());
    options.layout.note_doubts(console.notes());
    if (layout) {
        options.layout.pack(query, *layout);
        query.trace_packed();
    }

    const InterruptWatch watch;
    std::optional<scenes::TraceWriter> trace;
    std::optional<scenes::TraceRecording> recording;
    if (records)
        recording.emplace(recording_of(options.scene, query, layout ? options.layout.layout : ""));
    else
        trace.emplace(trace_header(options.scene, query));
    Progress progress(console, query.frames.size());
    std::size_t done = 0;
    std::uint64_t tests = 0;
    for (; done < query.frames.size() && watch.signal() == 0; ++done) {
        QueryTrace frame = traced_query(query, query.frames[done]);
        if (frame.nearest) frame.rounding = query.rounding(frame.frame);
        if (recording)
            recording->add(frame, query.poses(frame.frame));
        else
            trace->add(frame);
        tests += frame.found.n_v;
        progress.step("frames");
    }
    if (done > 0) {
        std::string bytes;
        if (recording) {
            bytes = recording->finish();
        } else {
            const std::vector<std::uint8_t> compact = trace->finish();
            bytes.assign(compact.begin(), compact.end());
        }
        write_file_whole(options.output, bytes);
        console.note("scb: " + options.output + ": " + counted(done, "frame", "frames") + ", " +
                     counted(tests, "volume test", "volume tests") + ", " +
                     counted(bytes.size(), "byte", "bytes") + ".");
    }
    if (done == query.frames.size()) return exit_done;
    console.note(done == 0 ? "scb: interrupted before the first frame; no trace was written."
                           : "scb: interrupted; " + std::to_string(done) + " of " +
                                 std::to_string(query.frames.size()) + " frames are in the trace.");
    return exit_interrupted(watch.signal());
}

// Prints the text once it is long enough, and clears it.
void print_block(std::string& text) {
    constexpr std::size_t block = std::size_t{1} << 16;
    if (text.size() < block) return;
    print_result(text);
    text.clear();
}

/// Throws InputError without --within.
void ask_for_first(QueryOptions& query) {
    if (!query.distance || !query.distance->within) throw InputError("--first needs --within T.");
    query.distance = {query.distance->up_to_first(), std::nullopt};
}

/// The width of node columns: engines may have large numbers.
int number_width(const QueryTrace& frame) {
    std::uint32_t most = 0;
    for (const std::shared_ptr<const Tree>& tree : frame.trees)
        for (std::uint32_t node = 0; tree && node < tree->size(); ++node)
            most = std::max(most, tree->number(node));
    return std::max(8, static_cast<int>(std::to_string(most).size()));
}

/// Prints every test of a frame one by one, since together they may not fit into memory: as lines
/// below a heading.
void print_events(const TraceHeader& header, const QueryTrace& frame) {
    const Outcomes outcomes = outcomes_of(header, frame);
    const BodyNames names = side_names(header), bodies = {printable(names[0]), printable(names[1])};
    const int width = number_width(frame);
    std::string text =
        format("   test  parent %*s %*s  depths  outcome\n", width, "node A", width, "node B");
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        const TracedTest test = traced_test(header, frame, outcomes, i);
        const std::string parent =
            test.test.parent == no_step ? "-" : std::to_string(test.test.parent);
        text += format("%7zu %7s %*u %*u %3d %3d  ", i, parent.c_str(), width, test.test.nodes.a,
                       width, test.test.nodes.b, test.test.depth_a, test.test.depth_b) +
                words_of(test, bodies) + "\n";
        print_block(text);
    }
    print_result(text);
}

/// The same as elements of a JSON list, without its brackets.
void print_events_json(const TraceHeader& header, const QueryTrace& frame) {
    const Outcomes outcomes = outcomes_of(header, frame);
    const BodyNames bodies = side_names(header);
    std::string text;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        Json row = {{"test", i}};
        const std::uint32_t parent = frame.steps.volumes[i].parent;
        row["parent_test"] = parent == no_step ? Json() : Json(parent);
        row.update(traced_test_json(traced_test(header, frame, outcomes, i), bodies));
        text += (i == 0 ? "\n      " : ",\n      ") +
                row.dump(-1, ' ', false, Json::error_handler_t::replace);
        print_block(text);
    }
    print_result(text);
}

/// `given`: options on the command line that only a new trace can use.
int print(const TraceOptions& options, const std::vector<std::string>& given,
          const Console& console) {
    const std::string& path = options.scene.names[0];
    if (!options.scene.is_recording() || !asks_for_recorded(given)) refuse_for_trace(given, path);
    if (!options.output.empty())
        throw InputError(path + " is a trace already; give a scene to record, or leave out -o.");
    if (options.records)
        throw InputError("--records: " + path +
                         " is recorded already; give a scene to record, with -o FILE.scbrec.");
    // Reads all frames before printing, so that a bad file gives no partial output.
    scenes::TestInput input(path, options.query.frames, options.query.bodies,
                            options.scene.selection);
    if (input.recorded()) note_left_out(*input.recorded(), console.notes());
    const TraceHeader& header = input.header();
    if (options.json) {
        std::string start =
            trace_header_json(header).dump(2, ' ', false, Json::error_handler_t::replace);
        start.erase(start.size() - 2);  // the closing brace
        print_result(start + ",\n  \"frames\": [");
    } else {
        print_result(trace_header_text(header) + "\n" +
                     (options.events ? "" : count_table_header(header)));
    }
    std::size_t printed = 0;
    while (const QueryTrace* frame = input.next()) {
        const std::string table_header = count_table_header(header);
        if (options.json) {
            std::string row = count_json(header, *frame).dump();
            if (options.events) row.back() = ',';  // the closing brace
            print_result((printed == 0 ? "\n    " : ",\n    ") + row);
            if (options.events) {
                print_result("\"tests\": [");
                print_events_json(header, *frame);
                print_result("\n    ]}");
            }
        } else {
            const std::string row = count_table_row(header, *frame);
            print_result(options.events ? (printed == 0 ? "" : "\n") + table_header + row + "\n"
                                        : row);
            if (options.events) print_events(header, *frame);
        }
        ++printed;
    }
    if (options.json) print_result("\n  ]\n}\n");
    return exit_done;
}

}  // namespace

void add_trace(const Command& program, const Console& console, Action& action) {
    const Command command = program.add_subcommand(
        "trace", "Record every test of queries to a file, or print such a file");
    const auto options = std::make_shared<TraceOptions>();
    add_scene_options(command, options->scene, false);
    command.get_option("SCENE").description(
        "A built-in scene (see `scb scenes`), a scene file, or two mesh files, to be recorded; or "
        "a "
        "trace, to be printed");
    add_hierarchy_options(command, options->hierarchy, false);
    add_query_options(command, options->query, false);
    add_query_limits(command, options->limits);
    add_layout_options(command, options->layout,
                       "Record the queries on packed hierarchies, as --records does");
    add_kind_options(command, options->kind);
    command.add_flag("--first", options->first,
                     "With --within: end at the first triangles that are near enough");
    command.add_option("-o,--output", options->output, "Write the trace to this file")
        .file({".scbrec"})
        .only_typed();
    command.add_flag(
        "--records", options->records,
        "Write a recording with meshes, hierarchies and tests, as `scb_record.h` does");
    command.add_flag("--events", options->events, "Print every test of the trace");
    command.add_flag("--json", options->json, "Print the trace as JSON");
    command.footer(
        "With a scene and -o FILE, records its queries to FILE. With a trace in place of SCENE, "
        "prints what was asked, then the\n"
        "counts of every frame. The column `parent` of --events is the number of the test whose "
        "pair was divided. Ctrl-C keeps\n"
        "the frames that were finished and exits with 130.\n\n"
        "Examples:\n"
        "  scb trace spheres-l1 --frames 0:499:50 -o spheres.scbrec\n"
        "  scb trace spheres-l1 --kind distance --frames 0 -o distance.scbrec\n"
        "  scb trace spheres.scbrec --frames 250 --events");
    command.callback([&action, &console, command, options] {
        std::vector<std::string> given = given_recording_options(command);
        for (const char* option : {"--layout", "--leaf", "--kind", "--order", "--within",
                                   "--relative-error", "--limit", "--first"})
            if (command.count(option) > 0) given.emplace_back(option);
        take_kind(
            command,
            {"--test", "--threshold", "--max-pairs", "--levels", "--layout", "--leaf", "--records"},
            options->scene, options->hierarchy, options->query, options->kind);
        if (options->first) ask_for_first(options->query);
        action = [&console, options, given] {
            const std::vector<std::string>& names = options->scene.names;
            const bool recorded = names.size() == 1 &&
                                  (scenes::names_trace(names[0]) ||
                                   (scenes::names_recording(names[0]) && options->output.empty()));
            if (!recorded && options->scene.is_recording() && asks_for_recorded(given))
                throw InputError(names[0] +
                                 ": -o writes what this program's own query of its meshes and "
                                 "poses does; say of which volumes with --volume, or print the "
                                 "recorded query without -o.");
            return recorded ? print(*options, given, console) : record(*options, console);
        };
    });
}

}  // namespace scb::app
