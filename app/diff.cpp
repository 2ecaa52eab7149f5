#include <algorithm>
#include <cinttypes>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/exit_status.h"
#include "app/text_format.h"
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
    std::string text = format("%-16s %12s %12s %14s\n", "", "first", "second", "second - first");
    for (const CountRow& row : count_rows(a, b)) {
        const auto change = static_cast<std::int64_t>(row.b - row.a);
        text += format("%-16s %12" PRIu64 " %12" PRIu64, row.name.c_str(), row.a, row.b) +
                (change == 0 ? format(" %14s\n", "0") : format(" %+14" PRId64 "\n", change));
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

/// "frame 8", "frames 8, 9, 10".
std::string numbers_of(const std::vector<int>& frames) {
    return (frames.size() == 1 ? "frame " : "frames ") + frame_list(frames);
}

std::string plural(std::uint64_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string missing_text(const std::vector<int>& frames, const char* owner) {
    if (frames.empty()) return {};
    return plural(frames.size(), "frame") + " only in the " + owner + " (" + numbers_of(frames) +
           ")\n";
}

std::string frames_text(const TraceDiff& d) {
    std::string text = plural(d.common, "frame") + " in both";
    if (d.common == 0) return text + "\n";
    if (d.frames.empty())
        return text + (d.nodes_comparable ? ", all of them the same\n"
                                          : ", with equal poses and counts\n");
    std::vector<int> frames, moved;
    for (const FrameDifference& f : d.frames) {
        frames.push_back(f.frame);
        if (f.poses_differ) moved.push_back(f.frame);
    }
    text += ", " + std::to_string(frames.size()) + (frames.size() == 1 ? " differs" : " differ") +
            " (" + numbers_of(frames) + ")\n";
    if (!moved.empty())
        text += plural(moved.size(), "frame") + " with other poses (" + numbers_of(moved) + ")\n";
    return text;
}

BodyNames printable_names(const BodyNames& names) {
    return {printable(names[0]), printable(names[1])};
}

// Which pairs one found and the other did not, and by which test it left them out.
std::string lost_text(const TraceDiff& d) {
    if (d.nodes_comparable && !d.pairs_comparable)
        return "\nThey stop at different levels, so their pairs cannot be compared.\n";
    if (d.pairs_only_in_a + d.pairs_only_in_b == 0) return {};
    std::string text = "\n" + plural(d.pairs_only_in_a, "pair") + " only in the first, " +
                       plural(d.pairs_only_in_b, "pair") + " only in the second";
    const bool some = d.lost.size() < d.pairs_only_in_a + d.pairs_only_in_b;
    text += some ? format("; %zu of them:\n", d.lost.size()) : std::string(":\n");
    for (const LostPair& lost : d.lost)
        text += "  " + words_of(lost, d.of_nodes, printable_names(d.bodies)) + "\n";
    return text;
}

std::string text_of(const Options& options, const TraceDiff& d) {
    std::string text =
        "first:  " + printable(options.a) + "\nsecond: " + printable(options.b) + "\n\n";
    if (d.equal()) return text + "equal: " + plural(d.common, "frame") + "\n";
    if (!d.asked.empty()) {
        std::size_t width = 5;
        for (const FieldDifference& field : d.asked) width = std::max(width, field.a.size());
        const auto row = [width](const std::string& name, const std::string& a,
                                 const std::string& b) {
            return format("%-10s  ", name.c_str()) + a + std::string(width - a.size(), ' ') + "  " +
                   b + "\n";
        };
        text += row("asked", "first", "second");
        for (const FieldDifference& field : d.asked)
            text += row(field.name, printable(field.a), printable(field.b));
        text += "\n";
    }
    text +=
        missing_text(d.only_in_a, "first") + missing_text(d.only_in_b, "second") + frames_text(d);
    if (d.common == 0) return text;
    text += "\n" +
            (d.common == 1
                 ? std::string("Counts of the frame in both:\n")
                 : "Counts, summed over the " + std::to_string(d.common) + " frames in both:\n") +
            count_table(d.sum_a, d.sum_b) + lost_text(d);
    if (!d.nodes_comparable)
        text += "\nThe meshes differ, so nodes and triangles cannot be compared.\n";
    else if (d.first)
        text += "\nThey part first at " + words_of(*d.first, printable_names(d.bodies));
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
            {"sum", counts_json(d.sum_a, d.sum_b)},
            {"frames", frames},
            {"pairs_comparable", d.pairs_comparable},
            {"pairs_only_in_a", d.pairs_only_in_a},
            {"pairs_only_in_b", d.pairs_only_in_b},
            {"lost", lost},
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
