#include "core/analysis/depth_matrix.h"

#include <algorithm>
#include <cassert>

namespace scb {

DepthMatrix depth_matrix(const Steps& steps) {
    DepthMatrix matrix;
    for (const Step& test : steps.volumes) {
        matrix.depths_a = std::max(matrix.depths_a, std::size_t{test.depth_a} + 1);
        matrix.depths_b = std::max(matrix.depths_b, std::size_t{test.depth_b} + 1);
    }
    matrix.cells.resize(matrix.depths_a * matrix.depths_b);
    for (const Step& test : steps.volumes) {
        DepthCell& cell = matrix.cells[test.depth_b * matrix.depths_a + test.depth_a];
        ++cell.tests;
        cell.rejected += test.stage != Stage::overlapping;
    }
    return matrix;
}

DepthMatrix coarser(const DepthMatrix& matrix, std::size_t step) {
    assert(step > 0 && "a cell holds at least one depth");
    DepthMatrix result{
        (matrix.depths_a + step - 1) / step, (matrix.depths_b + step - 1) / step, {}};
    result.cells.resize(result.depths_a * result.depths_b);
    for (std::size_t b = 0; b < matrix.depths_b; ++b)
        for (std::size_t a = 0; a < matrix.depths_a; ++a) {
            DepthCell& cell = result.cells[b / step * result.depths_a + a / step];
            cell.tests += matrix.at(a, b).tests;
            cell.rejected += matrix.at(a, b).rejected;
        }
    return result;
}

}  // namespace scb
