#pragma once

#include "core/analysis/depth_matrix.h"
#include "core/base/enum_names.h"
#include "render/overlay/scales.h"

namespace scb::render {

/// The meaning of the colors of a matrix of depths.
enum class MatrixMeasure {
    tests,  ///< the number of volume tests; logarithmic, from 1 to a power of ten
    share,  ///< the share of rejected tests; linear, from 0 to 1
};
inline constexpr EnumNames<MatrixMeasure, 2> matrix_measure_names = {"tests", "share"};

/// Draws the cells as large as the rectangle allows, the depth of A from left to right and the
/// depth of B from top to bottom, with the depths beside them and the scale of colors below. Cells
/// without tests are pale. If there is room in all cells, they have their number (share: in
/// percent). If there are too many depths, a cell is for several depths, and the scale says so.
/// Returns the covered rectangle.
PixelRect draw_depth_matrix(Overlay& overlay, const PixelRect& rect, const DepthMatrix& matrix,
                            MatrixMeasure measure, const FigureStyle& style);

/// 987, 1k, 1.0k (a little more), 12k, 123k, 1.2M: at most four characters below 1000G. Rounded
/// down.
std::string short_count(std::uint64_t count);

}  // namespace scb::render
