#include "core/analysis/cost_equation.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/base/random.h"

namespace scb {
namespace {

std::vector<CostSample> samples(double c_v, double c_p, double c_u, double noise) {
    Random random(71);
    std::vector<CostSample> all;
    for (int i = 0; i < 200; ++i) {
        CostSample sample{0, random.uniform(100, 50000), random.uniform(0, 9000),
                          random.uniform(100, 30000)};
        sample.time = (sample.n_v * c_v + sample.n_p * c_p + sample.n_u * c_u) *
                      (1 + random.uniform(-noise, noise));
        all.push_back(sample);
    }
    return all;
}

TEST(CostEquation, FindsTheCostsOfExactSamples) {
    const CostEquation found = fit_cost_equation(samples(12, 80, 5, 0));
    EXPECT_NEAR(found.c_v, 12, 1e-9);
    EXPECT_NEAR(found.c_p, 80, 1e-9);
    EXPECT_NEAR(found.c_u, 5, 1e-9);
    EXPECT_NEAR(found.error, 0, 1e-9);
    EXPECT_NEAR(found.share_v + found.share_p + found.share_u, 1, 1e-12);
}

TEST(CostEquation, FindsThemWithinTheNoise) {
    const CostEquation found = fit_cost_equation(samples(12, 80, 5, 0.05));
    EXPECT_NEAR(found.c_v, 12, 0.6);
    EXPECT_NEAR(found.c_p, 80, 4);
    EXPECT_GT(found.error, 0.01);
    EXPECT_LT(found.error, 0.05);
}

TEST(CostEquation, HasNoNegativeCost) {
    std::vector<CostSample> all = samples(12, 80, 0, 0);
    for (CostSample& sample : all) sample.time -= 0.5 * sample.n_u;  // moves that save time
    std::erase_if(all, [](const CostSample& sample) { return sample.time <= 0; });
    const CostEquation found = fit_cost_equation(all);
    EXPECT_EQ(found.c_u, 0);
    EXPECT_GT(found.c_v, 0);
    EXPECT_GT(found.c_p, 0);
    EXPECT_EQ(found.share_u, 0);
}

TEST(CostEquation, HasNoNegativeCostOfWhicheverKind) {
    for (double CostSample::*count : {&CostSample::n_v, &CostSample::n_p}) {
        std::vector<CostSample> all = samples(1, 1, 50, 0);
        for (CostSample& sample : all) sample.time -= 1.5 * sample.*count;
        std::erase_if(all, [](const CostSample& sample) { return sample.time <= 0; });
        const CostEquation found = fit_cost_equation(all);
        EXPECT_GE(found.c_v, 0);
        EXPECT_GE(found.c_p, 0);
        EXPECT_GT(found.c_u, 0);
    }
}

TEST(CostEquation, SaysWhatCannotBeToldApart) {
    std::vector<CostSample> all = samples(12, 80, 5, 0.02);
    EXPECT_TRUE(fit_cost_equation(all).determined);
    EXPECT_TRUE(fit_cost_equation(all).moves_apart);
    for (CostSample& sample : all) {  // volumes are moved as often as they are tested
        sample.time += 5 * (1.5 * sample.n_v - sample.n_u);
        sample.n_u = 1.5 * sample.n_v;
    }
    const CostEquation together = fit_cost_equation(all);
    EXPECT_TRUE(together.determined);
    EXPECT_FALSE(together.moves_apart);
    EXPECT_EQ(together.c_u, 0);
    EXPECT_NEAR(together.c_v, 12 + 5 * 1.5, 1);
    for (CostSample& sample : all) sample.n_p = 0.1 * sample.n_v;
    EXPECT_FALSE(fit_cost_equation(all).determined);
    EXPECT_FALSE(fit_cost_equation(std::vector(1, all[0])).determined);
}

TEST(CostEquation, LeavesOutWhatWasNotDone) {
    std::vector<CostSample> all = samples(12, 80, 0, 0);
    for (CostSample& sample : all) sample.n_u = 0;
    const CostEquation found = fit_cost_equation(all);
    EXPECT_NEAR(found.c_v, 12, 1e-9);
    EXPECT_EQ(found.c_u, 0);
    EXPECT_EQ(fit_cost_equation({}).c_v, 0);
    all.push_back({0, 100, 0, 0});  // quicker than the clock
    EXPECT_NEAR(fit_cost_equation(all).c_v, 12, 1e-9);
}

}  // namespace
}  // namespace scb
