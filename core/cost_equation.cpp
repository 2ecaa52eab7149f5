#include "core/cost_equation.h"

#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <vector>

namespace scb {
namespace {

using Costs = std::array<double, 3>;

Costs counts_of(const CostSample& sample) { return {sample.n_v, sample.n_p, sample.n_u}; }

double error_of(std::span<const CostSample> samples, const Costs& costs) {
    double sum = 0;
    for (const CostSample& sample : samples) {
        const Costs counts = counts_of(sample);
        double time = 0;
        for (std::size_t k = 0; k < 3; ++k) time += counts[k] * costs[k];
        const double off = time / sample.time - 1;
        sum += off * off;
    }
    return std::sqrt(sum / static_cast<double>(samples.size()));
}

// Least squares in the chosen costs alone, bit by bit; the others are 0.
Costs costs_of(std::span<const CostSample> samples, unsigned chosen) {
    std::vector<std::size_t> columns;
    for (std::size_t k = 0; k < 3; ++k)
        if ((chosen >> k & 1) != 0) columns.push_back(k);
    Eigen::MatrixXd matrix(samples.size(), columns.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
        for (std::size_t c = 0; c < columns.size(); ++c)
            matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(c)) =
                counts_of(samples[i])[columns[c]] / samples[i].time;
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(samples.size()));
    const Eigen::VectorXd solved = matrix.colPivHouseholderQr().solve(ones);
    Costs costs{};
    for (std::size_t c = 0; c < columns.size(); ++c)
        costs[columns[c]] = solved[static_cast<Eigen::Index>(c)];
    return costs;
}

}  // namespace

CostEquation fit_cost_equation(std::span<const CostSample> samples) {
    CostEquation result;
    if (samples.empty()) return result;
    // With three unknowns, the least that is not negative is found by trying which of them are 0.
    Costs best{};
    result.error = error_of(samples, best);
    for (unsigned chosen = 1; chosen < 8; ++chosen) {
        const Costs costs = costs_of(samples, chosen);
        bool legal = true;
        for (const double cost : costs) legal &= cost >= 0;
        const double error =
            legal ? error_of(samples, costs) : std::numeric_limits<double>::infinity();
        if (!(error < result.error)) continue;
        result.error = error;
        best = costs;
    }
    result.c_v = best[0];
    result.c_p = best[1];
    result.c_u = best[2];
    Costs times{};
    for (const CostSample& sample : samples) {
        const Costs counts = counts_of(sample);
        for (std::size_t k = 0; k < 3; ++k) times[k] += counts[k] * best[k];
    }
    const double all = times[0] + times[1] + times[2];
    if (all > 0) {
        result.share_v = times[0] / all;
        result.share_p = times[1] / all;
        result.share_u = times[2] / all;
    }
    return result;
}

}  // namespace scb
