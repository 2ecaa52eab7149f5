#pragma once

#include <limits>
#include <memory>
#include <optional>

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
    /// The mesh; pairs have its indices.
    const Mesh& mesh;
};
/// Deduces the codec.
template <class Codec>
PackedCollider(const PackedHierarchy<Codec>&, const Mesh&) -> PackedCollider<Codec>;

/// How a query on packed hierarchies runs. The options do not change the set of its pairs, unless
/// it gives up.
struct PackedOptions {
    /// Which vector instructions to use.
    SimdLevel level = SimdLevel::best;
    /// The number of threads of a query, the calling one included. A small query runs on the
    /// calling thread alone.
    int threads = 1;
    /// The query gives up once it has found more pairs than this. Which pairs it has by then
    /// depends on the layout and the threads, so it returns none; CollideOptions::max_pairs returns
    /// some.
    std::size_t give_up_after = std::numeric_limits<std::size_t>::max();
    /// Whether the pairs are sorted. Unsorted pairs have the order in which they were found, which
    /// depends on the layout, the level and the threads. Sorting takes some 8 to 13 % of a query
    /// that finds many pairs.
    bool sorted = true;
};

/// Memory of running queries, kept from one query to the next. For one query at a time.
class PackedWorkspace {
  public:
    /// Empty: the first query allocates what it needs.
    PackedWorkspace();
    ~PackedWorkspace();
    /// Moves. A moved-from workspace can only be assigned to or destroyed.
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

/// The result of a query on packed hierarchies.
struct PackedCollision {
    std::vector<IndexPair> pairs;  ///< triangles of A and B that intersect; sorted by default
    std::uint64_t n_v = 0;         ///< pairs of volumes that were tested
    std::uint64_t n_p = 0;         ///< pairs of triangles that were tested, in floats
    std::uint64_t n_exact = 0;     ///< pairs of n_p that floats could not decide
    /// Pairs of n_exact that doubles in vector lanes could not decide either: the exact predicates
    /// decided them, one by one.
    std::uint64_t n_after_doubles = 0;
    /// False if the query gave up. Then `pairs` is empty, and the counts are of the work so far.
    bool complete = true;
};

/// Finds the triangles of A and B that intersect, B moved by `b_to_a` into A's frame: the same
/// pairs as collide() finds on the hierarchies that these were packed from, for every layout and
/// level. `b_to_a` must be rigid, see check_rigid. Without a workspace the query allocates its own.
/// With a front, which must belong to these two hierarchies, the query may begin there instead of
/// at the roots. It finds the same pairs, but its counts differ; they include the tests that made
/// the front. Thread-safe, each thread with its own workspace and front; throws nothing but
/// std::bad_alloc.
template <class Codec>
PackedCollision collide_packed(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b,
                               const Pose& b_to_a, const PackedOptions& options = {},
                               PackedWorkspace* workspace = nullptr, PackedFront* front = nullptr);

/// The answer to the question whether two bodies touch.
struct PackedTouch {
    /// Two triangles that intersect, the first that were found; none if the bodies do not touch.
    std::optional<IndexPair> pair;
    std::uint64_t n_v = 0;      ///< pairs of volumes that were tested
    std::uint64_t n_p = 0;      ///< pairs of triangles that were tested
    std::uint64_t n_exact = 0;  ///< pairs of n_p that were tested in doubles

    /// Whether the bodies touch.
    explicit operator bool() const { return pair.has_value(); }
};

/// Whether some triangles of A and B intersect, B moved by `b_to_a` into A's frame; ends at the
/// first pair. The answer is exact: collide_packed would find a pair. Which pair it has depends on
/// the layout and on the front, but not on the level. `b_to_a` must be rigid, see check_rigid. Runs
/// in the calling thread, and ignores PackedOptions::threads, give_up_after and sorted.
/// Thread-safe, each thread with its own workspace and front; throws nothing but std::bad_alloc.
///
/// A front, which must belong to these two hierarchies, also keeps the pair of the last call. If
/// these triangles still intersect, the query ends with their test. While bodies touch, no front is
/// made; while they do not, a front serves as in collide_packed.
template <class Codec>
PackedTouch touches(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b,
                    const Pose& b_to_a, const PackedOptions& options = {},
                    PackedWorkspace* workspace = nullptr, PackedFront* front = nullptr);

/// The stage of a test of two volumes that rejects in these queries: lanes do not say which bound
/// rejects. It is a stage behind the named ones, so stage_name and StageCounts do not have it.
inline constexpr Stage packed_rejection = static_cast<Stage>(named_stage_count);

/// The same from the roots, in the calling thread, and `calls` receives every test: the volume
/// tests of a node's children one by one, and after a test of two leaves the tests of their
/// triangles, decided exactly. So such a query takes longer by far; `level` does not change its
/// volume tests. If it gives up, the observer has received the tests so far.
///
/// The nodes of a step are the bits of a PackedRef, and depths are depths in the packed
/// hierarchies. The roots are not tested with each other, so tests of a root with the children of
/// the other have no parent. If both roots are leaves, ItemStep::step is no_step.
///
/// Allocates in proportion to the pairs of nodes that overlap. Also throws std::length_error as
/// collide does, and exceptions of the observer.
template <class Codec>
PackedCollision collide_packed(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b,
                               const Pose& b_to_a, const PackedOptions& options,
                               const ObserverCalls& calls);

/// The same with an observer of the caller's type.
template <class Codec, Observer O>
PackedCollision collide_packed(const PackedCollider<Codec>& a, const PackedCollider<Codec>& b,
                               const Pose& b_to_a, const PackedOptions& options, O& observer) {
    return collide_packed(a, b, b_to_a, options, calls_of(observer));
}

}  // namespace scb
