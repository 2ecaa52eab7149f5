#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "scb/observer.h"

namespace scb {

/// A mesh as adapters get it, without a type of Eigen: an adapter is compiled as a user of its
/// library compiles, not with those that this project compiles its own code with, which would
/// change the layout of Eigen's types and with them FCL's.
struct PeerMesh {
    std::vector<std::array<double, 3>> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A rigid placement of a body, `x -> rotation x + translation`, the rotation row by row.
struct PeerPose {
    std::array<std::array<double, 3>, 3> rotation{};
    std::array<double, 3> translation{};
};

/// A library with the trees of two meshes, ready for queries. For one query at a time.
class Peer {
  public:
    Peer() = default;
    Peer(const Peer&) = delete;
    Peer& operator=(const Peer&) = delete;
    virtual ~Peer() = default;

    /// Finds the pairs of triangles that intersect, body A at `a` and B at `b`, and leaves them in
    /// the form in which the library gives them. This is timed.
    virtual void query(const PeerPose& a, const PeerPose& b) = 0;

    /// The pairs that the last query found, sorted, each once.
    virtual std::vector<IndexPair> pairs() const = 0;

    /// How much memory both trees take, without the meshes; NaN where the library does not tell.
    virtual double bytes() const { return std::numeric_limits<double>::quiet_NaN(); }
};

/// The pairs that a query finds.
enum class PeerQuery : std::uint8_t {
    all_pairs,
    first_contact,  ///< one pair, if there is any; a library that cannot end there finds more
};

/// How a library, or one of its ways to do it, takes part.
struct PeerKind {
    std::string name;    ///< for --peers: "fcl"
    std::string title;   ///< in tables: "FCL 0.7.0, OBB"
    std::string method;  ///< what is called and timed, and what it cannot do; sentences
    bool own = false;    ///< of this project: it must find the pairs of the reference, no others
    /// Builds both trees. The meshes outlive the peer.
    std::function<std::unique_ptr<Peer>(const PeerMesh& a, const PeerMesh& b, PeerQuery query)>
        prepare;
};

}  // namespace scb
