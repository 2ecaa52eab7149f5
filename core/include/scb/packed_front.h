#pragma once

#include <cstdint>
#include <memory>

namespace scb {

/// Where queries on a pair of packed hierarchies begin instead of at the roots, kept from one query
/// to the next (coherence): the pairs of nodes and leaves at which a traversal ended that took
/// volumes and triangles for overlapping where they are no farther apart than a skin. As Verlet
/// lists of particles are (L. Verlet, "Computer 'experiments' on classical fluids. I", 1967), it is
/// good for all queries for which no two points of A and B can have come nearer since by more than
/// the skin, which motion_bound proves of the two poses: what the front left out is then still
/// apart, and a query finds the same pairs as from the roots. It goes down to pairs of leaves, and
/// leaves out those whose triangles lie apart, which volumes do not tell: where surfaces are close
/// to each other without touching, a query from the front has a tenth of the tests.
///
/// When a front is made, and how thick its skin is, follows from the poses of the queries so far:
/// where two points may come nearer by more than a fortieth of the leaves' mean radii from one
/// query to the next, a front would cost more than it saves, and queries begin at the roots.
///
/// A front is of one pair of hierarchies: clear it before a query on others, which may miss pairs
/// else. For one query at a time.
class PackedFront {
  public:
    /// Has no front yet: the first query begins at the roots.
    PackedFront();
    ~PackedFront();
    /// Moves. What it is moved from can only be assigned to or destroyed.
    PackedFront(PackedFront&&) noexcept;
    /// Moves, likewise.
    PackedFront& operator=(PackedFront&&) noexcept;

    /// Forgets the front and all poses.
    void clear();

    /// How many fronts were made since it was cleared.
    std::uint64_t made() const;
    /// How many queries have begun at one since it was cleared.
    std::uint64_t used() const;

    /// For the library itself.
    struct Parts;
    /// For the library itself.
    Parts& parts() { return *parts_; }

  private:
    std::unique_ptr<Parts> parts_;
};

}  // namespace scb
