#pragma once

#include <functional>
#include <span>
#include <vector>

#include "tests/peers/peer.h"

namespace scb {

/// Where the two bodies are in a frame.
struct PeerPoses {
    PeerPose a, b;
};

/// How the times of queries are taken.
struct PeerTiming {
    int rounds = 3;
    /// Of one pass of a peer over its frames, in seconds: one that is slower takes every second
    /// frame, every fourth, and so on.
    double budget = 3;
    bool wall = false;  ///< the time that passes, where threads share a query
    /// Called with a description of each step; may be empty.
    std::function<void(const std::string& what)> progress;
};

/// A peer's times in milliseconds: of each frame that it took, the median of the rounds.
struct PeerTimes {
    std::size_t stride = 1;  ///< it took the frames 0, stride, 2 stride, ... of those asked for
    /// All frames in turn, after a pass that is not timed.
    std::vector<double> warm;
    /// At each frame the peers take turns, in an order that is drawn anew, so that between two
    /// queries of one the others pass through the caches and the branch predictor.
    std::vector<double> cold;
};

/// Times the peers, all in one run: so many rounds of a warm pass of each and a cold pass of all.
/// `estimates`: about how many milliseconds a query of each peer takes.
std::vector<PeerTimes> time_peers(std::span<const std::unique_ptr<Peer>> peers,
                                  std::span<const double> estimates,
                                  std::span<const PeerPoses> frames, const PeerTiming& timing);

/// The mean of the times that a peer took, `stride` frames apart, over the frames that are
/// `coarser` frames apart, a multiple of it.
double mean_over(std::span<const double> times, std::size_t stride, std::size_t coarser);

/// How many times as long as the peer the other took, over the frames that both took.
double speedup(std::span<const double> times, std::size_t stride, std::span<const double> other,
               std::size_t other_stride);

}  // namespace scb
