#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/analysis/outcome.h"
#include "core/analysis/trace.h"
#include "render/overlay/scales.h"
#include "render/plots/ending_colors.h"
#include "scb/step_recorder.h"

namespace scb::render {

/// Neighboring columns of one row of an icicle with the same look.
struct IcicleRun {
    static constexpr std::uint32_t divided = 0xffffffff;
    static constexpr std::uint32_t several = 0xffffffff;

    int row = 0;
    int begin = 0, end = 0;   ///< columns: end is the first one after the run
    std::uint32_t group = 0;  ///< index of the endings' group, or `divided`
    std::uint32_t test = 0;   ///< index of the only volume test there, or `several`
};

/// Columns of one row whose tests are too narrow to be drawn one by one: the number of tests per
/// outcome that begin there.
struct IcicleStack {
    int row = 0;
    int begin = 0, end = 0;
    std::uint32_t tests = 0;
    std::uint32_t divided = 0;
    std::array<std::uint32_t, most_groups> groups{};  ///< by index of the endings' group
};

/// The recursion of a traversal as an icicle (Kruskal and Landwehr, "Icicle Plots", The American
/// Statistician 37, 1983): every volume test is a rectangle one row below the pair whose division
/// led to it. Its width is the share of its subtree in all tests (subtree_sizes). The children of a
/// pair lie below its left end, in the order of the tests; the rest at its right end is the pair's
/// own test.
///
/// Each row is cut into blocks of columns. A block whose tests are narrower than two columns on
/// average is a stack, since single tests would look like noise. In other blocks, a column has the
/// outcome that covers most of it.
struct Icicle {
    int columns = 0;
    int rows = 0;
    int first_depth = 0;              ///< of the first row
    int depths_per_row = 1;           ///< more than 1 if there are more depths than rows
    std::vector<IcicleRun> runs;      ///< row by row, from left to right
    std::vector<IcicleStack> stacks;  ///< the same
};

/// The icicle of a query's steps and their outcomes, or of a part of a query; `groups` must have
/// all endings that occur. `columns`, `most_rows` and `block` (columns of a block) are at least 1.
Icicle icicle(const Steps& steps, const Outcomes& outcomes, const std::vector<EndingGroup>& groups,
              int columns, int most_rows, int block);

/// The color of pairs that were divided: pale, so that the endings stand out.
Rgba8 divided_color(const Theme& theme);

/// Which elements an icicle has, for its caption.
struct DrawnIcicle {
    PixelRect covered;
    bool numbers = false;  ///< at least one
    bool stacks = false;   ///< at least one
};

/// Draws a frame's recursion (see Icicle) as wide as the rectangle, with the depth of a row's pairs
/// at its left. If there is room, rectangles of divided pairs show the number of their tests.
DrawnIcicle draw_icicle(Overlay& overlay, const PixelRect& rect, const Steps& steps,
                        const Outcomes& outcomes, const std::vector<EndingGroup>& groups,
                        const FigureStyle& style);

}  // namespace scb::render
