#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scb/stage.h"

namespace scb {

/// The overlap tests for two slab cut balls, by name. Except for `printed`, no test rejects a pair
/// that overlaps or touches. Every test lets some pairs pass that do neither.
enum class OverlapTest {
    printed,    ///< Figure 8 as printed, to show the effect of its errors
    line8,      ///< Figure 8 with line 8 corrected, lines 20 and 23 as printed
    corrected,  ///< Figure 8 with both corrected
    symmetric,  ///< Figure 8 without cases and threshold: rejects all that `corrected` rejects
    extents,    ///< by exact extents along both normals and the line through the centers
};

/// "printed", "line8", "corrected", "symmetric", "extents".
std::string_view overlap_test_name(OverlapTest test);
/// The test with this name; no value if no test has the name.
std::optional<OverlapTest> overlap_test_of(std::string_view name);
/// All tests, in the order in which they are declared.
std::span<const OverlapTest> all_overlap_tests();

/// Whether the test uses OverlapOptions::threshold.
bool has_threshold(OverlapTest test);

/// Whether the test never rejects volumes that overlap or touch: all but `printed`.
bool is_sound(OverlapTest test);

/// How two slab cut balls are tested. Ignored for other volumes.
struct OverlapOptions {
    OverlapTest test = OverlapTest::symmetric;  ///< the quickest over Table 3's scenes
    /// The paper's a, from 0 to 1, for the forms of Figure 8; below 0 they would reject wrongly.
    double threshold = 0.7;
};

/// "symmetric", "corrected a=0.7": with the threshold if the test has one.
std::string overlap_title(const OverlapOptions& options);

/// The stages at which this test of slab cut balls can reject, in the order of the test.
std::span<const Stage> stages_of(OverlapTest test);
/// The same for balls.
std::span<const Stage> ball_stages();
/// The same for balls cut by two slabs.
std::span<const Stage> scb2_stages();
/// The same for oriented boxes, and for boxes along the axes tested exactly.
std::span<const Stage> obb_stages();
std::span<const Stage> aabb_stages();  ///< as engines test them
/// The same for convex volumes by their farthest points.
std::span<const Stage> convex_stages();

}  // namespace scb
