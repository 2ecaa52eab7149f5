#include "core/analysis/trace_words.h"

namespace scb {
namespace {

std::string pair_text(std::uint32_t a, std::uint32_t b) {
    return "(" + std::to_string(a) + ", " + std::to_string(b) + ")";
}

std::string side_of(const std::optional<TracedTest>& test, const BodyNames& bodies) {
    if (!test) return "had ended";
    return "tested " + words_of(test->test) + ": " + words_of(*test, bodies);
}

std::string triangles_text(const TracedTest& test) {
    return test.triangles ? pair_text(test.triangles->items.a, test.triangles->items.b) : "";
}

/// The words about the triangles of two leaves: one pair, or how many of several.
std::string words_of_leaves(const TracedTest& test) {
    const bool is_within = test.kind == QueryKind::within, hits = test.intersecting > 0;
    if (test.triangle_tests > 1)
        return "of " + std::to_string(test.triangle_tests) + " pairs of their triangles " +
               (hits ? std::to_string(test.intersecting) : "none") +
               (is_within               ? " within the tolerance"
                : test.intersecting > 1 ? " were nearer than all before"
                                        : " was nearer than all before") +
               (hits ? ", the first " + triangles_text(test) : "");
    return "their triangles " + triangles_text(test) +
           (is_within ? (hits ? " are within the tolerance" : " are farther than the tolerance")
                      : (hits ? " were nearer than all before" : " were not nearer"));
}

/// words_of a test in a query of distances.
std::string words_of_bound(const TracedTest& test, const BodyNames& bodies) {
    // Recordings have a stage of this name.
    if (is_rejection(test.outcome))
        return test.stage.starts_with("left out") ? test.stage : "left out at " + test.stage;
    switch (test.outcome) {
        case Stage::divided_a:
            return "near, passed on to the children of " + bodies[0] + "'s node";
        case Stage::divided_b:
            return "near, passed on to the children of " + bodies[1] + "'s node";
        case Stage::divided_both:
            return "near, passed on to the children of both";
        case Stage::triangles_apart:
        case Stage::triangles_meet:
            return "near; " + words_of_leaves(test);
        case Stage::found:
            return "near, found";
        case Stage::left_over:
            return "near, not needed any more";
        default:
            return {};
    }
}

}  // namespace

std::string words_of(const Step& test) {
    return "the nodes " + pair_text(test.nodes.a, test.nodes.b) + " at depths " +
           pair_text(test.depth_a, test.depth_b);
}

std::string words_of(const TracedTest& test, const BodyNames& bodies) {
    if (is_of_distance(test.kind)) return words_of_bound(test, bodies);
    const std::string triangles = triangles_text(test);
    if (is_rejection(test.outcome)) return "rejected at " + test.stage;
    switch (test.outcome) {
        case Stage::divided_a:
            return "overlap, passed on to the children of " + bodies[0] + "'s node";
        case Stage::divided_b:
            return "overlap, passed on to the children of " + bodies[1] + "'s node";
        case Stage::divided_both:
            return "overlap, passed on to the children of both";
        case Stage::triangles_apart:
            return "overlap; " + (test.triangle_tests > 1
                                      ? "of " + std::to_string(test.triangle_tests) +
                                            " pairs of their triangles none intersects"
                                      : "their triangles " + triangles + " do not intersect");
        case Stage::triangles_meet:
            return "overlap; " +
                   (test.triangle_tests > 1
                        ? "of " + std::to_string(test.triangle_tests) +
                              " pairs of their triangles " + std::to_string(test.intersecting) +
                              (test.intersecting == 1 ? " intersects, "
                                                      : " intersect, the first ") +
                              triangles
                        : "their triangles " + triangles + " intersect");
        case Stage::found:
            return "overlap, found at the level to stop at";
        case Stage::neighbors:
            return "overlap; their triangles " + triangles + " share a vertex";
        case Stage::left_over:
            return "overlap, left over when the query had its pairs";
        default:
            return {};
    }
}

std::string words_of_parent(const TracedTest& test, const BodyNames& bodies) {
    if (!test.parent) return "these are the roots";
    const std::string divided =
        test.parent_outcome == Stage::divided_both
            ? "both nodes were"
            : bodies[test.parent_outcome == Stage::divided_a ? 0 : 1] + "'s node was";
    return "reached from " + words_of(*test.parent) + ", where " + divided + " divided";
}

std::string words_of(const Parting& parting, const BodyNames& bodies, const TraceNames& names) {
    std::string text = "frame " + std::to_string(parting.frame) + ", test " +
                       std::to_string(parting.test) + ", where\n  the " + names.a + " " +
                       side_of(parting.a, bodies) + ",\n  the " + names.b + " " +
                       side_of(parting.b, bodies) + ",\n  ";
    const std::string from_a = parting.a ? words_of_parent(*parting.a, bodies) : "";
    const std::string from_b = parting.b ? words_of_parent(*parting.b, bodies) : "";
    if (from_a.empty() || from_b.empty() || from_a == from_b)
        return text + (from_a.empty() ? from_b : from_a) + ".\n";
    return text + "the " + names.a + " " + from_a + ",\n  the " + names.b + " " + from_b + ".\n";
}

std::string words_of(const LostPair& lost, bool of_nodes, const BodyNames& bodies,
                     const TraceNames& names) {
    const std::string what =
        "frame " + std::to_string(lost.frame) + ", the " + (of_nodes ? "nodes " : "triangles ") +
        pair_text(lost.pair.a, lost.pair.b) + ": the " + (lost.found_by_a ? names.b : names.a);
    if (!lost.lost_at)
        return what + (lost.other_ended ? " had ended" : " has no test that contains them");
    return what + " left them out at test " + std::to_string(lost.test) + ", " +
           words_of(lost.lost_at->test) + ": " + words_of(*lost.lost_at, bodies);
}

}  // namespace scb
