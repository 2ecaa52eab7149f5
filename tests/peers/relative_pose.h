#pragma once

#include "tests/peers/peer.h"

namespace scb {

inline PeerPose identity_pose() { return {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {}}; }

/// `inverse(a) * b`.
inline PeerPose relative(const PeerPose& a, const PeerPose& b) {
    PeerPose result;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k)
                result.rotation[i][j] += a.rotation[k][i] * b.rotation[k][j];
        for (std::size_t k = 0; k < 3; ++k)
            result.translation[i] += a.rotation[k][i] * (b.translation[k] - a.translation[k]);
    }
    return result;
}

/// A point of the body, where the pose leads.
inline std::array<double, 3> place(const PeerPose& pose, const std::array<double, 3>& v) {
    std::array<double, 3> x{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& r = pose.rotation[i];
        x[i] = r[0] * v[0] + r[1] * v[1] + r[2] * v[2] + pose.translation[i];
    }
    return x;
}

}  // namespace scb
