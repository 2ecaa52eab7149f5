#include <array>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/progress.h"
#include "app/cli/validators.h"
#include "app/report/trace_report.h"
#include "app/study/query_source.h"
#include "core/base/exit_status.h"
#include "core/platform/utf8.h"
#include "scb/error.h"
#include "scenes/recordings/recording_input.h"
#include "scenes/recordings/test_input.h"
#include "scenes/recordings/trace_diff_text.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

struct DiffOptions {
    std::string a, b, bodies;
    scenes::QuerySelection selection;  ///< of the recordings; traces have no names
    int top = 10;
    bool json = false;
};

Json counts_json(const TraceDiff& d, const TraceCounts& a, const TraceCounts& b) {
    Json result;
    for (const scenes::CountRow& row : scenes::count_rows(d, a, b)) {
        const std::string name = row.name == "N_v"   ? "n_v"
                                 : row.name == "N_p" ? "n_p"
                                 : row.name == "N_u" ? "n_u"
                                                     : row.name;
        result[name] = {{"a", row.a}, {"b", row.b}};
    }
    return result;
}

/// The distances of both and their triangles; null without triangles.
Json answers_json(const FrameDifference& frame) {
    const auto of = [](const std::optional<NearestTriangles>& found) -> std::array<Json, 2> {
        if (!found) return {};
        return {Json(found->distance), Json{found->triangles.a, found->triangles.b}};
    };
    const auto [distance_a, triangles_a] = of(frame.nearest_a);
    const auto [distance_b, triangles_b] = of(frame.nearest_b);
    return {{"distances_differ", frame.distances_differ()},
            {"triangles_differ", frame.triangles_differ()},
            {"distance", {{"a", distance_a}, {"b", distance_b}}},
            {"rounding", frame.rounding},
            {"triangles", {{"a", triangles_a}, {"b", triangles_b}}}};
}

Json json_of(const DiffOptions& options, const TraceDiff& d) {
    Json asked = Json::array(), frames = Json::array(), first;
    for (const FieldDifference& field : d.asked)
        asked.push_back({{"field", field.name}, {"a", field.a}, {"b", field.b}});
    for (const FrameDifference& frame : d.frames) {
        frames.push_back(
            {{"frame", frame.frame},
             {"poses_differ", frame.poses_differ},
             {"pairs_only_in_a", d.pairs_comparable ? Json(frame.pairs_only_in_a) : Json()},
             {"pairs_only_in_b", d.pairs_comparable ? Json(frame.pairs_only_in_b) : Json()},
             {"counts", counts_json(d, frame.a, frame.b)}});
        if (d.kind == QueryKind::distance) frames.back().update(answers_json(frame));
    }
    Json lost = Json::array();
    for (const LostPair& pair : d.lost)
        lost.push_back(
            {{"frame", pair.frame},
             {"pair", {pair.pair.a, pair.pair.b}},
             {"found_by", pair.found_by_a ? "a" : "b"},
             {"test", pair.lost_at ? Json(pair.test) : Json()},
             {"lost_at", pair.lost_at ? traced_test_json(*pair.lost_at, d.bodies) : Json()}});
    if (d.first)
        first = {{"frame", d.first->frame},
                 {"test", d.first->test},
                 {"a", d.first->a ? traced_test_json(*d.first->a, d.bodies) : Json()},
                 {"b", d.first->b ? traced_test_json(*d.first->b, d.bodies) : Json()}};
    return {{"a", options.a},
            {"b", options.b},
            {"equal", d.equal()},
            {"asked", asked},
            {"only_in_a", d.only_in_a},
            {"only_in_b", d.only_in_b},
            {"common_frames", d.common},
            {"nodes_comparable", d.nodes_comparable},
            {"sum", counts_json(d, d.sum_a, d.sum_b)},
            {"frames", frames},
            {"pairs_comparable", d.pairs_comparable},
            {"pairs_only_in_a", d.pairs_comparable ? Json(d.pairs_only_in_a) : Json()},
            {"pairs_only_in_b", d.pairs_comparable ? Json(d.pairs_only_in_b) : Json()},
            {"lost", lost},
            {"first", first}};
}

int run(const DiffOptions& options, const Console& console) {
    if (options.top < 1)
        throw InputError("--top " + std::to_string(options.top) + ": give at least 1.");
    const auto selection = [&](const std::string& file, const std::string& other) {
        const bool selects = scenes::names_recording(file) || !scenes::names_recording(other);
        return selects ? options.selection : scenes::QuerySelection{};
    };
    scenes::TestInput a(options.a, "all", options.bodies, selection(options.a, options.b)),
        b(options.b, "all", options.bodies, selection(options.b, options.a));
    for (const scenes::TestInput* input : {&a, &b}) refuse_recorded_distances(input->header());
    for (const scenes::TestInput* input : {&a, &b})
        if (const auto& engine = input->header().engine; engine && engine->left_out > 0)
            throw InputError(
                (input == &a ? options.a : options.b) +
                ": frames have several queries of these bodies, and one query of each frame is "
                "compared; select queries with --query or --tag.");
    Progress progress(console, a.frames().size());
    const auto next_of_a = [&] {
        const QueryTrace* frame = a.next();
        if (frame) progress.step("frames");
        return frame;
    };
    const TraceDiff d = diff(a.header(), next_of_a, b.header(), [&] { return b.next(); });
    print_result(
        options.json
            ? json_of(options, d).dump(2, ' ', false, Json::error_handler_t::replace) + "\n"
            : "first:  " + printable(options.a) + "\nsecond: " + printable(options.b) + "\n\n" +
                  scenes::trace_diff_text(d, {}, static_cast<std::size_t>(options.top)));
    return d.equal() ? exit_done : exit_different;
}

}  // namespace

void add_diff(const Command& program, const Console& console, Action& action) {
    const Command command =
        program.add_subcommand("diff", "Compare two traces: equal, or the first test that differs");
    const auto options = std::make_shared<DiffOptions>();
    command.add_option("A", options->a, "A trace, see `scb trace`, or another engine's recording")
        .required()
        .file({".scbrec", ".jsonl"})
        .type_name("");
    command.add_option("B", options->b, "Another trace or recording")
        .required()
        .file({".scbrec", ".jsonl"})
        .type_name("");
    command.add_option("--bodies", options->bodies, "Two bodies of a recording: A,B");
    command
        .add_option("--query", options->selection.name,
                    "Compare only queries of this name, of recordings")
        .type_name("NAME");
    command
        .add_option("--tag", options->selection.tag,
                    "Compare only queries with this tag, of recordings")
        .type_name("TAG");
    command.add_option("--top", options->top, "Name at most K frames for each kind of difference")
        .check(decimal_number)
        .type_name("K")
        .show_default();
    command.add_flag("--json", options->json, "Print JSON instead of text");
    command.footer(
        "Compares what was asked, then the frames that are in both, in the order of the tests. "
        "Exit "
        "status: 0 equal,\n"
        "1 different, 2 a file is neither a trace nor a recording. The versions of scb and the "
        "names of recordings are not compared.\n"
        "Distances are equal if they differ by rounding only: 4 x 2^-52 of the largest coordinate. "
        "Traces of different kinds are refused.\n\n"
        "Example:\n"
        "  scb trace spheres-l1 --frames 250 --test corrected -o corrected.scbrec\n"
        "  scb trace spheres-l1 --frames 250 --test printed -o printed.scbrec\n"
        "  scb diff corrected.scbrec printed.scbrec");
    command.callback([&action, &console, options] {
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
