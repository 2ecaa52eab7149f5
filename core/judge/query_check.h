#pragma once

#include <functional>
#include <map>
#include <string>

#include "core/analysis/pass_counts.h"
#include "core/explain/contact_certificate.h"
#include "core/judge/answer_check.h"
#include "core/judge/engine_query.h"
#include "core/judge/node_contact.h"

namespace scb {

struct JudgedTest {
    std::uint32_t event = 0;          ///< index into EngineQuery::events
    IndexPair nodes;                  ///< indices; no_index: a node that the tree does not have
    std::uint32_t parent = no_index;  ///< the judged test that led to it, recorded or inferred
    TestVerdict verdict = TestVerdict::unjudged;
    bool repeated = false;  ///< the query had made the test before
    /// The query found items that meet below it or, in a query of distances, items below it are as
    /// near as the closest.
    bool meets = false;
    /// In a query of distances: no test followed, and the recorded bound explains why.
    bool left_out = false;
    /// A false positive whose recorded bound is above the answer, which was not known yet.
    bool early = false;
    /// A lower bound of the gap or depth of the volumes; 0 if they touch.
    double margin = 0;

    /// Whether the verdict is proven. Of a query of distances, volumes that touch the answer have
    /// none.
    bool is_proven(QueryKind kind) const;
};

/// Whether the results of a query of distances were judged, and why not.
enum class AnswerState : std::uint8_t {
    judged,
    not_of_triangles,  ///< of objects, or of a body to itself
    not_recorded,      ///< the recording has no distances
    not_certified,     ///< no certificate proves the distance
};

/// A recorded bound that is larger than the distance of the volumes.
struct WrongBound {
    std::uint32_t test = 0;  ///< the judged test
    double bound = 0;        ///< as recorded: any number
    /// A lower bound of how much too large it is; infinity if it is no number.
    double excess = 0;
};

/// Why a pair that intersects was not reported or, from `reported_in_spite` on, why a reported pair
/// is wrong.
enum class PairCause : std::uint8_t {
    no_tree,            ///< no node of the tree was recorded
    in_no_leaf,         ///< no reachable node has the triangle
    not_contained,      ///< rejected at a node that does not contain the triangle
    bad_volume,         ///< rejected at a node with an invalid volume
    rejected,           ///< rejected although the volumes overlap
    rejected_unproven,  ///< rejected by a test that is not proven wrong
    never_visited,      ///< the nodes overlapped, but nodes below them were not tested
    below_outside,      ///< no test was recorded, and a node above does not contain the triangle
    below_bad_volume,   ///< no test was recorded, and a node above has an invalid volume
    no_tests,           ///< the query has no tests of volumes, so the cause is unknown
    never_tested,       ///< no test of two nodes above the pair was recorded
    items_not_tested,   ///< the leaves overlapped, but the triangles were not tested
    items_apart,        ///< the test of the two triangles found them apart
    not_reported,       ///< the test found that they meet, but the pair was not reported
    reported_in_spite,  ///< reported although the test of the two triangles found them apart
    items_meet,         ///< the test of the two triangles found that they meet
    reported_untested,  ///< reported without a test
    neighbours,         ///< in one mesh: the triangles share a vertex and meet nowhere else
    unknown_item,       ///< one of the two items does not exist
    reported_twice,
};
inline constexpr std::size_t pair_cause_count = 20;
inline bool is_missed(PairCause cause) { return cause < PairCause::reported_in_spite; }

/// A pair of items that was missed or wrongly reported, and the cause.
struct PairProblem {
    IndexPair items;
    PairCause cause{};
    /// The numbers of the nodes at fault; no_index if unknown or not applicable.
    IndexPair nodes{no_index, no_index};
    /// never_visited: the numbers of the next nodes on the way to the pair.
    IndexPair next{no_index, no_index};
    std::uint32_t event = no_index;  ///< index of the event at fault
    /// The judged test of this event or, for a test of items, the judged test that led to it.
    std::uint32_t test = no_index;
    std::uint32_t side = 0;  ///< side of the triangle and node at fault: 0 for A, 1 for B
    double amount = 0;       ///< how far the triangle is outside of the node, if not contained
    /// not_contained: the number of the deepest node below that does not contain the triangle
    /// either; no_index: none.
    std::uint32_t deepest = no_index;

    friend bool operator==(const PairProblem&, const PairProblem&) = default;
};

/// A test of two items that was wrong by more than the tolerance.
struct WrongItemTest {
    std::uint32_t event = 0;        ///< index into EngineQuery::events
    std::uint32_t test = no_index;  ///< the judged test that led to it
    double margin = 0;              ///< gap or depth of the two items
    bool strayed = false;  ///< no nodes that hold the items were tested with each other before
    bool unknown = false;  ///< one of the two items does not exist
};

/// Counts of tests that divided a node (`divided`), and of those that skipped an overlapping child
/// (`lacking`); see check_divisions.
struct DivisionCounts {
    struct Lack {
        std::uint32_t test = no_index;  ///< the judged test
        std::uint32_t side = 0;         ///< side of the divided node: 0 for A, 1 for B
        std::uint32_t child = 0;        ///< the number of the first skipped child
        std::uint32_t place = 0;        ///< index of this child among the children, from 0
    };
    std::uint64_t divided = 0, lacking = 0;
    Lack first;
    bool alike = true;  ///< all skip the child at the same place of the same side
};

/// The judgement of a query.
struct QueryJudgement {
    std::vector<JudgedTest> tests;  ///< of volumes, in order
    std::uint64_t item_tests = 0;
    std::vector<WrongItemTest> wrong_item_tests;
    /// Tests of items that are not in the two leaves that overlapped last, nor in other leaves that
    /// were tested; with the judged test before. Tests in wrong_item_tests are left out.
    std::vector<WrongItemTest> stray_item_tests;
    std::vector<WrongBound> wrong_bounds;
    std::vector<AnswerProblem> answer_problems;
    AnswerState answer = AnswerState::judged;  ///< in a query of distances
    std::uint64_t reported = 0;                ///< pairs, repeated ones once
    std::uint64_t exact = 0;                   ///< pairs that intersect
    /// Pairs that intersect, if the results of the query were not recorded.
    std::uint64_t without_results = 0;
    std::uint64_t grazing = 0;         ///< pairs within the tolerance, reported or not: not judged
    std::uint64_t grazing_missed = 0;  ///< of these, pairs that intersect and were not reported
    IndexPair first_grazing;           ///< the first of these
    std::uint64_t unknown_objects = 0, objects = 0;  ///< objects without a volume, of how many
    bool interrupted = false;
    std::uint64_t broken = 0;        ///< reported pairs of non-finite triangles: not judged
    DivisionCounts divisions;        ///< if the query is complete
    std::vector<PairProblem> pairs;  ///< missed pairs by their items, then wrong reports in order
    /// Unreported pairs beyond the first 100,000, which are not examined: they may only touch.
    std::uint64_t not_looked_into = 0;
    /// Tests of volumes and items below a pair that passed although its volumes are disjoint
    /// (weak_test), or although no triangles below it intersect (loose_fit). In a query of
    /// distances: see PassReason.
    WastedTests wasted;

    std::uint64_t count(TestVerdict verdict) const;
    std::uint64_t repeated() const;
};

/// Whether the items are known well enough to judge results: both sides have triangles, or objects
/// that has_object_volumes accepts.
bool has_known_items(const EngineQuery& query);

/// Judges a query, with O(tests) exact verdicts. `go_on` is called from time to time; if it returns
/// false, the judgement ends there, interrupted.
QueryJudgement judge_query(const EngineQuery& query, const QueryTruth& truth,
                           const std::function<bool()>& go_on = {});

}  // namespace scb
