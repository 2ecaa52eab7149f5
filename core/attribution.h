#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/contact_proof.h"
#include "core/trace.h"

namespace scb {

/// Why a test let a pair of nodes pass.
enum class PassReason : std::uint8_t {
    weak_test,  ///< the volumes are disjoint: the test is conservative
    loose_fit,  ///< the volumes meet, but no triangles below them do
    contact,    ///< triangles below them intersect
};
inline constexpr std::size_t pass_reason_count = 3;

/// "test", "fit", "true".
std::string_view pass_reason_name(PassReason reason);

/// What a query did.
struct Work {
    std::uint64_t volume_tests = 0;
    std::uint64_t triangle_tests = 0;
    std::uint64_t operations = 0;  ///< of the volume tests, see operation_cost

    Work& operator+=(const Work& other);
    friend bool operator==(const Work&, const Work&) = default;
};

/// A volume test that let its pair pass.
struct PassedPair {
    std::uint32_t test = 0;  ///< index into Events::volume_tests
    PassReason reason = PassReason::contact;
    bool leaves = false;  ///< both nodes are leaves
    /// Whether the division of a false pair led here, at whatever distance; or that of one that
    /// passed because of a weak test.
    bool within_false_pair = false, within_weak_test = false;
    Contact exact = Contact::overlapping;  ///< of the volumes
    double gap = 0;                        ///< of disjoint volumes, at least; in the scene's unit
    Work below;                            ///< what came of it: wasted, where the pair is false
};

/// What the tests of a query passed on, why, and what that cost.
///
/// A test is wasted where the pair whose division led to it is false, that is, passed for another
/// reason than contact; so is the test of two triangles after a false pair of leaves. The wasted
/// work is that below the false pairs that are not within another one, and all work is that and
/// the work that is not wasted. An exact overlap test would save the wasted work below pairs that
/// passed because of a weak test; the rest is due to the fit.
struct Attribution {
    std::vector<PassedPair> passed;  ///< in the order of the tests
    /// Tests that rejected volumes which overlap: errors of the test. Ascending.
    std::vector<std::uint32_t> wrongly_rejected;
    Work all, wasted;
    Work wasted_by_tests;  ///< of the wasted work, what an exact test would save
    /// Passed pairs by reason: of inner nodes and of two leaves.
    std::array<std::uint64_t, pass_reason_count> inner{}, leaves{};
    std::uint64_t touching = 0;  ///< passed pairs whose volumes touch, within contact_tolerance

    std::uint64_t count(PassReason reason) const;
};

/// Attributes every volume test of a query of two hierarchies with the trace's header, by the exact
/// overlap of the volumes. `tree` is test_tree's. `contacts` are all pairs of triangles that
/// intersect, as a query without limits and with a test that rejects no overlap finds them; sorted
/// or not.
Attribution attribute(const AnyHierarchy& a, const AnyHierarchy& b, const TraceHeader& header,
                      const TraceFrame& frame, const TestTree& tree,
                      std::span<const IndexPair> contacts);

}  // namespace scb
