#pragma once

#include <cstdint>
#include <unordered_map>

#include "core/packed/packed_query.h"
#include "core/traverse/step_numbers.h"

namespace scb {

/// Two nodes or leaves of packed hierarchies.
struct RefPair {
    PackedRef a, b;
};

/// Passes the tests of one query on packed hierarchies to an observer, as numbered steps. The exact
/// tests of two triangles follow the step of their leaves at once, before the lanes test them.
class PackedSteps {
  public:
    /// Refers to its arguments.
    PackedSteps(CalledObserver& observer, const LeafQuery& leaves, const Mesh& a, const Mesh& b);

    /// Two roots, which no volume test precedes.
    void begin(RefPair roots);
    /// A test of two volumes. `parent`: a pair that overlaps, whose division led to this test.
    void test(RefPair pair, bool overlap, RefPair parent);

  private:
    /// A pair of nodes that overlap. Its nodes lead to it once, so the pair identifies it.
    struct Overlap {
        std::uint32_t step;
        int depth_a, depth_b;
    };
    static std::uint64_t key(RefPair pair) {
        return std::uint64_t{pair.a.bits} << 32 | pair.b.bits;
    }
    void add(RefPair pair, const Overlap& overlap);
    void test_items(RefPair pair, std::uint32_t step);

    StepNumbers<CalledObserver> numbers_;
    const LeafQuery& leaves_;
    const Mesh &a_, &b_;
    const Pose& b_to_a_;
    std::unordered_map<std::uint64_t, Overlap> overlaps_;  ///< never iterated
};

}  // namespace scb
