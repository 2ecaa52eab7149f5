#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>

#include "core/explain/contact_certificate.h"
#include "core/judge/engine_query.h"

namespace scb {

/// What a test of two volumes is worth, by the exact verdict on the engine's own volumes.
enum class TestVerdict : std::uint8_t {
    right,
    false_positive,  ///< it passed volumes that are disjoint
    wrong,           ///< it rejected volumes that overlap
    unjudged,        ///< one of the nodes is unknown or has no volume
};

struct JudgedTest {
    std::uint32_t event = 0;          ///< index into EngineQuery::events
    IndexPair nodes;                  ///< indices; no_index: a node that the tree does not have
    std::uint32_t parent = no_index;  ///< the judged test that led to it, as far as one can tell
    TestVerdict verdict = TestVerdict::unjudged;
    bool repeated = false;  ///< the query made it before
    bool meets = false;     ///< triangles below it intersect, as far as the query came
    /// Gap or depth of the volumes, at least; 0 where they touch.
    double margin = 0;
};

/// Why a pair that intersects is not among those that were reported, or one that does not is. From
/// `reported_in_spite` on it is the latter.
enum class PairCause : std::uint8_t {
    no_tree,            ///< no node of the tree was recorded
    in_no_leaf,         ///< no node that a root leads to has the triangle
    not_contained,      ///< rejected at a node that does not contain the triangle
    bad_volume,         ///< rejected at a node whose volume is none
    rejected,           ///< rejected although the volumes overlap
    rejected_unproven,  ///< rejected by a test that is not proven wrong
    never_visited,      ///< nodes overlapped, and what is below them was not tested
    below_outside,      ///< no test was recorded, and a node above does not contain the triangle
    below_bad_volume,   ///< no test was recorded, and a node above has a volume that is none
    no_tests,           ///< the query has no tests of volumes, so that the cause is not known
    never_tested,       ///< no test of two nodes that have them below was recorded
    items_not_tested,   ///< the leaves overlapped, and the triangles were not tested
    items_apart,        ///< the test of the two triangles said that they are apart
    not_reported,       ///< it said that they meet, but the pair was not reported
    reported_in_spite,  ///< reported although the test of the two triangles said that they are
                        ///< apart
    items_meet,         ///< the test of the two triangles said that they meet
    reported_untested,  ///< reported without a test
    neighbours,         ///< of one mesh: they have a vertex in common and meet nowhere else
    unknown_item,       ///< one of the two does not exist
    reported_twice,
};
inline constexpr std::size_t pair_cause_count = 20;
inline bool is_missed(PairCause cause) { return cause < PairCause::reported_in_spite; }

/// A pair of items that is missed or false, and why.
struct PairProblem {
    IndexPair items;
    PairCause cause{};
    /// The numbers of the nodes at which it went wrong; no_index where that says nothing.
    IndexPair nodes{no_index, no_index};
    /// Of never_visited: the numbers of the next nodes on the way to the pair.
    IndexPair next{no_index, no_index};
    std::uint32_t event = no_index;  ///< at which it went wrong
    /// The judged test that the event is or, of a test of items, that of their nodes.
    std::uint32_t test = no_index;
    std::uint32_t side = 0;  ///< of in_no_leaf and not_contained: whose triangle and node
    double amount = 0;       ///< of not_contained: how far the triangle is outside
    /// Of not_contained: the node below that one, nearest to the triangle, that does not contain it
    /// either; no_index: none.
    std::uint32_t deepest = no_index;

    friend bool operator==(const PairProblem&, const PairProblem&) = default;
};

/// A test of two items that erred, and not just within the tolerance.
struct WrongItemTest {
    std::uint32_t event = 0;        ///< index into EngineQuery::events
    std::uint32_t test = no_index;  ///< the judged test of the nodes that have them
    double margin = 0;              ///< gap or depth of the two triangles
    bool strayed = false;           ///< no test of the nodes that have them came before it
    bool unknown = false;           ///< one of the two does not exist
};

/// Of the tests that led to others, those that led to tests of some children of a node but not of
/// one that overlaps what stands against it, see check_divisions.
struct DivisionCounts {
    struct Lack {
        std::uint32_t test = no_index;  ///< the judged test
        std::uint32_t side = 0;         ///< whose node was divided
        std::uint32_t child = 0;        ///< the number of the first that was not tested
        std::uint32_t place = 0;        ///< which of the children that is, from 0
    };
    std::uint64_t divided = 0, lacking = 0;
    Lack first;
    bool alike = true;  ///< all lack the child in the same place
};

/// A query, judged.
struct QueryJudgement {
    std::vector<JudgedTest> tests;  ///< of volumes, in order
    std::uint64_t item_tests = 0;
    std::vector<WrongItemTest> wrong_item_tests;
    /// Tests of items that are neither in the two leaves tested before nor in others that were,
    /// with the test before. Without those of wrong_item_tests.
    std::vector<WrongItemTest> stray_item_tests;
    std::uint64_t reported = 0;  ///< pairs, each once
    std::uint64_t exact = 0;     ///< pairs that intersect
    /// Of a query whose results were not recorded: pairs that intersect.
    std::uint64_t without_results = 0;
    std::uint64_t grazing = 0;         ///< reported or not, within the tolerance: not judged
    std::uint64_t grazing_missed = 0;  ///< those that intersect exactly and were not reported
    IndexPair first_grazing;           ///< the first of these
    std::uint64_t unknown_objects = 0, objects = 0;  ///< without an extent, of how many
    bool interrupted = false;
    std::uint64_t broken = 0;        ///< reported, of triangles that are not finite: not judged
    DivisionCounts divisions;        ///< of a complete query
    std::vector<PairProblem> pairs;  ///< missed ones by their items, then false ones in order
    /// Pairs that were not reported, beyond the first 100,000: whether they only touch, and why
    /// they were missed, is not known.
    std::uint64_t not_looked_into = 0;
    /// Tests of volumes and of items that a pair led to which passed although its volumes are
    /// disjoint (weak), or although no triangles below it intersect (loose).
    std::uint64_t wasted_weak = 0, wasted_loose = 0;

    std::uint64_t count(TestVerdict verdict) const;
    std::uint64_t repeated() const;
};

/// Whether enough is known of its items to judge its results: both sides have triangles, or objects
/// as of has_object_volumes.
bool has_known_items(const EngineQuery& query);

/// Judges a query. `contacts` are all pairs of triangles that intersect, sorted, of finite
/// triangles; of a body against itself those of SelfPairs; of objects those of object_contacts;
/// empty where only one side has a mesh. O(tests) exact verdicts.
/// `go_on` is asked from time to time; where it says no, the judgement ends there, interrupted.
QueryJudgement judge_query(const EngineQuery& query, std::span<const IndexPair> contacts,
                           const std::function<bool()>& go_on = {});

/// How many of its tests cannot have been made with this pose: they rejected volumes that overlap,
/// passed ones that are disjoint, or erred about two triangles.
struct PoseFit {
    std::uint64_t wrong = 0;           ///< tests of volumes
    std::uint64_t wrong_items = 0;     ///< tests of triangles
    std::uint64_t false_positive = 0;  ///< tests of volumes that passed

    std::uint64_t all_wrong() const { return wrong + wrong_items; }
};
PoseFit fit_of_pose(const EngineQuery& query, const Pose& b_to_a);

}  // namespace scb
