#pragma once

#include "core/analysis/depth_matrix.h"
#include "core/base/enum_names.h"
#include "render/overlay/scales.h"

namespace scb::render {

/// What the colors of a matrix of depths say.
enum class MatrixMeasure {
    tests,  ///< how many volume tests; logarithmic, from 1 to a power of ten
    share,  ///< which share of them was rejected; linear, from 0 to 1
};
inline constexpr EnumNames<MatrixMeasure, 2> matrix_measure_names = {"tests", "share"};

/// Draws the cells as far as the rectangle allows, the depth of A from left to right and that of B
/// from top to bottom, with the depths beside them and the scale of colors below. Cells without
/// tests are pale. Cells carry their number (share: in percent) where all of them can. Where there
/// are more depths than cells can be told apart, a cell holds several, and the scale says so.
/// Returns what is covered.
PixelRect draw_depth_matrix(Overlay& overlay, const PixelRect& rect, const DepthMatrix& matrix,
                            MatrixMeasure measure, const FigureStyle& style);

/// 987, 1k, 1.0k (a little more), 12k, 123k, 1.2M: at most four characters below 1000G. Rounded
/// down.
std::string short_count(std::uint64_t count);

}  // namespace scb::render
