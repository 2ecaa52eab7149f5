#include "core/judge/query_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/random.h"
#include "core/judge/query_check.h"
#include "tests/core/judge/judged_rows.h"

namespace scb {
namespace {

/// Two sets of balls and boxes as opaque objects, each in a leaf below one root.
struct ObjectSets {
    EngineNodes trees[2];
    TreeShape shapes[2];
    EngineQuery query;

    ObjectSets() {
        Random random(5);
        const auto point = [&random] {
            return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        };
        constexpr std::uint32_t count = 60;
        for (std::size_t side = 0; side < 2; ++side) {
            std::vector<std::uint32_t> children;
            for (std::uint32_t i = 0; i < count; ++i) children.push_back(i + 1);
            EngineNode root;
            trees[side].add(root, "", children, {});
            for (std::uint32_t i = 0; i < count; ++i) {
                EngineNode leaf;
                leaf.number = i + 1;
                leaf.parent = 0;
                const std::uint32_t object = 7 + 2 * i;
                trees[side].add(leaf, "", {}, std::span(&object, 1));
                NodeVolume volume = Ball{point(), 0.15};
                if (i % 2 == 0) volume = Obb{point(), Mat3::Identity(), Vec3(0.05, 0.1, 0.2)};
                trees[side].set_volume(i + 1, std::move(volume), 0, "");
            }
            shapes[side] = tree_shape(trees[side], 7 + 2 * count);
            query.sides[side] = {&trees[side], &shapes[side]};
            query.sides[side].objects_by_volume = true;
        }
        query.b_to_a.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
        query.b_to_a.translation = Vec3(0.1, 0, -0.2);
        query.has_pairs = true;
        query.tolerance = 1e-9;
    }
    ObjectSets(const ObjectSets&) = delete;
};

TEST(ObjectContacts, AreThoseOfAllPairs) {
    const ObjectSets sets;
    ASSERT_TRUE(has_object_volumes(sets.query));
    std::vector<IndexPair> all;
    for (std::uint32_t a = 1; a < sets.trees[0].size(); ++a)
        for (std::uint32_t b = 1; b < sets.trees[1].size(); ++b)
            if (exact_verdict(sets.trees[0][a].volume, sets.trees[1][b].volume, sets.query.b_to_a,
                              1e-9)
                    .contact != Contact::disjoint)
                all.push_back({sets.trees[0].items(a)[0], sets.trees[1].items(b)[0]});
    std::sort(all.begin(), all.end());
    EXPECT_GT(all.size(), 20u);
    EXPECT_LT(all.size(), 3000u);
    EXPECT_EQ(object_contacts(sets.query), all);
}

TEST(ObjectContacts, ResultsAreJudgedByThem) {
    ObjectSets sets;
    const std::vector<IndexPair> contacts = object_contacts(sets.query);
    for (const IndexPair pair : contacts)
        sets.query.events.push_back({EngineEvent::Kind::pair, 0, pair.a, pair.b});
    EXPECT_TRUE(judge_query(sets.query, contacts).pairs.empty());
    const IndexPair lost{sets.query.events[3].a, sets.query.events[3].b};
    sets.query.events.erase(sets.query.events.begin() + 3);
    IndexPair apart{7, 7};
    while (std::binary_search(contacts.begin(), contacts.end(), apart)) apart.b += 2;
    sets.query.events.push_back({EngineEvent::Kind::pair, 0, apart.a, apart.b});
    const std::vector<PairProblem> problems = judge_query(sets.query, contacts).pairs;
    ASSERT_EQ(problems.size(), 2u);
    EXPECT_EQ(problems[0].items, lost);
    EXPECT_TRUE(is_missed(problems[0].cause));
    EXPECT_EQ(problems[1].items, apart);
    EXPECT_EQ(problems[1].cause, PairCause::reported_untested);
}

TEST(ObjectContacts, WithoutThemResultsAreNotJudged) {
    ObjectSets sets;
    EXPECT_TRUE(has_known_items(sets.query));
    sets.query.sides[1].objects_by_volume = false;
    EXPECT_FALSE(has_known_items(sets.query));
    sets.query.events.push_back({EngineEvent::Kind::pair, 0, 7, 7});
    const QueryJudgement judged = judge_query(sets.query, {});
    EXPECT_EQ(judged.reported, 1u);
    EXPECT_TRUE(judged.pairs.empty());
}

/// A box of one unit on each side; the box of B is moved by `b`.
std::size_t contacts_of_two(const Vec3& b, double tolerance) {
    EngineNodes trees[2];
    TreeShape shapes[2];
    EngineQuery query;
    for (std::size_t side = 0; side < 2; ++side) {
        const std::uint32_t object = 0;
        trees[side].add({}, "", {}, std::span(&object, 1));
        trees[side].set_volume(0, Obb{Vec3::Zero(), Mat3::Identity(), Vec3(0.5, 0.5, 0.5)}, 0, "");
        shapes[side] = tree_shape(trees[side], 1);
        query.sides[side] = {&trees[side], &shapes[side]};
        query.sides[side].objects_by_volume = true;
    }
    query.b_to_a.translation = b;
    query.tolerance = tolerance;
    return object_contacts(query).size();
}

TEST(ObjectContacts, ObjectsThatTouchOrNearlyDoAreInContact) {
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            const Vec3 beside = sign * Vec3::Unit(axis);
            EXPECT_EQ(contacts_of_two(beside, 0), 1u) << axis;
            EXPECT_EQ(contacts_of_two(1.01 * beside, 0), 0u) << axis;
            EXPECT_EQ(contacts_of_two(1.01 * beside, 0.001), 0u) << axis;
            EXPECT_EQ(contacts_of_two(1.01 * beside, 0.02), 1u) << axis;
            EXPECT_EQ(contacts_of_two(0.5 * beside, 0), 1u) << axis;
        }
}

using Counts = std::vector<std::size_t>;

TEST(QueryOverlaps, CountsTheOverlapsOfEachLevel) {
    Rows rows;
    EXPECT_EQ(level_overlaps(rows.query, 100), (Counts{1, 2, 4}));
    EXPECT_EQ(level_overlaps(rows.query, 3), (Counts{1, 2}));
    // One unit along the row: of four triangles three have a partner.
    rows.query.b_to_a.translation[0] += 1;
    EXPECT_EQ(level_overlaps(rows.query, 100), (Counts{1, 3, 3}));
    rows.query.b_to_a.translation[2] += 10;
    EXPECT_EQ(level_overlaps(rows.query, 100), Counts{0});
}

TEST(QueryOverlaps, NodesWithoutVolumesOverlapAllOthers) {
    auto nodes = nodes_of_row();
    for (ToldNode& node : nodes) node.volume = NodeVolume{};
    const Rows rows(nodes);
    EXPECT_EQ(level_overlaps(rows.query, 100), (Counts{1, 4, 16}));
}

TEST(QueryOverlaps, NothingIsCountedOfABodyAgainstItselfOrOfAPoseThatIsNotRigid) {
    Rows rows;
    rows.query.self = true;
    EXPECT_EQ(level_overlaps(rows.query, 100), Counts{});
    rows.query.self = false;
    rows.query.placed = false;
    EXPECT_EQ(level_overlaps(rows.query, 100), Counts{});
}

}  // namespace

}  // namespace scb
