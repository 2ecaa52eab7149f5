#pragma once

#include "core/attribution.h"

namespace scb {

/// The volume tests of pairs at one depth: the depths of both nodes added.
struct DepthInspection {
    std::uint64_t tests = 0;
    std::uint64_t wasted = 0;  ///< of these, those that a false pair led to
    std::array<std::uint64_t, pass_reason_count> passed{};  ///< by reason
};

/// What the tests of a query, or of several together, passed on and wasted.
struct Inspection {
    std::uint64_t pairs = 0, n_v = 0, n_p = 0;
    std::array<std::uint64_t, pass_reason_count> inner{}, leaves{};  ///< passed pairs by reason
    std::uint64_t touching = 0;          ///< passed pairs whose volumes only touch
    std::uint64_t wrongly_rejected = 0;  ///< tests that rejected volumes which overlap
    Work all, wasted;
    Work wasted_by_tests;                 ///< of the wasted work, what an exact test would save
    std::vector<DepthInspection> depths;  ///< from 0

    std::uint64_t passed(PassReason reason) const {
        const auto i = static_cast<std::size_t>(reason);
        return inner[i] + leaves[i];
    }
    std::uint64_t passed() const;
    /// The wasted work that is not the tests' fault.
    Work wasted_by_fit() const;
    void add(const Inspection& other);
};

Inspection inspection(const TraceFrame& frame, const TestTree& tree,
                      const Attribution& attribution);

/// A pair that should not have passed, or should have.
struct FalsePair {
    int frame = 0;
    PassedPair pair;
    VolumeTest test;
};

/// The false pairs of one reason that cost the most, of as many frames as are added: by the tests
/// below them (of volumes and of triangles), then by frame and by the order of the tests. Of weak
/// tests those that are not within another one; of loose fits those that are not within any false
/// pair.
class WorstPairs {
  public:
    WorstPairs(PassReason reason, std::size_t most) : reason_(reason), most_(most) {}

    void add(const TraceFrame& frame, const Attribution& attribution);
    /// The worst one first.
    const std::vector<FalsePair>& pairs() const { return pairs_; }

  private:
    PassReason reason_;
    std::size_t most_;
    std::vector<FalsePair> pairs_;
};

/// What another overlap test makes of a query.
struct OtherTest {
    OverlapOptions overlap;
    std::uint64_t caught = 0;  ///< pairs that passed because of a weak test, which this one rejects
    std::uint64_t pairs = 0;   ///< that the whole query finds with it
    Work all;                  ///< that the whole query takes with it

    void add(const OtherTest& other);
};

/// The tests that could be taken in place of the trace's one: the sound ones, and the threshold of
/// Figure 8 at several places. None for other volumes than slab cut balls.
std::vector<OverlapOptions> other_tests(const TraceHeader& header);

/// Makes the query again with another test.
OtherTest try_other_test(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                         const Mesh& mesh_b, const TraceHeader& header, const TraceFrame& frame,
                         const Attribution& attribution, const OverlapOptions& other);

}  // namespace scb
