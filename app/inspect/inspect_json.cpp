#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "app/inspect/inspect_findings.h"
#include "app/inspect/inspect_report.h"
#include "app/inspect/inspect_triangles.h"
#include "app/inspect/judgement_json.h"
#include "app/report/trace_report.h"
#include "core/platform/utf8.h"
#include "render/figures/inspect_figure.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

Json reasons_json(const InspectReport& report,
                  const std::array<std::uint64_t, pass_reason_count>& counts) {
    std::vector<PassReason> reasons = waste_reasons(report.header.kind);
    reasons.push_back(PassReason::triangles_meet);
    // In the order of their values.
    std::sort(reasons.begin(), reasons.end());
    Json json;
    for (const PassReason reason : reasons)
        json[std::string(pass_reason_names[reason])] = counts[static_cast<std::size_t>(reason)];
    return json;
}

/// Work as JSON, without the operations of tests that are not counted.
Json work_json(const InspectReport& report, const Work& work) {
    Json json = {{"n_v", work.volume_tests}, {"n_p", work.triangle_tests}};
    if (!report.header.engine && !is_of_distance(report.header.kind))
        json["operations"] = work.operations;
    return json;
}

/// What `of` gives for each reason of waste.
template <class Of>
Json wasted_by_json(const InspectReport& report, const Of& of) {
    Json json;
    std::vector<PassReason> reasons = waste_reasons(report.header.kind);
    std::sort(reasons.begin(), reasons.end());
    for (const PassReason reason : reasons)
        json[std::string(pass_reason_names[reason])] = of(reason);
    return json;
}

Json inspection_json(const InspectReport& report, const Inspection& i) {
    const auto work = [&report](const Work& of) { return work_json(report, of); };
    const bool is_distance = is_of_distance(report.header.kind);
    Json json;
    if (report.header.kind != QueryKind::distance) json["pairs"] = i.pairs;
    json.update(Json{{"n_v", i.counts.all.volume_tests},
                     {"n_p", i.counts.all.triangle_tests},
                     {"passed", i.counts.passed()},
                     {"inner", reasons_json(report, i.counts.inner)},
                     {"leaves", reasons_json(report, i.counts.leaves)}});
    if (!is_distance) json["touching"] = i.counts.touching;
    json.update(Json{{"wrongly_rejected", i.counts.wrongly_rejected},
                     {"missed_pairs", i.counts.missed},
                     {"work", work(i.counts.all)},
                     {"wasted", work(i.counts.wasted())},
                     {"wasted_by", wasted_by_json(report, [&](PassReason reason) {
                          return work(i.counts.wasted_by(reason));
                      })}});
    return json;
}

Json frame_json(const InspectReport& report, const InspectedFrame& frame) {
    Json json = {{"frame", frame.frame}};
    if (report.header.kind == QueryKind::distance) {
        json["distance"] = frame.distance < 0 ? Json() : Json(frame.distance);
        if (!report.recording) json["certified"] = frame.certified;
    }
    json.update(inspection_json(report, frame.found));
    return json;
}

Json pair_json(const InspectReport& report, const FalsePair& p) {
    Json json = {{"frame", p.frame},
                 {"nodes", {p.test.nodes.a, p.test.nodes.b}},
                 {"depths", {p.test.depth_a, p.test.depth_b}},
                 {"test", p.pair.test},
                 {"reason", pass_reason_names[p.pair.reason]}};
    if (is_of_distance(report.header.kind)) {
        const bool is_beyond = p.pair.exact == Contact::disjoint;
        json["beyond"] = is_beyond ? Json(p.pair.gap) : Json();
    } else {
        json["exact"] = contact_names[p.pair.exact];
        json[p.pair.exact == Contact::disjoint ? "gap" : "depth"] = p.margin;
    }
    json["leaves"] = p.pair.leaves;
    json["wasted"] = work_json(report, p.pair.below);
    if (report.drawn) json["file"] = file_of(report, p.frame, p.test);
    return json;
}

/// Adds the findings on waste.
void add_waste_json(Json& json, const InspectReport& report) {
    if (!report.recording && report.header.kind == QueryKind::distance) {
        const auto [distances, certified] = certified_count(report);
        json["distances"] = distances;
        json["certified"] = certified;
    }
    json["frames"] = Json::array();
    for (const InspectedFrame& frame : report.frames)
        json["frames"].push_back(frame_json(report, frame));
    json["sum"] = inspection_json(report, report.sum);
    json["depths"] = Json::array();
    for (std::size_t d = 0; d < report.sum.depths.size(); ++d) {
        const DepthInspection& at = report.sum.depths[d];
        json["depths"].push_back({{"depth", d},
                                  {"n_v", at.tests},
                                  {"passed", reasons_json(report, at.passed)},
                                  {"wasted", at.wasted.all()},
                                  {"wasted_by", wasted_by_json(report, [&at](PassReason reason) {
                                       return at.wasted.by(reason);
                                   })}});
    }
    json["triangles"] = triangles_table(report).json();
    json["worst"] = Json::array();
    for (const WorstOfReason& worst : report.worst)
        for (const FalsePair& p : worst.pairs) json["worst"].push_back(pair_json(report, p));
    json["worst_rejections"] = Json::array();
    for (const WronglyRejectedPair& w : report.wrong) {
        Json entry = {{"frame", w.frame},
                      {"nodes", {w.test.nodes.a, w.test.nodes.b}},
                      {"depths", {w.test.depth_a, w.test.depth_b}},
                      {"stage", stage_words(report.header, w.test.stage)},
                      {"missed_pairs", w.rejection.missed}};
        if (report.drawn) entry["file"] = file_of(report, w.frame, w.test);
        json["worst_rejections"].push_back(std::move(entry));
    }
    if (is_of_distance(report.header.kind)) return;
    json["other_tests"] = Json::array();
    for (const AlternativeTest& other : report.others) {
        Json entry = {{"test", overlap_test_name(other.overlap.test)}};
        if (has_threshold(other.overlap.test)) entry["threshold"] = other.overlap.threshold;
        entry.update(Json{{"caught", other.caught}, {"pairs", other.pairs}});
        entry.update(work_json(report, other.all));
        json["other_tests"].push_back(std::move(entry));
    }
}

}  // namespace

Json inspect_json(const InspectReport& report) {
    Json json = report.recording ? recording_json(report.recording->judged, report.recording->path)
                                 : trace_header_json(report.header);
    if (!report.recording) {
        add_waste_json(json, report);
    } else if (report.has_waste) {
        json["waste"]["left_out"] = report.header.engine->left_out;
        json["waste"]["bodies"] = {report.header.bodies[0].name, report.header.bodies[1].name};
        add_waste_json(json["waste"], report);
    }
    if (report.distance_advice) json["settings"] = advice_json(*report.distance_advice);
    if (report.settings) {
        json["settings"] = settings_json(*report.settings);
        if (has_advice(report) && report.settings->cuts)
            json["settings"]["cuts"] = cuts_json(report);
        if (has_advice(report) && report.settings->clean)
            json["settings"]["clean"] = clean_json(report);
    }
    return json;
}

}  // namespace scb::app
