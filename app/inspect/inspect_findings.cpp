#include "app/inspect/inspect_findings.h"

#include <algorithm>

#include "app/timing/tune_report.h"
#include "core/base/statistics.h"
#include "core/base/text_format.h"
#include "core/platform/utf8.h"
#include "render/figures/inspect_figure.h"
#include "render/overlay/figure_layout.h"

namespace scb::app {
namespace {

std::string triangles(const PassCounts& counts) {
    const std::uint64_t all = counts.all.triangle_tests, wasted = counts.wasted.triangle_tests;
    if (wasted == 0) return "";
    return " Of " + render::counted(all, "triangle test", "triangle tests") + " " +
           share(wasted, all) + " were.";
}

std::string waste(const InspectReport& report) {
    const PassCounts& counts = report.sum.counts;
    const std::uint64_t all = counts.all.volume_tests, wasted = counts.wasted.volume_tests,
                        by_tests = counts.wasted_by_tests.volume_tests;
    const std::string tests = render::counted(all, "volume test", "volume tests");
    if (wasted == 0) return "Of " + tests + " none was wasted." + triangles(counts);
    return "Of " + tests + ", " + share(wasted, all) +
           " were wasted: " + share(wasted - by_tests, all) + " since volumes are too loose, and " +
           share(by_tests, all) + " since the overlap test is too weak." + triangles(counts);
}

std::string worst_frame(const InspectReport& report) {
    const InspectedFrame& frame = report.frames.front();
    return "Frame " + std::to_string(frame.frame) + " wastes the most: " +
           render::counted(frame.found.counts.wasted.volume_tests, "volume test.", "volume tests.");
}

/// Where the waste is: the least depth down to which half of it occurs.
std::string where(const InspectReport& report) {
    const std::vector<DepthInspection>& depths = report.sum.depths;
    const std::uint64_t wasted = report.sum.counts.wasted.volume_tests;
    std::uint64_t so_far = 0;
    std::size_t depth = 0;
    for (; depth < depths.size(); ++depth) {
        so_far += depths[depth].wasted;
        if (2 * so_far >= wasted) break;
    }
    const auto worst = std::max_element(
        depths.begin(), depths.end(),
        [](const DepthInspection& x, const DepthInspection& y) { return x.wasted < y.wasted; });
    return format("Half of the waste is at depths up to %zu of %zu; depth %zu alone has the most.",
                  depth, depths.size() - 1, static_cast<std::size_t>(worst - depths.begin()));
}

std::string change(std::uint64_t from, std::uint64_t to, const char* saves, const char* takes) {
    const double ratio = static_cast<double>(to) / static_cast<double>(from);
    return format("%s %.1f %%", ratio < 1 ? saves : takes, 100 * std::abs(ratio - 1));
}

std::string best_other(const InspectReport& report) {
    const Work& all = report.sum.counts.all;
    const AlternativeTest& best = *std::max_element(
        report.others.begin(), report.others.end(),
        [](const AlternativeTest& x, const AlternativeTest& y) { return x.caught < y.caught; });
    const std::string weak = render::count_text(report.sum.counts.passed(PassReason::weak_test));
    if (best.caught == 0)
        return "None of the other tests catches any of the " + weak +
               " pairs whose volumes are disjoint.";
    return "Of the other tests, " + overlap_title(best.overlap) + " catches the most, " +
           render::count_text(best.caught) + " of the " + weak +
           " pairs whose volumes are disjoint: it " +
           change(all.volume_tests, best.all.volume_tests, "saves", "makes") +
           (best.all.volume_tests < all.volume_tests ? " of the volume tests"
                                                     : " more volume tests") +
           " and " + change(all.operations, best.all.operations, "saves", "takes") +
           (best.all.operations < all.operations ? " of the operations." : " more operations.");
}

/// Properties of the meshes that make the volumes loose, a sentence each.
std::vector<std::string> causes(const InspectReport& report) {
    const WasteCauses& found = report.causes;
    std::vector<std::string> sentences;
    const auto name = [&](std::size_t body) { return printable(report.header.bodies[body].name); };
    for (std::size_t i = 0; i < (found.alike ? 1 : 2); ++i) {
        const BodyCauses& body = found.bodies[i];
        const MeshFacts& facts = body.facts;
        const bool alike = found.alike && report.header.kind != QueryKind::self;
        const std::string of = render::counted(facts.triangles, "triangle", "triangles") + " of " +
                               name(i) + (alike ? ", and as many of " + name(1) + "," : "");
        if (body.slender)
            sentences.push_back(
                render::count_text(facts.slender()) + " of " + of +
                format(
                    " are slender (a side 16 times the height on it, or more); the longest is "
                    "triangle %u, %.2g of the diagonal of the body's box.",
                    facts.longest_slender,
                    ratio(facts.longest_slender_side, (facts.box.upper - facts.box.lower).norm())));
        if (body.duplicated)
            sentences.push_back(render::count_text(facts.duplicates) + " of " + of +
                                " are there twice: each pair is found twice, and costs twice.");
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
        sentences.push_back(share(found.vain.parallel, found.vain.tests) +
                            " of the triangles that were tested in vain are within ten degrees of "
                            "parallel: surfaces that lie close to each other.");
    return sentences;
}

/// The setting that would have helped most. The table has the others.
std::string best_setting(const SceneTuning& tuning) {
    std::string text = best_sentences(tuning, "the present setting").front();
    if (!tuning.timed()) text += std::string(" Cost: ") + cost_words + ".";
    return text;
}

}  // namespace

std::string missed_words(const WrongRejection& rejection) {
    return render::counted(rejection.missed, "pair", "pairs") + " of triangles missed";
}

std::string wrong_rejections_sentence(const PassCounts& counts) {
    return "the test rejected " + render::counted(counts.wrongly_rejected, "pair", "pairs") +
           " of volumes that meet, and so missed " +
           (counts.missed == 0 ? "no pairs" : render::counted(counts.missed, "pair", "pairs")) +
           " of triangles that intersect.";
}

std::vector<std::string> inspect_findings(const InspectReport& report) {
    std::vector<std::string> sentences;
    const PassCounts& counts = report.sum.counts;
    if (counts.wrongly_rejected > 0) {
        sentences.push_back(wrong_rejections_sentence(counts));
        sentences.back().front() = 'T';
    }
    sentences.push_back(waste(report));
    if (counts.wasted.volume_tests > 0) {
        if (report.frames.size() > 1) sentences.push_back(worst_frame(report));
        sentences.push_back(where(report));
    }
    // If queries miss contacts, other tests cannot be compared with them.
    if (!report.others.empty() && counts.passed(PassReason::weak_test) > 0 && counts.missed == 0)
        sentences.push_back(best_other(report));
    if (counts.wasted.volume_tests > 0)
        for (std::string& sentence : causes(report)) sentences.push_back(std::move(sentence));
    if (report.settings && !report.settings->recorded)
        sentences.push_back(best_setting(report.settings->tuning));
    return sentences;
}

}  // namespace scb::app
