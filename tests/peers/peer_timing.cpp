#include "tests/peers/peer_timing.h"

#include <algorithm>
#include <numeric>
#include <random>

#include "core/base/statistics.h"
#include "core/platform/clock.h"

namespace scb {
namespace {

/// The smallest power of two that is enough: strides are then multiples of each other, so that any
/// two peers have frames in common.
std::size_t stride_of(double estimate, std::size_t frames, double budget) {
    std::size_t stride = 1;
    while (stride < frames &&
           estimate * static_cast<double>(frames) / static_cast<double>(stride) > 1e3 * budget)
        stride *= 2;
    return stride;
}

}  // namespace

std::vector<PeerTimes> time_peers(std::span<const std::unique_ptr<Peer>> peers,
                                  std::span<const double> estimates,
                                  std::span<const PeerPoses> frames, const PeerTiming& timing) {
    struct Rounds {
        std::vector<std::vector<double>> warm, cold;  // per frame taken, per round
    };
    std::vector<PeerTimes> times(peers.size());
    std::vector<Rounds> rounds(peers.size());
    for (std::size_t p = 0; p < peers.size(); ++p) {
        times[p].stride = stride_of(estimates[p], frames.size(), timing.budget);
        const std::size_t taken = (frames.size() + times[p].stride - 1) / times[p].stride;
        rounds[p].warm.resize(taken);
        rounds[p].cold.resize(taken);
    }
    const Clock clock = timing.wall ? Clock::wall : Clock::thread;
    const double reading = reading_milliseconds(clock);
    const auto timed = [&](std::size_t p, std::size_t frame) {
        const double start = milliseconds(clock);
        peers[p]->query(frames[frame].a, frames[frame].b);
        return std::max(0.0, milliseconds(clock) - start - reading);
    };

    std::mt19937 random(1);
    std::vector<std::size_t> order(peers.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (int round = 0; round < timing.rounds; ++round) {
        if (timing.progress)
            timing.progress("round " + std::to_string(round + 1) + " of " +
                            std::to_string(timing.rounds));
        for (std::size_t p = 0; p < peers.size(); ++p) {
            const std::size_t stride = times[p].stride;
            for (std::size_t i = 0; i < frames.size(); i += stride)
                peers[p]->query(frames[i].a, frames[i].b);
            for (std::size_t i = 0; i < frames.size(); i += stride)
                rounds[p].warm[i / stride].push_back(timed(p, i));
        }
        for (std::size_t i = 0; i < frames.size(); ++i) {
            std::shuffle(order.begin(), order.end(), random);
            for (const std::size_t p : order)
                if (i % times[p].stride == 0)
                    rounds[p].cold[i / times[p].stride].push_back(timed(p, i));
        }
    }
    for (std::size_t p = 0; p < peers.size(); ++p) {
        for (const auto& of_frame : rounds[p].warm) times[p].warm.push_back(median(of_frame));
        for (const auto& of_frame : rounds[p].cold) times[p].cold.push_back(median(of_frame));
    }
    return times;
}

double mean_over(std::span<const double> times, std::size_t stride, std::size_t coarser) {
    std::vector<double> kept;
    for (std::size_t i = 0; i < times.size(); i += coarser / stride) kept.push_back(times[i]);
    return mean(kept);
}

double speedup(std::span<const double> times, std::size_t stride, std::span<const double> other,
               std::size_t other_stride) {
    const std::size_t coarser = std::max(stride, other_stride);
    return mean_over(other, other_stride, coarser) / mean_over(times, stride, coarser);
}

}  // namespace scb
