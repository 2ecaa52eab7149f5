#pragma once

#include <cstdint>
#include <memory>

namespace scb {

/// Where queries on a pair of packed hierarchies begin instead of at the roots, kept from one query
/// to the next (coherence): the pairs of nodes and leaves at which a traversal ended that took
/// volumes and triangles for overlapping where they are no farther apart than a skin. As Verlet
/// lists of particles are (L. Verlet, "Computer 'experiments' on classical fluids. I", 1967), it is
/// good for all queries for which no point of B has moved by more than the skin relative to A
/// since, which displacement_bound proves of their poses; what the front left out is then still
/// apart, and a query finds the same pairs as from the roots.
///
/// When a front is made, and how thick its skin is, follows from the poses of the queries so far:
/// where they move by more than 0.03 of the leaves' mean radii from one to the next, a front would
/// cost more than it saves, and queries begin at the roots.
///
/// A front is of one pair of hierarchies: clear it before a query on others, or the query may miss
/// pairs. For one query at a time.
class PackedFront {
  public:
    PackedFront();
    ~PackedFront();
    PackedFront(PackedFront&&) noexcept;
    PackedFront& operator=(PackedFront&&) noexcept;

    /// Forgets the front and all poses.
    void clear();

    /// How many fronts were made, and how many queries have begun at one, since it was cleared.
    std::uint64_t made() const;
    std::uint64_t used() const;

    struct Parts;
    Parts& parts() { return *parts_; }

  private:
    std::unique_ptr<Parts> parts_;
};

}  // namespace scb
