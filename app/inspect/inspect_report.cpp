#include "app/inspect/inspect_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "app/cli/console.h"
#include "app/explain/explain_pictures.h"
#include "app/inspect/inspect_findings.h"
#include "app/inspect/inspect_summary.h"
#include "app/inspect/inspect_triangles.h"
#include "app/inspect/recording_report.h"
#include "app/report/build_text.h"
#include "app/report/scene_report.h"
#include "app/report/trace_report.h"
#include "app/report/wrapped_text.h"
#include "core/base/text_format.h"
#include "core/platform/number_list.h"
#include "core/platform/utf8.h"
#include "render/figures/figure_words.h"
#include "render/figures/inspect_figure.h"
#include "render/figures/reason_words.h"
#include "render/overlay/figure_layout.h"

namespace scb::app {
namespace {

std::string cell(std::size_t width, std::uint64_t count) {
    return " " + right_aligned(render::count_text(count), width);
}

std::vector<render::ReasonWords> words_in(const InspectReport& report) {
    return render::reason_words(report.header.kind, report.sum.counts);
}

/// A row of the table of frames; the sum has no distance.
std::string frame_row(const std::string& name, const InspectReport& report, const Inspection& i,
                      double distance) {
    const PassCounts& counts = i.counts;
    std::string text = format("%5s", name.c_str());
    if (report.header.kind == QueryKind::distance)
        text += format(" %12s", distance < 0 ? "" : format("%.6g", distance).c_str());
    else
        text += cell(8, i.pairs);
    text += cell(9, counts.all.volume_tests) + cell(9, counts.passed());
    for (const render::ReasonWords& words : words_in(report))
        text += cell(8, counts.passed(words.reason));
    return text + cell(10, counts.wasted().volume_tests) +
           format(" %8s", share(counts.wasted().volume_tests, counts.all.volume_tests).c_str()) +
           cell(9, counts.wasted().triangle_tests) +
           format(" %8s",
                  share(counts.wasted().triangle_tests, counts.all.triangle_tests).c_str()) +
           (counts.wrongly_rejected > 0
                ? format("  REJECTED WRONGLY: %s, %s pairs missed",
                         render::count_text(counts.wrongly_rejected).c_str(),
                         render::count_text(counts.missed).c_str())
                : "") +
           "\n";
}

std::string frames_heading(const InspectReport& report) {
    std::string text =
        report.header.kind == QueryKind::distance ? "frame     distance" : "frame    pairs";
    text += "       N_v    passed";
    for (const render::ReasonWords& words : words_in(report))
        text += right_aligned(words.column, 9);
    const std::string units(text.size() + 7, ' ');
    return text + "     wasted    share    wasted    share\n" + units +
           "N_v   of N_v       N_p   of N_p\n";
}

std::string reasons_text(const InspectReport& report) {
    const PassCounts& sum = report.sum.counts;
    const bool is_distance = is_of_distance(report.header.kind);
    const std::size_t width = is_distance ? 17 : 14;
    std::string text = left_aligned("passed because", width) +
                       "      inner    leaves  wasted N_v  wasted N_p" +
                       (is_distance ? "" : "  wasted operations") + "\n";
    for (const render::ReasonWords& words : words_in(report)) {
        const auto r = static_cast<std::size_t>(words.reason);
        text += left_aligned(words.title, width) + cell(10, sum.inner[r]) + cell(9, sum.leaves[r]);
        if (words.reason != PassReason::triangles_meet) {
            const Work wasted = sum.wasted_by(words.reason);
            text += cell(11, wasted.volume_tests) + cell(11, wasted.triangle_tests);
            if (!is_distance)
                text += " " + right_aligned(operations_text(report, wasted.operations), 18);
        }
        text += "\n";
    }
    return text + "\n";
}

std::string depths_text(const InspectReport& report) {
    const Inspection& sum = report.sum;
    const std::vector<render::ReasonWords> reasons = words_in(report);
    std::string text = "depth     tests    passed";
    for (const render::ReasonWords& words : reasons) text += right_aligned(words.column, 9);
    text += "    wasted    share\n";
    for (std::size_t d = 0; d < sum.depths.size(); ++d) {
        const DepthInspection& at = sum.depths[d];
        std::uint64_t passed = 0;
        std::string of_reasons;
        for (const render::ReasonWords& words : reasons) {
            const std::uint64_t count = at.passed[static_cast<std::size_t>(words.reason)];
            passed += count;
            of_reasons += cell(8, count);
        }
        text += format("%5zu", d) + cell(9, at.tests) + cell(9, passed) + of_reasons +
                cell(9, at.wasted.all()) +
                format(" %8s\n", share(at.wasted.all(), at.tests).c_str());
    }
    return text + "\n";
}

std::string worst_text(const InspectReport& report, const WorstOfReason& worst) {
    const bool is_distance = is_of_distance(report.header.kind);
    const char* const title = render::words_of(worst.reason, report.header.kind).title;
    if (worst.pairs.empty()) return std::string(title) + ": none\n\n";
    std::string text = format("%s: the worst by N_v + N_p, nodes of %s and %s\n", title,
                              printable(report.header.bodies[0].name).c_str(),
                              printable(report.header.bodies[1].name).c_str());
    text += "frame          nodes     depths  wasted N_v       N_p";
    text += is_distance ? "  beyond the answer by\n" : "   operations  gap, -depth\n";
    for (const FalsePair& p : worst.pairs) {
        const Work& below = p.pair.below;
        text += format("%5d %8u %8u   %3d %3d", p.frame, p.test.nodes.a, p.test.nodes.b,
                       p.test.depth_a, p.test.depth_b) +
                cell(11, below.volume_tests) + cell(9, below.triangle_tests);
        if (is_distance) {
            const bool is_beyond = p.pair.exact == Contact::disjoint;
            text += format("  %20s\n", is_beyond ? format("%.3g", p.pair.gap).c_str() : "-");
            continue;
        }
        text += " " + right_aligned(operations_text(report, below.operations), 12) +
                format("  %10.3g", p.pair.exact == Contact::disjoint ? p.margin : -p.margin) + "\n";
    }
    return text + "\n";
}

std::string others_text(const InspectReport& report) {
    if (report.others.empty()) return "";
    const std::uint64_t weak = report.sum.counts.passed(PassReason::weak_test);
    std::string text = format(
        "what would have caught it: of the %s pairs that %s passed though their volumes are "
        "disjoint\n"
        "test                  caught       N_v                N_p           operations\n",
        render::count_text(weak).c_str(), overlap_title(report.header.options.overlap).c_str());
    const Work& base = report.sum.counts.all;
    const auto changed = [](std::size_t width, std::uint64_t from, std::uint64_t to) {
        return cell(width, to) + " " + right_aligned(render::change_text(from, to), 8);
    };
    for (const AlternativeTest& other : report.others)
        text += format("%-19s", overlap_title(other.overlap).c_str()) + cell(8, other.caught) +
                changed(9, base.volume_tests, other.all.volume_tests) +
                changed(9, base.triangle_tests, other.all.triangle_tests) +
                changed(12, base.operations, other.all.operations) + "\n";
    return text;
}

std::string triangles_text(const InspectReport& report) {
    const Table table = triangles_table(report);
    return table.size() == 0 ? "" : triangles_heading + table.text() + "\n";
}

std::string title_text(const TraceHeader& header) {
    std::string title = printable(header.scene) + ": " + bodies_text(header) + ", " +
                        std::string(render::volume_title(header.volume));
    if (header.kind == QueryKind::distance)
        title += ", distance, order " + std::string(distance_order_name(header.distance.order));
    else if (header.kind == QueryKind::within)
        title += format(", pairs within %.6g", header.tolerance);
    else if (header.volume == VolumeKind::scb)
        title += ", test " + overlap_title(header.options.overlap);
    return title + build_text(build_options(header)) + "\n\n";
}

/// Lines that are too long, wrapped with their indent and two blanks. The first line, which scripts
/// may read, is kept.
std::string wrapped_lines(const std::string& text) {
    std::string lines;
    for (const std::string& line : split_list(text.substr(0, text.size() - 1), '\n'))
        lines += (lines.empty() || character_count(line) <= report_width
                      ? line
                      : wrapped_text(line, line.find_first_not_of(' ') + 2)) +
                 "\n";
    return lines;
}

/// A recording may have several queries of the bodies in a frame, or of other bodies.
std::string first_words(const InspectReport& report) {
    const std::uint64_t queries = report.recording->judged.total(&scenes::FrameJudgement::queries);
    return queries > report.frames.size() ? ", the first of each frame" : "";
}

std::string worst_pairs_text(const InspectReport& report) {
    std::string text;
    for (const WorstOfReason& worst : report.worst)
        if (worst.reason != PassReason::unjudged || !worst.pairs.empty())
            text += worst_text(report, worst);
    return text;
}

std::string waste_text(const InspectReport& report) {
    std::string text;
    for (const std::string& sentence : inspect_findings(report)) text += sentence + "\n";
    // The judgement of a recording has a table of frames.
    return text + "\n" + (report.recording ? "" : inspect_frames_text(report, most_frame_rows)) +
           reasons_text(report) + triangles_text(report) + depths_text(report) +
           worst_pairs_text(report) + inspect_rejections_text(report, report.wrong.size()) +
           others_text(report);
}

}  // namespace

std::string share(std::uint64_t part, std::uint64_t whole) {
    return render::share_text(static_cast<double>(part), static_cast<double>(whole));
}

std::string file_of(const InspectReport& report, int frame, const Step& test) {
    if (!report.drawn) return "";
    return explain_name(report.stem, report.header, report.named, frame,
                        {test.nodes.a, test.nodes.b}) +
           ".png";
}

std::string operations_text(const InspectReport& report, std::uint64_t operations) {
    return report.header.engine ? "–" : render::count_text(operations);
}

std::string inspect_rejections_text(const InspectReport& report, std::size_t most) {
    most = std::min(most, report.wrong.size());
    if (report.wrong.empty()) return "";
    std::string text = format("REJECTED WRONGLY: the worst %zu of %llu pairs whose volumes %s\n",
                              most, wide(report.sum.counts.wrongly_rejected),
                              is_of_distance(report.header.kind) ? "are near enough" : "meet");
    text += "frame          nodes     depths   missed  rejected at\n";
    for (const WronglyRejectedPair& w : std::span(report.wrong).first(most))
        text += format("%5d %8u %8u   %3d %3d %8llu  %s\n", w.frame, w.test.nodes.a, w.test.nodes.b,
                       w.test.depth_a, w.test.depth_b, wide(w.rejection.missed),
                       stage_words(report.header, w.test.stage).c_str());
    return text + "\n";
}

std::string inspect_frames_text(const InspectReport& report, std::size_t most) {
    std::string text = report.frames.size() == 1 ? "" : "frames, the most wasted N_v first\n";
    text += frames_heading(report);
    const std::size_t rows = std::min(report.frames.size(), most);
    for (std::size_t i = 0; i < rows; ++i)
        text += frame_row(std::to_string(report.frames[i].frame), report, report.frames[i].found,
                          report.frames[i].distance);
    if (report.frames.size() > rows)
        text += format("  ...  %zu more frames, which --json and the table of -o list\n",
                       report.frames.size() - rows);
    if (report.frames.size() > 1) text += frame_row("sum", report, report.sum, -1);
    return text + "\n";
}

std::string inspect_text(const InspectReport& report, bool full) {
    std::string text = report.recording ? recording_text(*report.recording, report.settings)
                                        : title_text(report.header);
    if (!full) text = wrapped_lines(text);
    if (report.has_waste) {
        if (report.recording)
            text += "\nWaste in the queries of " + bodies_text(report.header) +
                    first_words(report) + "\n";
        text += full ? waste_text(report) : inspect_summary(report);
    }
    if (has_advice(report) && full) text += settings_text(*report.settings, report.frames.size());
    if (report.distance_advice && full)
        text += wrapped_lines("What would have helped: " + trial_words(*report.distance_advice) +
                              "\n") +
                trial_table(*report.distance_advice, most_trial_rows).text() +
                "\nTo use it:  " + report.distance_advice->command +
                "\nTo time it: " + report.distance_advice->timing + "\n";
    if (!report.recording || report.recording->pictures.empty()) return text;
    text += "\nPictures\n";
    for (const ProblemPicture& picture : report.recording->pictures)
        text += "  " + picture.file + ": " + picture.what + "\n";
    return text;
}

}  // namespace scb::app
