#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "core/judge/query_check.h"
#include "scb/triangle_overlap.h"
#include "tests/core/judge/judged_tree.h"

namespace scb {

/// Two rows of triangles that cross: each triangle meets the one with its number.
struct Rows {
    using Kind = EngineEvent::Kind;

    Mesh mesh = row_of_triangles();
    EngineNodes trees[2];
    TreeShape shapes[2];
    EngineQuery query;
    std::vector<IndexPair> contacts;

    explicit Rows(const std::vector<ToldNode>& nodes_of_a = nodes_of_row(),
                  const std::vector<ToldNode>& nodes_of_b = nodes_of_row()) {
        trees[0] = tree_of(nodes_of_a);
        trees[1] = tree_of(nodes_of_b);
        for (std::size_t side = 0; side < 2; ++side) {
            shapes[side] = tree_shape(trees[side], mesh.triangles.size());
            query.sides[side] = {&trees[side], &shapes[side], &mesh};
        }
        query.b_to_a.rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
        query.b_to_a.translation = Vec3(0, 0.1, -0.1);
        query.has_item_tests = query.has_pairs = true;
        query.tolerance = 1e-9;
        for (std::uint32_t i = 0; i < 4; ++i) contacts.push_back({i, i});
        visit(0, 0);
        for (const IndexPair pair : contacts)
            query.events.push_back({Kind::pair, 0, pair.a, pair.b});
    }
    Rows(const Rows&) = delete;

    /// As a correct engine does it.
    void visit(std::uint32_t a, std::uint32_t b) {
        const EngineNode &node_a = trees[0][a], &node_b = trees[1][b];
        const bool apart =
            exact_verdict(node_a.volume, node_b.volume, query.b_to_a, 1e-9).contact ==
            Contact::disjoint;
        query.events.push_back({Kind::volumes, static_cast<std::uint8_t>(apart ? 5 : 0),
                                node_a.number, node_b.number});
        if (apart) return;
        for (const std::uint32_t item_a : trees[0].items(a))
            for (const std::uint32_t item_b : trees[1].items(b))
                query.events.push_back(
                    {triangles_overlap(corners(mesh, item_a),
                                       transform_corners(query.b_to_a, corners(mesh, item_b)))
                         ? Kind::items_meet
                         : Kind::items_apart,
                     0, item_a, item_b});
        for (const std::uint32_t child_a : trees[0].children(a))
            for (const std::uint32_t child_b : trees[1].children(b))
                visit(trees[0].index_of(child_a), trees[1].index_of(child_b));
    }

    EngineEvent& event(Kind kind, std::uint32_t a, std::uint32_t b) {
        const auto found = std::find_if(
            query.events.begin(), query.events.end(),
            [&](const EngineEvent& e) { return e.kind == kind && e.a == a && e.b == b; });
        EXPECT_NE(found, query.events.end());
        return *found;
    }
    void erase(Kind kind, std::uint32_t a, std::uint32_t b) {
        query.events.erase(query.events.begin() + (&event(kind, a, b) - query.events.data()));
    }
    QueryJudgement judged() const { return judge_query(query, contacts); }
    /// The only problem found.
    PairProblem problem() const {
        const QueryJudgement found = judged();
        EXPECT_EQ(found.pairs.size(), 1u);
        return found.pairs.empty() ? PairProblem{} : found.pairs[0];
    }
};

}  // namespace scb
