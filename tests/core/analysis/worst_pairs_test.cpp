#include "core/analysis/worst_pairs.h"

#include <gtest/gtest.h>

#include "tests/core/analysis/made_query.h"

namespace scb {
namespace {

constexpr PassReason loose_fit_reason = PassReason::loose_fit,
                     weak_test_reason = PassReason::weak_test;

/// A pair of nodes that passed, and the tests of volumes below it.
struct Passed {
    std::uint32_t nodes;
    std::uint64_t below;
    PassReason reason;
    bool within = false;  ///< a pair of the same reason
};

/// Adds the pairs of a chain, in which each pair led to the next; below a test of the roots.
void add(WorstPairs& worst, int frame, const std::vector<Passed>& chain) {
    MadeQuery query;
    query.frame.frame = frame;
    query.test(MadeQuery::none, {0, 0});
    Attribution found;
    for (std::uint32_t i = 0; i < chain.size(); ++i) {
        query.test(i, {chain[i].nodes, 0});
        PassedPair pair;
        pair.test = i + 1;
        pair.reason = chain[i].reason;
        if (chain[i].within) pair.within = pair.reason;
        pair.below.volume_tests = chain[i].below;
        found.passed.push_back(pair);
    }
    worst.add(query.frame, found);
}

using Places = std::vector<std::pair<int, std::uint32_t>>;
Places places(const std::vector<FalsePair>& pairs) {
    Places result;
    for (const FalsePair& pair : pairs) result.emplace_back(pair.frame, pair.test.nodes.a);
    return result;
}

TEST(WorstPairs, TheCostliestIsFirstAndOfEqualOnesTheEarlier) {
    WorstPairs worst(loose_fit_reason, 3);
    add(worst, 2,
        {{1, 10, loose_fit_reason}, {2, 30, loose_fit_reason}, {3, 50, weak_test_reason}});
    add(worst, 1, {{4, 10, loose_fit_reason}, {5, 5, loose_fit_reason}});
    EXPECT_EQ(places(worst.pairs()), (Places{{2, 2}, {1, 4}, {2, 1}}));
}

TEST(WorstPairs, APairOfNodesIsListedOnceWhereItIsWorst) {
    WorstPairs worst(loose_fit_reason, 3);
    for (const auto& [frame, below] : {std::pair(1, 10u), {2, 30u}, {3, 20u}})
        add(worst, frame, {{7, below, loose_fit_reason}});
    EXPECT_EQ(places(worst.pairs()), (Places{{2, 7}}));
    EXPECT_EQ(worst.pairs()[0].pair.below.volume_tests, 30u);
}

TEST(WorstPairs, TheRootsAreNotListedButTheirParts) {
    MadeQuery query;
    Attribution found;
    for (std::uint32_t i = 0; i < 2; ++i) {
        query.test(i == 0 ? MadeQuery::none : 0, {i, i});
        PassedPair& pair = found.passed.emplace_back();
        pair.test = i;
        pair.reason = loose_fit_reason;
        if (i > 0) pair.within = loose_fit_reason;
        pair.below.volume_tests = i == 0 ? 100 : 20;
    }
    WorstPairs worst(loose_fit_reason, 3);
    worst.add(query.frame, found);
    EXPECT_EQ(places(worst.pairs()), (Places{{0, 1}}));
}

TEST(WorstPairs, PartsFollowWhereThereAreFewThatAreNotWithinOthers) {
    WorstPairs worst(loose_fit_reason, 3);
    // Of 100: 26 is more than a quarter, 25 is one; and 7 is more than a quarter of that.
    add(worst, 1,
        {{1, 100, loose_fit_reason},
         {2, 26, loose_fit_reason, true},
         {3, 25, loose_fit_reason, true},
         {4, 7, loose_fit_reason, true},
         {5, 6, loose_fit_reason, true}});
    EXPECT_EQ(places(worst.outermost()), (Places{{1, 1}}));
    EXPECT_EQ(places(worst.parts()), (Places{{1, 3}, {1, 5}}));
    EXPECT_EQ(places(worst.pairs()), (Places{{1, 1}, {1, 3}, {1, 5}}));
    // Costly as they are, the parts come after all that are within no other.
    add(worst, 2, {{8, 3, loose_fit_reason}, {9, 2, loose_fit_reason}});
    EXPECT_EQ(places(worst.pairs()), (Places{{1, 1}, {2, 8}, {2, 9}}));
}

TEST(WorstPairs, AWeakTestWithinALooseFitIsWithinNoOther) {
    WorstPairs worst(weak_test_reason, 3);
    add(worst, 1,
        {{1, 100, loose_fit_reason},
         {2, 50, weak_test_reason},
         {3, 40, weak_test_reason, true},
         {4, 12, weak_test_reason, true}});
    EXPECT_EQ(places(worst.outermost()), (Places{{1, 2}}));
    EXPECT_EQ(places(worst.parts()), (Places{{1, 4}}));
}

TEST(WorstPairs, TestsOfTrianglesCountToo) {
    WorstPairs worst(weak_test_reason, 2);
    FalsePair first, second;
    first.test.nodes = {1, 1};
    first.pair.below = {5, 0, 0};
    second.test.nodes = {2, 2};
    second.pair.below = {3, 4, 0};
    worst.add({first, second}, {});
    EXPECT_EQ(places(worst.pairs()), (Places{{0, 2}, {0, 1}}));
}

TEST(WorstRejections, ThatMissesTheMostIsFirstAndEachPairOfNodesIsListedOnce) {
    WorstRejections worst(2);
    const auto lost = [](int frame, std::uint32_t nodes, std::uint64_t missed) {
        WronglyRejectedPair pair;
        pair.frame = frame;
        pair.rejection.missed = missed;
        pair.test.nodes = {nodes, nodes};
        return pair;
    };
    worst.add({lost(1, 3, 2), lost(2, 3, 5), lost(3, 4, 1)});
    worst.add({lost(4, 5, 1), lost(2, 6, 1)});
    ASSERT_EQ(worst.pairs().size(), 2u);
    EXPECT_EQ(worst.pairs()[0].frame, 2);
    EXPECT_EQ(worst.pairs()[0].test.nodes.a, 3u);
    EXPECT_EQ(worst.pairs()[1].test.nodes.a, 6u) << "of equal ones the first frame";
}

}  // namespace
}  // namespace scb
