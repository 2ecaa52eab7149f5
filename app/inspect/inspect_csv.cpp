#include "app/inspect/inspect_csv.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/text_format.h"

namespace scb::app {
namespace {

/// Numbers; an unknown one is an empty cell.
std::string row(std::initializer_list<std::optional<std::uint64_t>> values) {
    std::string text;
    bool first = true;
    for (const std::optional<std::uint64_t>& value : values)
        text += (std::exchange(first, false) ? "" : ",") + (value ? std::to_string(*value) : "");
    return text;
}

/// The operations of volume tests, if they are known.
std::optional<std::uint64_t> operations(const InspectReport& report, const Work& work) {
    if (report.header.engine) return std::nullopt;
    return work.operations;
}

std::string pair_row(int frame, const Step& test, const char* reason) {
    return std::to_string(frame) + "," +
           row({test.nodes.a, test.nodes.b, test.depth_a, test.depth_b}) + "," + reason;
}

/// By frame, in the order of frames.
std::vector<const InspectedFrame*> ordered_frames(const InspectReport& report) {
    std::vector<const InspectedFrame*> frames;
    for (const InspectedFrame& frame : report.frames) frames.push_back(&frame);
    std::sort(frames.begin(), frames.end(),
              [](const auto* x, const auto* y) { return x->frame < y->frame; });
    return frames;
}

std::string distance_frames_csv(const InspectReport& report) {
    const bool is_within = report.header.kind == QueryKind::within;
    const std::vector<PassReason> reasons = waste_reasons(report.header.kind);
    std::string text = std::string("frame,") + (is_within ? "pairs" : "distance,certified") +
                       ",n_v,n_p,passed,true";
    const auto name = [](PassReason reason) { return std::string(pass_reason_names[reason]); };
    for (const PassReason reason : reasons) text += "," + name(reason);
    text += ",wrongly_rejected,missed_pairs,wasted_n_v,wasted_n_p";
    for (const PassReason reason : reasons)
        text += ",wasted_by_" + name(reason) + "_n_v,wasted_by_" + name(reason) + "_n_p";
    text += "\n";
    for (const InspectedFrame* frame : ordered_frames(report)) {
        const PassCounts& c = frame->found.counts;
        text += std::to_string(frame->frame) + ",";
        if (is_within)
            text += row({frame->found.pairs});
        else
            text += (frame->distance < 0 ? "" : format("%.17g", frame->distance)) +
                    (report.recording   ? ","
                     : frame->certified ? ",1"
                                        : ",0");
        text += "," + row({c.all.volume_tests, c.all.triangle_tests, c.passed(),
                           c.passed(PassReason::triangles_meet)});
        for (const PassReason reason : reasons) text += "," + row({c.passed(reason)});
        text += "," + row({c.wrongly_rejected, c.missed, c.wasted().volume_tests,
                           c.wasted().triangle_tests});
        for (const PassReason reason : reasons) {
            const Work wasted = c.wasted_by(reason);
            text += "," + row({wasted.volume_tests, wasted.triangle_tests});
        }
        text += "\n";
    }
    return text;
}

std::string distance_pairs_csv(const InspectReport& report) {
    std::string text =
        "frame,node_a,node_b,depth_a,depth_b,reason,beyond,leaves,wasted_n_v,wasted_n_p,stage,"
        "missed_pairs\n";
    for (const WorstOfReason& worst : report.worst)
        for (const FalsePair& p : worst.pairs)
            text +=
                pair_row(p.frame, p.test, std::string(pass_reason_names[worst.reason]).c_str()) +
                (p.pair.exact == Contact::disjoint ? format(",%.17g,", p.pair.gap) : ",,") +
                row({p.pair.leaves, p.pair.below.volume_tests, p.pair.below.triangle_tests}) +
                ",near,\n";
    for (const WronglyRejectedPair& w : report.wrong)
        text += pair_row(w.frame, w.test, "wrongly rejected") + ",,,,," +
                stage_words(report.header, w.test.stage) + "," +
                std::to_string(w.rejection.missed) + "\n";
    return text;
}

}  // namespace

std::string frames_csv(const InspectReport& report) {
    if (is_of_distance(report.header.kind)) return distance_frames_csv(report);
    std::string text =
        "frame,pairs,n_v,n_p,passed,true,fit,test,wrongly_rejected,missed_pairs,operations,wasted_"
        "n_v,"
        "wasted_n_p,wasted_operations,wasted_by_test_n_v,wasted_by_test_n_p,"
        "wasted_by_test_operations\n";
    for (const InspectedFrame* frame : ordered_frames(report)) {
        const PassCounts& c = frame->found.counts;
        text +=
            std::to_string(frame->frame) + "," +
            row({frame->found.pairs, c.all.volume_tests, c.all.triangle_tests, c.passed(),
                 c.passed(PassReason::triangles_meet), c.passed(PassReason::loose_fit),
                 c.passed(PassReason::weak_test), c.wrongly_rejected, c.missed,
                 operations(report, c.all), c.wasted().volume_tests, c.wasted().triangle_tests,
                 operations(report, c.wasted()), c.wasted_by(PassReason::weak_test).volume_tests,
                 c.wasted_by(PassReason::weak_test).triangle_tests,
                 operations(report, c.wasted_by(PassReason::weak_test))}) +
            "\n";
    }
    return text;
}

std::string pairs_csv(const InspectReport& report) {
    if (is_of_distance(report.header.kind)) return distance_pairs_csv(report);
    std::string text =
        "frame,node_a,node_b,depth_a,depth_b,reason,exact,gap,depth,leaves,wasted_n_v,wasted_n_p,"
        "wasted_operations,stage,missed_pairs,file\n";
    for (const WorstOfReason& worst : report.worst)
        for (const FalsePair& p : worst.pairs) {
            const Work& below = p.pair.below;
            text +=
                pair_row(p.frame, p.test, std::string(pass_reason_names[p.pair.reason]).c_str()) +
                "," + std::string(contact_names[p.pair.exact]) +
                format(p.pair.exact == Contact::disjoint ? ",%.17g,," : ",,%.17g,", p.margin) +
                row({p.pair.leaves, below.volume_tests, below.triangle_tests,
                     operations(report, below)}) +
                ",overlapping,," + file_of(report, p.frame, p.test) + "\n";
        }
    for (const WronglyRejectedPair& w : report.wrong)
        text += pair_row(w.frame, w.test, "wrongly rejected") + "," +
                std::string(contact_names[w.rejection.exact]) + ",,,,,,," +
                stage_words(report.header, w.test.stage) + "," +
                std::to_string(w.rejection.missed) + "," + file_of(report, w.frame, w.test) + "\n";
    return text;
}

}  // namespace scb::app
