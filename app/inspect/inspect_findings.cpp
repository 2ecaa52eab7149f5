#include "app/inspect/inspect_findings.h"

#include <algorithm>

#include "app/inspect/inspect_triangles.h"
#include "app/timing/tune_layout_report.h"
#include "app/timing/tune_report.h"
#include "core/analysis/assumed_time.h"
#include "core/base/statistics.h"
#include "core/base/text_format.h"
#include "core/platform/utf8.h"
#include "render/figures/bench_figure.h"
#include "render/figures/inspect_figure.h"
#include "render/figures/reason_words.h"
#include "render/overlay/figure_layout.h"

namespace scb::app {
namespace {

std::string triangles(const PassCounts& counts) {
    const std::uint64_t all = counts.all.triangle_tests, wasted = counts.wasted().triangle_tests;
    if (wasted == 0) return "";
    return " Of " + render::counted(all, "triangle test", "triangle tests") + " " +
           share(wasted, all) + " were.";
}

std::string waste(const InspectReport& report) {
    const PassCounts& counts = report.sum.counts;
    const std::uint64_t all = counts.all.volume_tests, wasted = counts.wasted().volume_tests;
    const std::string tests = render::counted(all, "volume test", "volume tests");
    if (wasted == 0) return "Of " + tests + " none was wasted." + triangles(counts);
    std::string text = "Of " + tests + ", " + share(wasted, all) + " were wasted: ";
    const std::vector<render::ReasonWords> reasons =
        render::reason_words(report.header.kind, counts);
    for (std::size_t i = 1; i < reasons.size(); ++i)
        text += (i == 1                   ? ""
                 : i + 1 < reasons.size() ? ", "
                                          : ", and ") +
                share(counts.wasted_by(reasons[i].reason).volume_tests, all) + " " +
                reasons[i].because;
    return text + "." + triangles(counts);
}

/// The other test that catches the most, if it saves operations.
std::vector<std::string> best_other(const InspectReport& report) {
    const Work& all = report.sum.counts.all;
    // If queries miss contacts, other tests cannot be compared with them.
    if (report.others.empty() || report.sum.counts.missed > 0) return {};
    const AlternativeTest& best = *std::max_element(
        report.others.begin(), report.others.end(),
        [](const AlternativeTest& x, const AlternativeTest& y) { return x.caught < y.caught; });
    if (best.caught == 0 || best.all.operations >= all.operations) return {};
    return {"Of the other tests, " + overlap_title(best.overlap) + " catches the most, " +
            render::count_text(best.caught) + " of the " +
            render::count_text(report.sum.counts.passed(PassReason::weak_test)) +
            " pairs whose volumes are disjoint: N_v " +
            render::change_text(all.volume_tests, best.all.volume_tests) + ", operations " +
            render::change_text(all.operations, best.all.operations) + "."};
}

/// " Their tests take 43 % of the cost.": `part` of all triangle tests.
std::string cost_share(const InspectReport& report, std::uint64_t part,
                       std::uint64_t all_triangle_tests) {
    if (part == 0) return "";
    const TestCosts costs = assumed_costs(report.header);
    const Work& all = report.sum.counts.all;
    const double of_triangles = costs.triangles * static_cast<double>(all.triangle_tests),
                 of_volumes = costs.volumes * static_cast<double>(all.volume_tests);
    const double taken = of_triangles * static_cast<double>(part) /
                         static_cast<double>(all_triangle_tests) / (of_triangles + of_volumes);
    return format(" Their tests take %.0f %% of the cost.", 100 * taken);
}

/// Properties of the meshes that make the volumes loose, a sentence each; and the share of the cost
/// of the tests that they concern.
std::vector<std::string> causes(const InspectReport& report) {
    const WasteCauses& found = report.causes;
    std::vector<std::string> sentences;
    const auto name = [&](std::size_t body) { return printable(report.header.bodies[body].name); };
    for (std::size_t i = 0; i < (found.alike ? 1 : 2); ++i) {
        const BodyCauses& body = found.bodies[i];
        const MeshFacts& facts = body.facts;
        // Triangles of one mesh are of both bodies.
        const auto share_of = [&](std::uint64_t tests) {
            return found.alike ? "" : cost_share(report, tests, report.triangles[i].tests);
        };
        const bool alike = found.alike && report.header.kind != QueryKind::self;
        const std::string of = render::counted(facts.triangles, "triangle", "triangles") + " of " +
                               name(i) + (alike ? ", and as many of " + name(1) + "," : "");
        if (body.slender)
            sentences.push_back(
                render::count_text(facts.slender()) + " of " + of +
                format(
                    " are slender (a side of 16 heights or more); the longest is "
                    "triangle %u, %.2g of the box's diagonal.",
                    facts.longest_slender,
                    ratio(facts.longest_slender_side, (facts.box.upper - facts.box.lower).norm())) +
                share_of(body.slender_tests));
        if (body.duplicated)
            sentences.push_back(render::count_text(facts.duplicates) + " of " + of +
                                " are copies of others: pairs with a copy are " +
                                (is_of_distance(report.header.kind) ? "measured" : "found") +
                                " again, and cost again." + share_of(body.duplicate_tests));
        if (body.soup)
            sentences.push_back(of + " fall into " + render::count_text(facts.components) +
                                " parts that have no corner in common: a soup, whose volumes "
                                "overlap wherever it is cut.");
        if (body.deep)
            sentences.push_back(
                format("The hierarchy of %s is %d levels deep, for ", name(i).c_str(), body.depth) +
                render::counted(facts.triangles, "triangle", "triangles") +
                ": it is out of balance.");
    }
    if (found.unequal)
        sentences.push_back(
            format("%s is %.3g times as large as %s: its nodes are divided first, until they are "
                   "as small.",
                   name(found.larger > 1 ? 0 : 1).c_str(),
                   found.larger > 1 ? found.larger : 1 / found.larger,
                   name(found.larger > 1 ? 1 : 0).c_str()));
    if (found.parallel)
        sentences.push_back(
            share(found.vain.parallel, found.vain.tests) +
            " of the triangles that were tested in vain are within ten degrees of "
            "parallel: surfaces that lie close to each other." +
            cost_share(report, found.vain.parallel, report.sum.counts.all.triangle_tests));
    return sentences;
}

/// The arithmetic that decides the triangle tests of the advised layout, if floats leave a tenth of
/// them open.
std::vector<std::string> decisions(const InspectReport& report) {
    if (!has_advice(report)) return {};
    const SceneTuning& tuning = report.settings->tuning;
    const TuneLayout* const layout = tuning.cheapest_layout();
    if (!layout || 10 * layout->n_exact < layout->n_p || layout->n_p == 0) return {};
    return {"With the advised " + packed_layout_name(layout->layout) + ", " +
            share(layout->n_p - layout->n_exact, layout->n_p) +
            " of the triangle tests are decided in floats, " +
            share(layout->n_exact - layout->n_after_doubles, layout->n_p) + " in doubles, and " +
            share(layout->n_after_doubles, layout->n_p) +
            " exactly: triangles that touch, or lie in one plane, take longer."};
}

/// The best setting of this project for the queries of a recording.
std::string recorded_advice(const InspectSettings& settings) {
    const SceneTuning& tuning = settings.tuning;
    const TuneLayout* const layout = tuning.cheapest_layout();
    const std::string where = " in " + render::frames_text(tuning.frames);
    if (settings.packed_cost) {
        const std::uint64_t least =
            layout ? layout->picoseconds : tuning.rows[tuning.recommended()].counts.picoseconds;
        if (least >= *settings.packed_cost)
            return "No setting costs less than the inspected queries" + where + ".";
        return "Best setting" + where + ": " + recommended_text(tuning) +
               format(", with %.3f of the cost of the inspected queries.",
                      multiple_of(least, *settings.packed_cost));
    }
    const Work found = layout ? Work{layout->n_v, layout->n_p}
                              : tuning.rows[tuning.recommended()].counts,
               &recorded = *settings.recorded;
    std::string text = "Best of this project's hierarchies" + where + ": " +
                       recommended_text(tuning) +
                       format(", with %.2f of the recorded N_v",
                              multiple_of(found.volume_tests, recorded.volume_tests));
    if (recorded.triangle_tests > 0)
        text +=
            format(" and %.2f of N_p", multiple_of(found.triangle_tests, recorded.triangle_tests));
    return text + ".";
}

}  // namespace

std::string missed_words(const WrongRejection& rejection) {
    return render::counted(rejection.missed, "pair", "pairs") + " of triangles missed";
}

std::string wrong_rejections_sentence(const PassCounts& counts, QueryKind kind) {
    if (is_of_distance(kind))
        return "the bound left out " + render::counted(counts.wrongly_rejected, "pair", "pairs") +
               " of volumes that are nearer than the answer, and so missed " +
               (counts.missed == 0 ? "no pairs" : render::counted(counts.missed, "pair", "pairs")) +
               " of triangles.";
    return "the test rejected " + render::counted(counts.wrongly_rejected, "pair", "pairs") +
           " of volumes that meet, and so missed " +
           (counts.missed == 0 ? "no pairs" : render::counted(counts.missed, "pair", "pairs")) +
           " of triangles that intersect.";
}

std::vector<std::string> alarm_findings(const InspectReport& report) {
    if (report.sum.counts.wrongly_rejected == 0) return {};
    std::string alarm = wrong_rejections_sentence(report.sum.counts, report.header.kind);
    alarm.front() = 'T';
    return {alarm};
}

CertifiedCount certified_count(const InspectReport& report) {
    CertifiedCount count;
    for (const InspectedFrame& frame : report.frames) {
        count.distances += frame.distance >= 0 ? 1 : 0;
        count.certified += frame.certified ? 1 : 0;
    }
    return count;
}

std::vector<std::string> certified_findings(const InspectReport& report) {
    if (report.recording || report.header.kind != QueryKind::distance) return {};
    if (report.header.distance.relative_error > 0)
        return {"Distances are not certified, since --relative-error lets them be too large."};
    const auto [distances, certified] = certified_count(report);
    if (distances == 0) return {"No triangles are within the limit."};
    return {render::count_text(certified) + " of " +
            render::counted(distances, "distance", "distances") + " certified."};
}

bool has_enough_tests(const InspectReport& report) {
    // Of fewer tests, the next pose may say the opposite.
    constexpr std::uint64_t least_tests = 100;
    const Work& all = report.sum.counts.all;
    return all.volume_tests + all.triangle_tests >= least_tests;
}

bool has_advice(const InspectReport& report) {
    return report.settings && (report.settings->recorded || has_enough_tests(report));
}

std::vector<std::string> advice_findings(const InspectReport& report) {
    if (report.distance_advice) return {advice_sentence(*report.distance_advice)};
    if (!report.settings) return {};
    const SceneTuning& tuning = report.settings->tuning;
    if (report.settings->recorded) return {recorded_advice(*report.settings)};
    if (!has_advice(report))
        return {"Too few tests to advise: " +
                render::counted(report.sum.counts.all.volume_tests, "volume test", "volume tests") +
                "."};
    std::string best = best_sentences(tuning, "the present setting").front();
    const std::size_t frames = report.frames.size();
    best.insert(best.find(": "),
                (frames == 1 ? " in " : " ") + settings_words(tuning, frames, "over"));
    if (!tuning.timed()) best += " Cost: assumed time of the tests.";
    return {best};
}

std::vector<std::string> waste_findings(const InspectReport& report) {
    std::vector<std::string> sentences;
    const PassCounts& counts = report.sum.counts;
    sentences.push_back(waste(report));
    for (std::string& sentence : best_other(report)) sentences.push_back(std::move(sentence));
    for (std::string& sentence : triangle_sentences(report))
        sentences.push_back(std::move(sentence));
    if (counts.wasted().volume_tests > 0)
        for (std::string& sentence : causes(report)) sentences.push_back(std::move(sentence));
    for (std::string& sentence : decisions(report)) sentences.push_back(std::move(sentence));
    return sentences;
}

std::vector<std::string> inspect_findings(const InspectReport& report) {
    std::vector<std::string> all = alarm_findings(report);
    for (const auto& some : {certified_findings(report), advice_findings(report),
                             mesh_sentences(report), waste_findings(report)})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace scb::app
