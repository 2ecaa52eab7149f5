#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/enum_names.h"
#include "scb/collide.h"

namespace scb {

/// Why a test let a pair of nodes pass. In a query of distances, volumes meet if they are nearer
/// than the answer, which is the smallest distance or the tolerance; triangles, if they are as
/// near.
enum class PassReason : std::uint8_t {
    weak_test,       ///< the volumes are disjoint: the test, or the bound, is conservative
    loose_fit,       ///< the volumes meet, but no triangles below them do
    triangles_meet,  ///< triangles below them intersect
    early,           ///< of distances: the bound is above the answer, which was not known yet
    unjudged,        ///< of distances: nothing below meets, and no proof says if the volumes do
};
inline constexpr std::size_t pass_reason_count = 5;

inline constexpr EnumNames<PassReason, pass_reason_count> pass_reason_names = {
    "test", "fit", "true", "early", "not_judged"};

/// Of the reasons of two pairs above a test, the one for which the test was wasted: the one that is
/// cured most easily, see PassCounts.
PassReason governing_reason(PassReason x, PassReason y);

/// Tests by the reason for which they were wasted; none for triangles_meet.
struct WastedTests {
    std::array<std::uint64_t, pass_reason_count> by_reason{};

    std::uint64_t by(PassReason reason) const {
        return by_reason[static_cast<std::size_t>(reason)];
    }
    std::uint64_t all() const;
    /// Counts a test, unless the reason is triangles_meet.
    void add(PassReason reason) {
        by_reason[static_cast<std::size_t>(reason)] += reason != PassReason::triangles_meet;
    }
    WastedTests& operator+=(const WastedTests& other);
};

/// The reasons for which a query of this kind can waste tests, in the order of reports.
std::vector<PassReason> waste_reasons(QueryKind kind);

/// The work of a query, or of a part of it.
struct Work {
    std::uint64_t volume_tests = 0;
    std::uint64_t triangle_tests = 0;
    std::uint64_t operations = 0;   ///< of the volume tests, see operation_cost
    std::uint64_t picoseconds = 0;  ///< see assumed_time; 0 if unknown: of another engine, of parts

    Work& operator+=(const Work& other);
    /// By volume tests first, then by triangle tests, then by operations, then by time.
    friend auto operator<=>(const Work&, const Work&) = default;
};

/// The words of reports for the cost of a setting, which is Work::picoseconds.
inline constexpr const char* cost_words = "assumed time of the tests, the same on every machine";

/// The passed pairs of a query, or of several, and the work below the false ones.
///
/// A pair is false if it passed although no triangles below it intersect. A test is wasted if the
/// pair whose division led to it is false; so is the test of two triangles after a false pair of
/// leaves. The wasted work is the work below the outermost false pairs. An answer known from the
/// start would save the work below early pairs. An exact test would save the work below pairs that
/// a weak test passed. Of the rest, the fit is the reason, unless the pair above is not judged.
struct PassCounts {
    std::array<std::uint64_t, pass_reason_count> inner{}, leaves{};  ///< passed pairs by reason
    std::uint64_t touching = 0;  ///< passed pairs whose volumes only touch
    /// Tests that rejected volumes which overlap, or hold triangles that intersect.
    std::uint64_t wrongly_rejected = 0;
    std::uint64_t missed = 0;  ///< intersecting pairs of triangles below these tests
    Work all;
    std::array<Work, pass_reason_count> wasted_for{};  ///< the wasted work by its reason

    /// The wasted work for all reasons.
    Work wasted() const;
    std::uint64_t passed() const;
    std::uint64_t passed(PassReason reason) const;
    /// The wasted work for this reason; none for triangles_meet.
    const Work& wasted_by(PassReason reason) const {
        return wasted_for[static_cast<std::size_t>(reason)];
    }
    /// Adds wasted work, and nothing for triangles_meet.
    void waste(PassReason reason, const Work& work);
    PassCounts& operator+=(const PassCounts& other);
};

}  // namespace scb
