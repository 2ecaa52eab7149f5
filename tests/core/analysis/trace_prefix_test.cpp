#include "core/analysis/trace_prefix.h"

#include <gtest/gtest.h>

#include "tests/core/analysis/traces.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {
namespace {

TEST(TracePrefix, AreTheQueryUpToThere) {
    const BuiltMesh mesh(height_field(9));
    for (const TraceHeader& header : queries_to_divide()) {
        const QueryTrace whole = record_frame(mesh, mesh, 3, pose_to_divide(), header);
        const Outcomes of_whole = outcomes_of(header, whole);
        const std::size_t all = whole.found.n_v;
        std::size_t pairs = 0;
        for (std::size_t count = 0; count <= all; count += 7) {
            const QueryTrace part = trace_prefix(header, whole, count);
            EXPECT_EQ(part.found.n_v, count);
            EXPECT_EQ(test_count(part.found.stages), count);
            EXPECT_EQ(part.found.n_p, part.steps.items.size());
            EXPECT_GE(part.found.pairs.size(), pairs);
            EXPECT_EQ(part.found.complete, count == all);
            EXPECT_TRUE(std::includes(whole.found.pairs.begin(), whole.found.pairs.end(),
                                      part.found.pairs.begin(), part.found.pairs.end()));
            pairs = part.found.pairs.size();
            // Its tree is a part of the whole tree: some pairs are not divided yet.
            const Outcomes outcomes = outcomes_of(header, part);
            for (std::size_t i = 0; i < count; ++i) {
                EXPECT_EQ(part.steps.volumes[i], whole.steps.volumes[i]);
                EXPECT_TRUE(outcomes[i] == of_whole[i] || outcomes[i] == Stage::left_over);
            }
        }
        // All of them, and more than there are.
        for (const std::size_t count : {all, all + 10}) {
            const QueryTrace part = trace_prefix(header, whole, count);
            EXPECT_EQ(part.steps, whole.steps);
            EXPECT_EQ(part.found.pairs, whole.found.pairs);
            EXPECT_EQ(part.found.n_u, whole.found.n_u);
            EXPECT_EQ(part.found.n_p, whole.found.n_p);
            EXPECT_EQ(part.found.stages, whole.found.stages);
            EXPECT_EQ(part.found.depth, whole.found.depth);
            EXPECT_TRUE(part.found.complete);
        }
    }
}

}  // namespace
}  // namespace scb
