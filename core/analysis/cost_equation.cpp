#include "core/analysis/cost_equation.h"

#include <Eigen/QR>
#include <algorithm>
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

// The counts of these columns per unit of time, a row for each sample.
Eigen::MatrixXd rates_of(std::span<const CostSample> samples,
                         const std::vector<std::size_t>& columns) {
    Eigen::MatrixXd rates(samples.size(), columns.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
        for (std::size_t c = 0; c < columns.size(); ++c)
            rates(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(c)) =
                counts_of(samples[i])[columns[c]] / samples[i].time;
    return rates;
}

// Whether the counts vary enough from sample to sample to tell their costs apart: no column of the
// matrix of shares is within a twentieth of the span of the others. Counts that are always 0 are
// left out.
bool is_determined(std::span<const CostSample> samples) {
    std::vector<std::size_t> columns;
    for (std::size_t k = 0; k < 3; ++k)
        for (const CostSample& sample : samples)
            if (counts_of(sample)[k] > 0) {
                columns.push_back(k);
                break;
            }
    if (columns.empty() || samples.size() < columns.size()) return false;
    Eigen::MatrixXd matrix = rates_of(samples, columns);
    matrix.colwise().normalize();
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix);
    return qr.matrixR().diagonal().cwiseAbs().minCoeff() > 0.05;
}

// Least squares in the costs whose bits are set in `chosen`; the other costs are 0.
Costs costs_of(std::span<const CostSample> samples, unsigned chosen) {
    std::vector<std::size_t> columns;
    for (std::size_t k = 0; k < 3; ++k)
        if ((chosen >> k & 1) != 0) columns.push_back(k);
    const Eigen::MatrixXd matrix = rates_of(samples, columns);
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(samples.size()));
    const Eigen::VectorXd solved = matrix.colPivHouseholderQr().solve(ones);
    Costs costs{};
    for (std::size_t c = 0; c < columns.size(); ++c)
        costs[columns[c]] = solved[static_cast<Eigen::Index>(c)];
    return costs;
}

}  // namespace

CostEquation fit_cost_equation(std::span<const CostSample> all) {
    CostEquation result;
    std::vector<CostSample> samples(all.begin(), all.end());
    std::erase_if(samples, [](const CostSample& sample) { return !(sample.time > 0); });
    if (samples.empty()) return result;
    const bool moved = std::any_of(samples.begin(), samples.end(),
                                   [](const CostSample& sample) { return sample.n_u > 0; });
    result.determined = is_determined(samples);
    result.moves_apart = moved && result.determined;
    if (moved && !result.determined) {
        for (CostSample& sample : samples) sample.n_u = 0;
        result.determined = is_determined(samples);
    }
    // With three unknowns, non-negative least squares can try every choice of costs that are 0.
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
    const double sum = times[0] + times[1] + times[2];
    if (sum > 0) {
        result.share_v = times[0] / sum;
        result.share_p = times[1] / sum;
        result.share_u = times[2] / sum;
    }
    return result;
}

}  // namespace scb
