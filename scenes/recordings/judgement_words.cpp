#include "scenes/recordings/judgement_words.h"

#include <cmath>

#include "core/analysis/trace.h"
#include "core/base/enum_names.h"
#include "core/base/text_format.h"
#include "core/judge/tree_check.h"

namespace scb::scenes {
namespace {

constexpr EnumNames<PairCause, pair_cause_count> cause_names = {
    "the tree has no nodes",
    "a triangle is in no leaf",
    "rejected at a node that does not contain the triangle",
    "rejected at a node whose volume is none",
    "rejected although the volumes overlap",
    "rejected by a test that is not proven wrong",
    "the children of two overlapping nodes were never tested",
    "below a node that does not contain the triangle",
    "below a node whose volume is none",
    "no tests of volumes were recorded, so that the cause is not known",
    "no test of nodes above the triangles was made",
    "the triangles of two overlapping leaves were never tested",
    "the test of the two triangles said that they are apart",
    "found, but not reported",
    "reported although their test said that they are apart",
    "the test of the two triangles said that they meet",
    "reported without a test of the two triangles",
    "the two triangles share a vertex and meet nowhere else",
    "one of the two does not exist",
    "reported twice",
};

/// The same in a query of distances.
constexpr EnumNames<PairCause, pair_cause_count> distance_cause_names = {
    "the tree has no nodes",
    "a triangle is in no leaf",
    "left out at a node that does not contain the triangle",
    "left out at a node whose volume is none",
    "left out although the volumes are nearer",
    "left out by a test that is not proven wrong",
    "the children of two near nodes were never tested",
    "below a node that does not contain the triangle",
    "below a node whose volume is none",
    "no tests of volumes were recorded, so that the cause is not known",
    "no test of nodes above the triangles was made",
    "the triangles of two near leaves were never measured",
    "the two triangles were measured as farther apart",
    "measured, but not reported",
    "reported although they were measured as farther apart",
    "the two triangles were measured as near enough",
    "reported without a measurement of the two triangles",
    "the two triangles share a vertex and meet nowhere else",
    "one of the two does not exist",
    "reported twice",
};

constexpr EnumNames<AnswerFault, answer_fault_count> answer_names = {
    "no distance was found, though triangles are nearer than the limit",
    "the distance is no number, or negative",
    "the distance is too large",
    "the distance is too small",
    "the named triangles do not exist",
    "the named triangles are exchanged: the first is of B, the second of A",
    "the named triangles have another distance",
    "the closest points are not finite",
    "the closest points are exchanged: the first is of B, the second of A",
    "the closest points are in the frames of their bodies, not in the world",
    "the closest points are in the frame of A, not in the world",
    "a closest point is not on its triangle",
    "the closest points have another distance",
};

constexpr EnumNames<TreeFault, tree_fault_count> fault_names = {
    "nodes are described twice",
    "children are not described",
    "nodes are children of two nodes",
    "nodes name another parent than the one that lists them",
    "nodes are not listed by the parent that they name",
    "nodes are in cycles, or below them",
    "triangles are in no leaf",
    "triangles of leaves are none of the mesh",
    "triangles have vertices that are not finite",
    "nodes have volumes that are none",
    "nodes have no volume",
    "nodes do not contain what is below them",
    "nodes do not contain their parts of triangles",
};

/// The words for items that are objects.
std::string for_objects(std::string words) {
    constexpr std::string_view triangle = "triangle", object = "object";
    for (std::size_t at = words.find(triangle); at != std::string::npos;
         at = words.find(triangle, at + object.size()))
        words.replace(at, triangle.size(), object);
    return words;
}

}  // namespace

bool is_of_distance(const EngineQuery& query) { return is_of_distance(query.kind); }

std::string fault_words(TreeFault fault) { return std::string(fault_names[fault]); }
std::string fault_words(AnswerFault fault) { return std::string(answer_names[fault]); }

std::string words_of(const AnswerProblem& problem) {
    const auto is_named = problem.items.a != no_index && problem.items.b != no_index;
    std::string words =
        is_named ? pair_words("triangles", problem.items.a, problem.items.b) + ": " : std::string();
    words += std::isinf(problem.recorded) && problem.fault == AnswerFault::none
                 ? "nothing was recorded"
                 : format("%.9g was recorded", problem.recorded);
    if (problem.fault == AnswerFault::point_outside)
        words += std::string("; the point of ") + (*problem.side == 0 ? "A" : "B") + " is " +
                 amount_words(problem.amount) + " from its triangle";
    else if (problem.fault == AnswerFault::triangles_apart)
        words += format(", and they are %.9g apart", problem.exact);
    else if (problem.fault == AnswerFault::points_apart)
        words += format(", and they are %.9g apart", problem.exact) +
                 (!problem.side        ? ""
                  : *problem.side == 0 ? "; the point of B is as near to the triangle of A as the "
                                         "distance, so the point of A is wrong"
                                       : "; the point of A is as near to the triangle of B as the "
                                         "distance, so the point of B is wrong");
    else if (std::isfinite(problem.exact))
        words += format(", and the distance is %.9g", problem.exact);
    switch (problem.cause) {
        case AnswerCause::unknown:
            break;
        case AnswerCause::square:
            return words + "; the square of the distance was recorded";
        case AnswerCause::root:
            return words + "; the square root of the distance was recorded";
        case AnswerCause::unit:
            return words + format("; it is %.6g times the distance, as in another unit of length",
                                  problem.factor);
        case AnswerCause::frame_before:
            return words + "; it is the distance of an earlier frame";
    }
    return words;
}

std::string pair_words(const std::string& what, std::uint32_t a, std::uint32_t b) {
    return what + " " + std::to_string(a) + " of A and " + std::to_string(b) + " of B";
}

std::string query_words(const QueryName& query) {
    return "frame " + std::to_string(query.frame) + ", " + query.a + " and " + query.b +
           (query.name.empty() ? "" : " (\"" + shown(query.name) + "\")");
}

std::string test_words(std::uint32_t number) {
    return number == no_index ? "" : ", test " + std::to_string(number);
}

std::string stage_words(const StageNames& stages, std::uint8_t stage) {
    if (stage == 0) return "overlap";
    const auto found = stages.find(stage);
    return found == stages.end() ? "stage " + std::to_string(stage) : found->second;
}

std::string tree_words(const RecordedQueries& recording, std::uint32_t tree) {
    const std::string& name = recording.trees().at(tree).name;
    return "tree " + std::to_string(tree) + (name.empty() ? "" : " \"" + name + "\"");
}

std::string words_of(const EngineQuery& query, PairCause cause) {
    const std::string words((is_of_distance(query) ? distance_cause_names : cause_names)[cause]);
    return query.sides[0].mesh ? words : for_objects(words);
}

std::string words_of(const EngineQuery& query, const PairProblem& problem, std::uint32_t test,
                     const StageNames& stages) {
    const std::string what = query.sides[0].mesh ? "triangle" : "object";
    std::string words = pair_words((what + "s").c_str(), problem.items.a, problem.items.b);
    const std::uint32_t item = problem.side == 0 ? problem.items.a : problem.items.b,
                        node = problem.side == 0 ? problem.nodes.a : problem.nodes.b;
    const std::string side = problem.side == 0 ? "A" : "B";
    const std::string of_node = "node " + std::to_string(node) + " of " + side;
    if (problem.cause == PairCause::in_no_leaf)
        words += "; no leaf of " + side + " has " + what + " " + std::to_string(item);
    if (problem.cause == PairCause::no_tree)
        words += "; the tree of " + side + " was recorded without nodes";
    if (problem.nodes.a != no_index && problem.nodes.b != no_index)
        words += "; at " + pair_words("nodes", problem.nodes.a, problem.nodes.b);
    if (problem.cause == PairCause::not_contained)
        words += ", of which " + of_node + " does not contain " + what + " " +
                 std::to_string(item) + ", by " + amount_words(problem.amount) +
                 (problem.deepest == no_index
                      ? ""
                      : "; nor does node " + std::to_string(problem.deepest) + " below it");
    if (problem.cause == PairCause::below_outside)
        words += "; " + of_node + " does not contain " + what + " " + std::to_string(item) +
                 ", by " + amount_words(problem.amount);
    if (problem.cause == PairCause::bad_volume)
        words += ", of which " + of_node + " has a volume that is none";
    if (problem.cause == PairCause::below_bad_volume)
        words += "; " + of_node + " has a volume that is none";
    if (problem.cause == PairCause::never_visited) {
        std::string next;
        if (problem.next.a != no_index) next = "node " + std::to_string(problem.next.a) + " of A";
        if (problem.next.b != no_index)
            next += (next.empty() ? "node " : ", to node ") + std::to_string(problem.next.b) +
                    " of B" + (next.empty() ? "" : ", or to both");
        words += ", from which the way leads to " + next;
    }
    words += test_words(test);
    if (problem.event != no_index && problem.event < query.events.size() &&
        query.events[problem.event].kind == EngineEvent::Kind::volumes &&
        query.events[problem.event].stage != 0)
        words += ", stage \"" + stage_words(stages, query.events[problem.event].stage) + "\"";
    return words;
}

}  // namespace scb::scenes
