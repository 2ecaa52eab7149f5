#pragma once

#include <limits>
#include <memory>

#include "scb/collide.h"
#include "scb/packed_front.h"
#include "scb/packed_hierarchy.h"
#include "scb/simd_level.h"

namespace scb {

/// One side of a query on packed hierarchies, and the mesh it was built from.
template <class Codec>
struct PackedCollider {
    /// The hierarchy.
    const PackedHierarchy<Codec>& hierarchy;
    /// The mesh; its indices are those of the pairs that are found.
    const Mesh& mesh;
};
/// Finds the codec.
template <class Codec>
PackedCollider(const PackedHierarchy<Codec>&, const Mesh&) -> PackedCollider<Codec>;

/// How a query on packed hierarchies goes. Where it does not give up, it finds the same pairs.
struct PackedOptions {
    /// Which vector instructions to use.
    SimdLevel level = SimdLevel::best;
    /// How many threads share a query, this one included; of a small query this one does all.
    int threads = 1;
    /// The query gives up once it has found more pairs than this. Which pairs it has by then
    /// depends on the layout and the threads, so it returns none; CollideOptions::max_pairs returns
    /// some.
    std::size_t give_up_after = std::numeric_limits<std::size_t>::max();
};

/// Memory that queries need while they run, kept from one to the next. For one query at a time.
class PackedWorkspace {
  public:
    /// Empty: the first query allocates what it needs.
    PackedWorkspace();
    ~PackedWorkspace();
    /// Moves. What it is moved from can only be assigned to or destroyed.
    PackedWorkspace(PackedWorkspace&&) noexcept;
    /// Moves, likewise.
    PackedWorkspace& operator=(PackedWorkspace&&) noexcept;

    /// For the library itself.
    struct Parts;
    /// For the library itself.
    Parts& parts() { return *parts_; }

  private:
    std::unique_ptr<Parts> parts_;
};

/// What a query on packed hierarchies found.
struct PackedCollision {
    std::vector<IndexPair> pairs;  ///< triangles of A and B that intersect, sorted
    std::uint64_t n_v = 0;         ///< pairs of volumes that were tested
    std::uint64_t n_p = 0;         ///< pairs of triangles that were tested, in floats
    std::uint64_t n_exact = 0;     ///< of these, pairs that floats could not decide on
    bool complete = true;          ///< false where the query gave up: then no pair is here, and the
                                   ///< counts are of what was done
};

/// Finds the triangles of A and B that intersect, B moved by `b_to_a` into A's frame: the same
/// pairs as collide() finds on the hierarchies that these were made of, whatever the layout and
/// the level. `b_to_a` must be rigid, see check_rigid. Without a workspace the query allocates its
/// own. With a front, which must be of these two hierarchies, it may begin there instead of at the
/// roots, and finds the same pairs; its counts are then others, and hold the tests that making a
/// front took. Thread-safe, each thread with its own workspace and front; throws nothing but
/// std::bad_alloc.
template <class Codec>
PackedCollision collide_packed(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b,
                               const Pose& b_to_a, const PackedOptions& options = {},
                               PackedWorkspace* workspace = nullptr, PackedFront* front = nullptr);

}  // namespace scb
