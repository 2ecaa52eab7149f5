#pragma once

#include <cstdint>
#include <memory>

namespace scb {

/// A place where queries on a pair of packed hierarchies begin instead of at the roots, kept from
/// one query to the next (coherence). A front is the list of pairs of nodes and leaves at which a
/// traversal ended. That traversal took volumes and triangles for overlapping if they were no
/// farther apart than a length, the skin. Like a Verlet list of particles (L. Verlet, "Computer
/// 'experiments' on classical fluids. I", 1967), a front is valid as long as no two points of A and
/// B can have come nearer by more than the skin. motion_bound proves this from the two poses. All
/// pairs outside the front are then still apart, so a query finds the same pairs as from the roots.
/// A front goes down to pairs of leaves and leaves out pairs whose triangles lie apart, which their
/// volumes do not show. Where surfaces are close without touching, a query from the front has a
/// tenth of the tests.
///
/// The poses of the queries so far decide when a front is made, and how thick its skin is. If two
/// points may come nearer by more than a fortieth of the leaves' mean radii from one query to the
/// next, a front would cost more than it saves: queries begin at the roots.
///
/// For touches() a front also keeps the last pair of triangles that met.
///
/// A front belongs to one pair of hierarchies and meshes. Clear it before a query on others, whose
/// result is undefined otherwise. For one query at a time.
class PackedFront {
  public:
    /// Empty: the first query begins at the roots.
    PackedFront();
    ~PackedFront();
    /// Moves. A moved-from front can only be assigned to or destroyed.
    PackedFront(PackedFront&&) noexcept;
    /// Moves, likewise.
    PackedFront& operator=(PackedFront&&) noexcept;

    /// Forgets the front, all poses, and the pair.
    void clear();

    /// The number of fronts made since the last `clear`.
    std::uint64_t made() const;
    /// The number of queries since the last `clear` that began at a front, or ended at the pair of
    /// the last call of touches().
    std::uint64_t used() const;

    /// For the library itself.
    struct Parts;
    /// For the library itself.
    Parts& parts() { return *parts_; }

  private:
    std::unique_ptr<Parts> parts_;
};

}  // namespace scb
