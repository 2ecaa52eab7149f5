#include "core/trace_words.h"

namespace scb {
namespace {

std::string pair_text(std::uint32_t a, std::uint32_t b) {
    return "(" + std::to_string(a) + ", " + std::to_string(b) + ")";
}

std::string side_of(const std::optional<TracedTest>& test) {
    if (!test) return "had ended";
    return "tested " + words_of(test->test) + ": " + words_of(*test);
}

}  // namespace

std::string words_of(const VolumeTest& test) {
    return "the nodes " + pair_text(test.nodes.a, test.nodes.b) + " at depths " +
           pair_text(test.depth_a, test.depth_b);
}

std::string words_of(const TracedTest& test) {
    const std::string triangles =
        test.triangles ? pair_text(test.triangles->triangles.a, test.triangles->triangles.b) : "";
    switch (test.outcome) {
        case Outcome::rejected:
            return "rejected at " + std::string(stage_name(test.test.stage));
        case Outcome::divided_a:
            return "overlap, passed on to the children of A's node";
        case Outcome::divided_b:
            return "overlap, passed on to the children of B's node";
        case Outcome::triangles_apart:
            return "overlap; their triangles " + triangles + " do not intersect";
        case Outcome::triangles_meet:
            return "overlap; their triangles " + triangles + " intersect";
        case Outcome::found:
            return "overlap, found at the level to stop at";
        case Outcome::left_over:
            return "overlap, left over when the query had its pairs";
    }
    return {};
}

std::string words_of_parent(const TracedTest& test) {
    if (!test.parent) return "the roots";
    return "reached from " + words_of(*test.parent) + ", where " +
           (test.parent_outcome == Outcome::divided_a ? "A's" : "B's") + " node was divided";
}

std::string words_of(const Parting& parting) {
    std::string text = "frame " + std::to_string(parting.frame) + ", test " +
                       std::to_string(parting.test) + ", where\n  A " + side_of(parting.a) +
                       ",\n  B " + side_of(parting.b) + ",\n  ";
    const std::string from_a = parting.a ? words_of_parent(*parting.a) : "";
    const std::string from_b = parting.b ? words_of_parent(*parting.b) : "";
    if (from_a.empty() || from_b.empty() || from_a == from_b)
        return text + (from_a.empty() ? from_b : from_a) + ".\n";
    return text + "A " + from_a + ",\n  B " + from_b + ".\n";
}

}  // namespace scb
