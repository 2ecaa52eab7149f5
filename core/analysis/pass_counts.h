#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>

#include "core/base/enum_names.h"

namespace scb {

/// Why a test let a pair of nodes pass.
enum class PassReason : std::uint8_t {
    weak_test,       ///< the volumes are disjoint: the test is conservative
    loose_fit,       ///< the volumes meet, but no triangles below them do
    triangles_meet,  ///< triangles below them intersect
};
inline constexpr std::size_t pass_reason_count = 3;

inline constexpr EnumNames<PassReason, pass_reason_count> pass_reason_names = {"test", "fit",
                                                                               "true"};

/// The work of a query, or of a part of it.
struct Work {
    std::uint64_t volume_tests = 0;
    std::uint64_t triangle_tests = 0;
    std::uint64_t operations = 0;   ///< of the volume tests, see operation_cost
    std::uint64_t picoseconds = 0;  ///< see assumed_time; 0 if unknown: of another engine, of parts

    Work& operator+=(const Work& other);
    Work& operator-=(const Work& other);
    /// By volume tests first, then by triangle tests, then by operations, then by time.
    friend auto operator<=>(const Work&, const Work&) = default;
};

/// The words of reports for the cost of a setting, which is Work::picoseconds.
inline constexpr const char* cost_words = "assumed time of the tests, the same on every machine";

/// The passed pairs of a query, or of several, and the work below the false ones.
///
/// A pair is false if it passed although no triangles below it intersect. A test is wasted if the
/// pair whose division led to it is false; so is the test of two triangles after a false pair of
/// leaves. The wasted work is the work below the outermost false pairs. An exact overlap test would
/// save the wasted work below pairs that a weak test passed; the rest is due to the fit.
struct PassCounts {
    std::array<std::uint64_t, pass_reason_count> inner{}, leaves{};  ///< passed pairs by reason
    std::uint64_t touching = 0;  ///< passed pairs whose volumes only touch
    /// Tests that rejected volumes which overlap, or hold triangles that intersect.
    std::uint64_t wrongly_rejected = 0;
    std::uint64_t missed = 0;  ///< intersecting pairs of triangles below these tests
    Work all, wasted;
    Work wasted_by_tests;  ///< wasted work that an exact test would save

    std::uint64_t passed() const;
    std::uint64_t passed(PassReason reason) const;
    /// The wasted work that is due to the fit.
    Work wasted_by_fit() const;
    PassCounts& operator+=(const PassCounts& other);
};

}  // namespace scb
