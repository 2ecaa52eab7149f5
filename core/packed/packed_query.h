#pragma once

#include <hwy/base.h>
#include <hwy/cache_control.h>
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/packed/front_schedule.h"
#include "scb/collide.h"
#include "scb/packed_front.h"
#include "scb/packed_hierarchy.h"
#include "scb/placement.h"
#include "scb/simd_level.h"
#include "scb/triangle_overlap.h"

namespace scb {

class PackedSteps;

// Input and output of a traversal of packed hierarchies, shared by all SIMD targets.

/// A query on two packed hierarchies of one layout.
template <class Codec>
struct PackedQuery {
    const PackedHierarchy<Codec>*a, *b;
    const Placement* placed;
    /// More than 0 if the query makes a front, see PackedFront. Volumes no farther apart than this
    /// length count as overlapping. Pairs of nodes whose radii add up to at most `kept_size` are
    /// kept and not divided.
    float skin = 0, kept_size = 0;
};
using AnyPackedQuery = AnyCodec<PackedQuery>;

/// Pairs of nodes to divide: a list of A's nodes and one of B's, of equal length.
class RefPairs {
  public:
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    void clear() { size_ = 0; }
    const std::uint32_t* a_begin() const { return a_.data(); }
    const std::uint32_t* b_begin() const { return b_.data(); }

    /// Makes room for `more` pairs. They are then written at the two ends, and grow() adds their
    /// number.
    void reserve(std::size_t more) {
        if (size_ + more <= a_.size()) return;
        const std::size_t room = std::max(2 * a_.size(), size_ + more);
        a_.resize(room);
        b_.resize(room);
    }
    std::uint32_t* a_end() { return a_.data() + size_; }
    std::uint32_t* b_end() { return b_.data() + size_; }
    void grow(std::size_t more) { size_ += more; }

    void add(std::uint32_t a, std::uint32_t b) {
        reserve(1);
        *a_end() = a;
        *b_end() = b;
        ++size_;
    }

    /// Appends pairs of another list.
    void append(const RefPairs& from, std::size_t first, std::size_t count) {
        reserve(count);
        std::copy_n(from.a_begin() + first, count, a_end());
        std::copy_n(from.b_begin() + first, count, b_end());
        size_ += count;
    }

    /// Moves the last pairs of another list, at most `most`, to the end of this list.
    void move_last(RefPairs& from, std::size_t most) {
        const std::size_t count = std::min(most, from.size_);
        from.size_ -= count;
        append(from, from.size_, count);
    }

    /// Moves the last pairs, at most `most`, into the arrays.
    std::size_t take(std::uint32_t* a, std::uint32_t* b, std::size_t most) {
        const std::size_t count = std::min(most, size_);
        size_ -= count;
        std::copy_n(a_.data() + size_, count, a);
        std::copy_n(b_.data() + size_, count, b);
        return count;
    }

  private:
    std::vector<std::uint32_t> a_, b_;
    std::size_t size_ = 0;
};

/// The waiting pairs, by whether A's and B's are inner nodes or leaves.
struct PackedLists {
    RefPairs inner_inner, inner_leaf, leaf_inner, leaf_leaf;
    RefPairs deferred;  ///< overlapping pairs; only A's node is to be divided

    void reserve(std::size_t more) {
        inner_inner.reserve(more);
        inner_leaf.reserve(more);
        leaf_inner.reserve(more);
        leaf_leaf.reserve(more);
    }
    bool empty() const { return size() == 0; }
    std::size_t size() const { return inner_size() + leaf_leaf.size(); }
    /// The number of pairs that can be divided.
    std::size_t inner_size() const {
        return inner_inner.size() + inner_leaf.size() + leaf_inner.size() + deferred.size();
    }
    void clear() {
        inner_inner.clear();
        inner_leaf.clear();
        leaf_inner.clear();
        leaf_leaf.clear();
        deferred.clear();
    }
    void append(const PackedLists& from) {
        inner_inner.append(from.inner_inner, 0, from.inner_inner.size());
        inner_leaf.append(from.inner_leaf, 0, from.inner_leaf.size());
        leaf_inner.append(from.leaf_inner, 0, from.leaf_inner.size());
        leaf_leaf.append(from.leaf_leaf, 0, from.leaf_leaf.size());
        deferred.append(from.deferred, 0, from.deferred.size());
    }
    void add(PackedRef a, PackedRef b) {
        RefPairs& list = a.is_leaf() ? (b.is_leaf() ? leaf_leaf : leaf_inner)
                                     : (b.is_leaf() ? inner_leaf : inner_inner);
        list.add(a.bits, b.bits);
    }
};

/// The results of a traversal, in no order.
struct PackedFindings {
    std::vector<IndexPair> pairs;       ///< triangles that certainly intersect
    std::vector<IndexPair> undecided;   ///< triangles that floats cannot decide
    std::uint64_t n_exact = 0;          ///< how many of these have been decided
    std::uint64_t n_after_doubles = 0;  ///< see PackedCollision
    PackedLists kept;  ///< the front, if the query makes one; `pairs` is empty then
    std::uint64_t n_v = 0, n_p = 0;

    void clear() {
        pairs.clear();
        undecided.clear();
        kept.clear();
        n_v = n_p = n_exact = n_after_doubles = 0;
    }
    void add(const PackedFindings& other) {
        pairs.insert(pairs.end(), other.pairs.begin(), other.pairs.end());
        undecided.insert(undecided.end(), other.undecided.begin(), other.undecided.end());
        kept.append(other.kept);
        n_v += other.n_v;
        n_p += other.n_p;
        n_exact += other.n_exact;
        n_after_doubles += other.n_after_doubles;
    }
};

/// The leaves of a packed hierarchy: their words, see PackedLeaf, and the mesh, if it has their
/// corners.
struct PackedLeaves {
    const float* words;
    const Mesh* mesh;
};
struct LeafQuery {
    PackedLeaves a, b;
    const Placement* placed;
    float skin = 0;  ///< more than 0: pairs of leaves this near are kept, see PackedQuery
};

/// Pairs of triangles whose planes meet, until there are enough for all lanes of the next test:
/// their indices, and the members of TrianglePairs as rows.
struct OpenPairs {
    static constexpr std::size_t enough = 64;
    std::size_t count = 0;
    float a[enough + 32] = {}, b[enough + 32] = {};  ///< bits of indices
    float points[18][enough + 32] = {};

    IndexPair pair(std::size_t i) const {
        return {std::bit_cast<std::uint32_t>(a[i]), std::bit_cast<std::uint32_t>(b[i])};
    }
};

/// How far a traversal goes before the pairs of leaves that it found are tested.
struct PackedPace {
    static constexpr std::size_t most_nodes = 32;
    std::size_t nodes = most_nodes;  ///< pairs of one list to divide before another list is chosen
    std::size_t leaves = 256;  ///< pairs of leaves to wait for: their tests are long runs of the
                               ///< same code
    std::size_t nearest = 0;   ///< the first so many pairs are divided one by one, nearest first
};

/// Divides every pair once, except pairs of leaves.
void divide_once(const AnyPackedQuery& query, SimdLevel level, PackedLists& lists,
                 PackedFindings& found);

/// Divides pairs until only pairs of leaves are left, or `pace.leaves` pairs of leaves wait.
void divide_nodes(const AnyPackedQuery& query, SimdLevel level, const PackedPace& pace,
                  PackedLists& lists, PackedFindings& found);

/// The same, and `steps` receives every test.
void divide_nodes(const AnyPackedQuery& query, PackedSteps& steps, PackedLists& lists,
                  PackedFindings& found);

/// Tests pairs of leaves for triangles that intersect; the list is empty then. Up to
/// OpenPairs::enough - 1 pairs may stay open until decide_open.
void test_leaves(const LeafQuery& query, SimdLevel level, RefPairs& pairs, OpenPairs& open,
                 PackedFindings& found);
void decide_open(const LeafQuery& query, SimdLevel level, OpenPairs& open, PackedFindings& found);

/// The exact test of a triangle of A and a triangle of B.
inline bool triangles_meet(const Mesh& a, const Mesh& b, const Pose& b_to_a, IndexPair pair) {
    return triangles_overlap(corners(a, pair.a), transform_corners(b_to_a, corners(b, pair.b)));
}

/// Decides the undecided pairs for which doubles are certain.
void decide_in_doubles(const Mesh& a, const Mesh& b, const Pose& b_to_a, SimdLevel level,
                       PackedFindings& found);

struct PackedFront::Parts {
    FrontSchedule schedule;
    PackedLists pairs;
    std::optional<IndexPair> met;  ///< the triangles that the last call of touches() found
};

// Always inline: GCC treats a function that only prefetches as a function without effect, and
// removes calls of it.

/// Fetches `bytes` bytes from `at` on into the cache, before their use.
HWY_INLINE void prefetch(const char* at, std::size_t bytes) {
    constexpr std::size_t line = 64;
    for (std::size_t k = 0; k < bytes; k += line) hwy::Prefetch(at + k);
}

HWY_INLINE void prefetch_leaf(const float* words) {
    prefetch(reinterpret_cast<const char*>(words), sizeof(float) * PackedLeaf::fetched_words);
}

}  // namespace scb
