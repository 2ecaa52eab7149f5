#include <cinttypes>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/exit_status.h"
#include "app/trace_input.h"
#include "app/trace_report.h"
#include "core/trace_words.h"

namespace scb {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::string a, b;
    bool json = false;
};

template <class... Values>
std::string format(const char* pattern, Values... values) {
    char text[200];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

/// A count by its name, and how to find it.
struct CountRow {
    std::string name;
    std::uint64_t a, b;
};

std::vector<CountRow> count_rows(const TraceCounts& a, const TraceCounts& b) {
    std::vector<CountRow> rows = {{"pairs", a.pairs, b.pairs},
                                  {"N_v", a.n_v, b.n_v},
                                  {"N_p", a.n_p, b.n_p},
                                  {"N_u", a.n_u, b.n_u}};
    for (std::size_t s = 0; s < stage_count; ++s)
        if (a.stages[s] != 0 || b.stages[s] != 0)
            rows.push_back(
                {std::string(stage_name(static_cast<Stage>(s))), a.stages[s], b.stages[s]});
    return rows;
}

std::string count_table(const TraceCounts& a, const TraceCounts& b) {
    std::string text = format("%-16s %12s %12s %12s\n", "", "A", "B", "B - A");
    for (const CountRow& row : count_rows(a, b)) {
        const auto change = static_cast<std::int64_t>(row.b - row.a);
        text += format("%-16s %12" PRIu64 " %12" PRIu64, row.name.c_str(), row.a, row.b) +
                (change == 0 ? format(" %12s\n", "0") : format(" %+12" PRId64 "\n", change));
    }
    return text;
}

std::string frame_list(const std::vector<int>& frames) {
    constexpr std::size_t most = 10;
    std::string text;
    for (std::size_t i = 0; i < frames.size() && i < most; ++i)
        text += (i == 0 ? "" : ", ") + std::to_string(frames[i]);
    return frames.size() > most ? text + ", ..." : text;
}

std::string plural(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string missing_text(const std::vector<int>& frames, const char* owner) {
    if (frames.empty()) return {};
    return plural(frames.size(), "frame") + " only in " + owner + ": " + frame_list(frames) + "\n";
}

std::string frames_text(const TraceDiff& d) {
    std::string text = plural(d.common, "frame") + " in both";
    if (d.common == 0) return text + "\n";
    if (d.frames.empty()) return text + ", all of them the same\n";
    std::vector<int> frames, moved;
    for (const FrameDifference& f : d.frames) {
        frames.push_back(f.frame);
        if (f.poses_differ) moved.push_back(f.frame);
    }
    text += ", " + plural(frames.size(), "frame") +
            (frames.size() == 1 ? " differs: " : " differ: ") + frame_list(frames) + "\n";
    if (!moved.empty())
        text += plural(moved.size(), "frame") + " with other poses: " + frame_list(moved) + "\n";
    return text;
}

std::string text_of(const Options& options, const TraceDiff& d) {
    std::string text = "A: " + options.a + "\nB: " + options.b + "\n\n";
    if (d.equal()) return text + "equal: " + plural(d.common, "frame") + "\n";
    if (!d.asked.empty()) {
        text += format("%-10s %-22s %s\n", "asked", "A", "B");
        for (const FieldDifference& field : d.asked)
            text += format("%-10s ", field.name.c_str()) + field.a +
                    std::string(field.a.size() < 22 ? 22 - field.a.size() : 0, ' ') + " " +
                    field.b + "\n";
        text += "\n";
    }
    text += missing_text(d.only_in_a, "A") + missing_text(d.only_in_b, "B") + frames_text(d);
    if (d.common == 0) return text;
    text += "\n" + count_table(d.sum_a, d.sum_b);
    if (!d.nodes_comparable)
        text += "\nThe meshes differ, so nodes and triangles cannot be compared.\n";
    else if (d.first)
        text += "\nThey part at " + words_of(*d.first);
    else
        text += "\nEvery test of the frames in both is the same.\n";
    return text;
}

Json counts_json(const TraceCounts& a, const TraceCounts& b) {
    Json result;
    for (const CountRow& row : count_rows(a, b)) {
        const std::string name = row.name == "N_v"   ? "n_v"
                                 : row.name == "N_p" ? "n_p"
                                 : row.name == "N_u" ? "n_u"
                                                     : row.name;
        result[name] = {{"a", row.a}, {"b", row.b}};
    }
    return result;
}

Json json_of(const Options& options, const TraceDiff& d) {
    Json asked = Json::array(), frames = Json::array(), first;
    for (const FieldDifference& field : d.asked)
        asked.push_back({{"field", field.name}, {"a", field.a}, {"b", field.b}});
    for (const FrameDifference& frame : d.frames)
        frames.push_back({{"frame", frame.frame},
                          {"poses_differ", frame.poses_differ},
                          {"counts", counts_json(frame.a, frame.b)}});
    if (d.first)
        first = {{"frame", d.first->frame},
                 {"test", d.first->test},
                 {"a", d.first->a ? traced_test_json(*d.first->a) : Json()},
                 {"b", d.first->b ? traced_test_json(*d.first->b) : Json()}};
    return {{"a", options.a},
            {"b", options.b},
            {"equal", d.equal()},
            {"asked", asked},
            {"only_in_a", d.only_in_a},
            {"only_in_b", d.only_in_b},
            {"common_frames", d.common},
            {"nodes_comparable", d.nodes_comparable},
            {"sum", counts_json(d.sum_a, d.sum_b)},
            {"frames", frames},
            {"first", first}};
}

int run(const Options& options) {
    TraceInput a(options.a), b(options.b);
    const TraceDiff d = diff(
        a.reader.header(), [&] { return a.reader.next(); }, b.reader.header(),
        [&] { return b.reader.next(); });
    print_result(options.json
                     ? json_of(options, d).dump(2, ' ', false, Json::error_handler_t::replace) +
                           "\n"
                     : text_of(options, d));
    return d.equal() ? exit_done : exit_different;
}

}  // namespace

void add_diff(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand(
        "diff", "Compare two traces: equal, or the first test at which they part");
    const auto options = std::make_shared<Options>();
    command->add_option("A", options->a, "A trace, see `scb trace`")->required()->type_name("");
    command->add_option("B", options->b, "Another trace")->required()->type_name("");
    command->add_flag("--json", options->json, "Print JSON instead of text");
    command->footer(
        "Compares what was asked, then the frames that are in both, in the order of the tests. "
        "Exit "
        "status: 0 equal,\n"
        "1 different, 2 a file is no trace. The versions of scb are not compared.\n\n"
        "Example:\n"
        "  scb trace spheres-l1 --frames 250 --test corrected -o corrected.scbtrace\n"
        "  scb trace spheres-l1 --frames 250 --test printed -o printed.scbtrace\n"
        "  scb diff corrected.scbtrace printed.scbtrace");
    command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace scb
