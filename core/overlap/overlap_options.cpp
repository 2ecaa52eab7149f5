#include "scb/overlap_options.h"

#include <array>

#include "core/base/enum_names.h"
#include "core/base/text_format.h"

namespace scb {
namespace {

constexpr std::array tests = {OverlapTest::printed, OverlapTest::line8, OverlapTest::corrected,
                              OverlapTest::symmetric, OverlapTest::extents};
constexpr EnumNames<OverlapTest, tests.size()> test_names = {"printed", "line8", "corrected",
                                                             "symmetric", "extents"};

constexpr std::array table_1 = {Stage::ball_ball, Stage::slab_ball, Stage::ball_slab,
                                Stage::slab_cylinder, Stage::cylinder_slab};
constexpr std::array extents = {Stage::ball_ball, Stage::slab_a, Stage::slab_b, Stage::center_line};
constexpr std::array two_slabs = {Stage::ball_ball, Stage::slab_a,        Stage::second_slab_a,
                                  Stage::slab_b,    Stage::second_slab_b, Stage::center_line,
                                  Stage::long_axes};
constexpr std::array by_search = {Stage::center_line, Stage::search};
constexpr std::array axes = {
    Stage::axis_a0,    Stage::axis_a1,    Stage::axis_a2,    Stage::axis_b0,    Stage::axis_b1,
    Stage::axis_b2,    Stage::axis_a0_b0, Stage::axis_a0_b1, Stage::axis_a0_b2, Stage::axis_a1_b0,
    Stage::axis_a1_b1, Stage::axis_a1_b2, Stage::axis_a2_b0, Stage::axis_a2_b1, Stage::axis_a2_b2};

}  // namespace

std::string_view overlap_test_name(OverlapTest test) { return test_names[test]; }
std::optional<OverlapTest> overlap_test_of(std::string_view name) { return test_names.find(name); }

std::span<const OverlapTest> all_overlap_tests() { return tests; }

bool is_sound(OverlapTest test) { return test != OverlapTest::printed; }

bool has_threshold(OverlapTest test) {
    return test != OverlapTest::symmetric && test != OverlapTest::extents;
}

std::span<const Stage> stages_of(OverlapTest test) {
    if (test == OverlapTest::extents) return extents;
    return table_1;
}

std::span<const Stage> ball_stages() { return std::span(table_1).first(1); }

std::span<const Stage> scb2_stages() { return two_slabs; }

std::span<const Stage> obb_stages() { return axes; }

std::span<const Stage> aabb_stages() { return std::span(axes).first(3); }

std::span<const Stage> convex_stages() { return by_search; }

std::string overlap_title(const OverlapOptions& options) {
    std::string title(overlap_test_name(options.test));
    if (has_threshold(options.test)) title += format(" a=%g", options.threshold);
    return title;
}

}  // namespace scb
