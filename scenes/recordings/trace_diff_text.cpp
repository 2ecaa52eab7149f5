#include "scenes/recordings/trace_diff_text.h"

#include <algorithm>
#include <cinttypes>

#include "core/base/text_format.h"
#include "core/platform/utf8.h"

namespace scb::scenes {
namespace {

std::string count_table(const TraceDiff& d, const TraceNames& names) {
    const std::string difference = names.b + " - " + names.a;
    const int width = std::max(14, static_cast<int>(difference.size()));
    const std::vector<CountRow> rows = count_rows(d, d.sum_a, d.sum_b);
    std::size_t longest = 16;
    for (const CountRow& row : rows) longest = std::max(longest, row.name.size());
    std::string text =
        std::string(longest, ' ') +
        format(" %12s %12s %*s\n", names.a.c_str(), names.b.c_str(), width, difference.c_str());
    for (const CountRow& row : rows) {
        const auto change = static_cast<std::int64_t>(row.b - row.a);
        text += left_aligned(printable(row.name), longest) +
                format(" %12" PRIu64 " %12" PRIu64, row.a, row.b) +
                (change == 0 ? format(" %*s\n", width, "0")
                             : format(" %+*" PRId64 "\n", width, change));
    }
    return text;
}

std::string frame_list(const std::vector<int>& frames, std::size_t most) {
    std::string text;
    for (std::size_t i = 0; i < frames.size() && i < most; ++i)
        text += (i == 0 ? "" : ", ") + std::to_string(frames[i]);
    return frames.size() > most ? text + ", ..." : text;
}

/// "frame 8", "frames 8, 9, 10".
std::string numbers_of(const std::vector<int>& frames, std::size_t most) {
    return (frames.size() == 1 ? "frame " : "frames ") + frame_list(frames, most);
}

/// "2 frames only in the first (frames 8, 9)"; nothing if there are none.
std::string line_of(const std::vector<int>& frames, const std::string& what, std::size_t most) {
    if (frames.empty()) return {};
    return counted(frames.size(), "frame", "frames") + " " + what + " (" +
           numbers_of(frames, most) + ")\n";
}

bool has_same_pairs(const TraceDiff& d) { return d.pairs_only_in_a + d.pairs_only_in_b == 0; }

/// Tests of another engine differ anyway, so pairs matter most.
bool says_pairs_first(const TraceDiff& d) {
    return d.of_engines && d.pairs_comparable && d.common > 0;
}

std::string pairs_text(const TraceDiff& d, const TraceNames& names) {
    if (!says_pairs_first(d)) return {};
    return (has_same_pairs(d) ? "Both found the same pairs" : lost_pairs_text(d, names)) + ".\n\n";
}

/// How the frames differ, a line for each kind of difference.
std::string kinds_text(const TraceDiff& d, const TraceNames& names, std::size_t most) {
    std::vector<int> moved, other_distances, other_triangles, same_answers, other_pairs, same_pairs,
        only_a, only_b;
    for (const FrameDifference& f : d.frames) {
        if (f.poses_differ) moved.push_back(f.frame);
        if (d.kind == QueryKind::distance) {
            (f.distances_differ()   ? other_distances
             : f.triangles_differ() ? other_triangles
                                    : same_answers)
                .push_back(f.frame);
            continue;
        }
        if (d.pairs_comparable) (f.pairs_differ() ? other_pairs : same_pairs).push_back(f.frame);
        if (f.touches_only_in_a()) only_a.push_back(f.frame);
        if (f.touches_only_in_b()) only_b.push_back(f.frame);
    }
    const std::string contact =
        d.kind == QueryKind::within ? "with pairs only in the " : "with contact only in the ";
    return line_of(moved, "with other poses", most) +
           line_of(other_distances, "with other distances", most) +
           line_of(other_triangles, "with the same distance of other triangles", most) +
           line_of(same_answers, "with the same distance, but other counts or tests", most) +
           line_of(other_pairs, "with other pairs", most) +
           line_of(same_pairs, "with the same pairs, but other counts or tests", most) +
           line_of(only_a, contact + names.a, most) + line_of(only_b, contact + names.b, most);
}

std::string frames_text(const TraceDiff& d, const TraceNames& names, std::size_t most) {
    std::string text = counted(d.common, "frame", "frames") + " in both";
    if (d.common == 0) return text + "\n";
    if (d.frames.empty())
        return text + (d.nodes_comparable ? ", all of them the same\n"
                                          : ", with equal poses and counts\n");
    std::vector<int> frames;
    for (const FrameDifference& f : d.frames) frames.push_back(f.frame);
    return text + ", " + std::to_string(frames.size()) +
           (frames.size() == 1 ? " differs" : " differ") +
           (says_pairs_first(d) && has_same_pairs(d) ? " otherwise (" : " (") +
           numbers_of(frames, most) + ")\n" + kinds_text(d, names, most);
}

BodyNames printable_names(const BodyNames& names) {
    return {printable(names[0]), printable(names[1])};
}

/// The first answers that differ.
std::string answers_text(const TraceDiff& d, const TraceNames& names) {
    std::string text;
    std::size_t listed = 0;
    for (const FrameDifference& frame : d.frames) {
        const std::string answer = answer_text(frame, names);
        if (answer.empty()) continue;
        if (listed++ < TraceDiff::most_lost) text += "  " + answer + "\n";
    }
    if (listed == 0) return "";
    const bool some = listed > TraceDiff::most_lost;
    return "\n" + counted(listed, "answer differs", "answers differ") +
           (some ? format("; %zu of them:\n", TraceDiff::most_lost) : std::string(":\n")) + text;
}

// The pairs that only one trace found, and the tests by which the other left them out.
std::string lost_text(const TraceDiff& d, const TraceNames& names) {
    if (d.kind == QueryKind::distance) return answers_text(d, names);
    if (d.nodes_comparable && !d.pairs_comparable)
        return "\nThey stop at different levels, so their pairs cannot be compared.\n";
    if (has_same_pairs(d))
        return d.pairs_comparable && !d.nodes_comparable && !says_pairs_first(d)
                   ? "\nBoth found the same pairs.\n"
                   : "";
    std::string text = "\n" + lost_pairs_text(d, names);
    const bool some = d.lost.size() < d.pairs_only_in_a + d.pairs_only_in_b;
    text += some ? format("; %zu of them:\n", d.lost.size()) : std::string(":\n");
    for (const LostPair& lost : d.lost)
        text += "  " + words_of(lost, d.of_nodes, printable_names(d.bodies), names) + "\n";
    return text;
}

}  // namespace

std::vector<CountRow> count_rows(const TraceDiff& d, const TraceCounts& a, const TraceCounts& b) {
    std::vector<CountRow> rows;
    if (d.kind != QueryKind::distance) rows.push_back({"pairs", a.pairs, b.pairs});
    rows.push_back({"N_v", a.n_v, b.n_v});
    rows.push_back({"N_p", a.n_p, b.n_p});
    if (a.n_u && b.n_u) rows.push_back({"N_u", *a.n_u, *b.n_u});
    const auto of = [](const TraceCounts& counts, const std::string& stage) {
        const auto found = counts.stages.find(stage);
        return found == counts.stages.end() ? 0 : found->second;
    };
    for (const std::string& stage : d.stages)
        if (of(a, stage) != 0 || of(b, stage) != 0)
            rows.push_back({stage, of(a, stage), of(b, stage)});
    return rows;
}

std::string lost_pairs_text(const TraceDiff& d, const TraceNames& names) {
    if (d.pairs_only_in_a + d.pairs_only_in_b == 0) return {};
    return counted(d.pairs_only_in_a, "pair", "pairs") + " only in the " + names.a + ", " +
           counted(d.pairs_only_in_b, "pair", "pairs") + " only in the " + names.b;
}

std::string answer_text(const FrameDifference& frame, const TraceNames& names) {
    if (!frame.distances_differ() && !frame.triangles_differ()) return {};
    const auto of = [](const std::optional<NearestTriangles>& found) {
        return found ? format("%.17g of the triangles (%u, %u)", found->distance,
                              found->triangles.a, found->triangles.b)
                     : std::string("no triangles within the limit");
    };
    return format("frame %d: ", frame.frame) + of(frame.nearest_a) + " in the " + names.a + ", " +
           of(frame.nearest_b) + " in the " + names.b +
           (frame.distances_differ() && frame.nearest_a && frame.nearest_b
                ? format("; they may differ by %.2g", frame.rounding)
                : "");
}

std::string trace_diff_text(const TraceDiff& d, const TraceNames& names, std::size_t most) {
    if (d.equal()) return "equal: " + counted(d.common, "frame", "frames") + "\n";
    std::string text = pairs_text(d, names);
    if (!d.asked.empty()) {
        std::size_t width = names.a.size();
        for (const FieldDifference& field : d.asked) width = std::max(width, field.a.size());
        const auto row = [width](const std::string& name, const std::string& a,
                                 const std::string& b) {
            return format("%-10s  ", name.c_str()) + a + std::string(width - a.size(), ' ') + "  " +
                   b + "\n";
        };
        text += row("asked", names.a, names.b);
        for (const FieldDifference& field : d.asked)
            text += row(field.name, printable(field.a), printable(field.b));
        text += "\n";
    }
    text += line_of(d.only_in_a, "only in the " + names.a, most) +
            line_of(d.only_in_b, "only in the " + names.b, most) + frames_text(d, names, most);
    if (d.common == 0) return text;
    text += "\n" +
            (d.common == 1
                 ? std::string("Counts of the frame in both:\n")
                 : "Counts, summed over the " + std::to_string(d.common) + " frames in both:\n") +
            count_table(d, names) + lost_text(d, names);
    if (!d.nodes_comparable)
        text += d.meshes_differ
                    ? "\nThe meshes differ, so nodes and triangles cannot be compared.\n"
                : d.trees_known
                    ? "\nThe trees differ, so tests cannot be compared.\n"
                    : "\nNot compared: trees and tests, since only one of the two has its trees.\n";
    else if (d.first)
        text += "\nThey part first at " + words_of(*d.first, printable_names(d.bodies), names);
    else
        text += "\nEvery test of the frames in both is the same.\n";
    return text;
}

}  // namespace scb::scenes
