#include "scb/fit_points.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/fit/fit_input.h"

namespace scb {

FitPoints::FitPoints(const FitInput& input) : input_(input) {
    for (std::size_t i = 0; i < 2; ++i) {
        const PointsView& part = input.parts[i];
        parts_[i] = {part.x, part.y, part.z};
        sizes_[i] = part.size;
    }
}

double FitPoints::lower(std::size_t direction) const { return input_.dop->lower[direction]; }
double FitPoints::upper(std::size_t direction) const { return input_.dop->upper[direction]; }
Mat3 FitPoints::axes() const { return box_axes(input_); }

namespace {

// The scatter of points about their mean, for a surface without area.
Mat3 point_scatter(const FitInput& input) {
    Vec3 mean = Vec3::Zero();
    for (const PointsView& part : input.parts)
        for (std::size_t i = 0; i < part.size; ++i) mean += part[i];
    mean /= static_cast<double>(input.size());
    Mat3 scatter = Mat3::Zero();
    for (const PointsView& part : input.parts)
        for (std::size_t i = 0; i < part.size; ++i) {
            const Vec3 q = part[i] - mean;
            for (int column = 0; column < 3; ++column)
                for (int row = 0; row < 3; ++row) scatter(row, column) += q[row] * q[column];
        }
    return scatter;
}

// A right-handed frame of eigenvectors, the longest direction first; the coordinate axes if the
// scatter has no direction.
Mat3 principal_axes(Mat3 scatter) {
    const double scale = scatter.cwiseAbs().maxCoeff();
    if (!(scale > 0) || !std::isfinite(scale)) return Mat3::Identity();
    scatter /= scale;
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(scatter);
    if (solver.info() != Eigen::Success) return Mat3::Identity();
    Mat3 axes;
    axes.col(0) = solver.eigenvectors().col(2);
    axes.col(1) = solver.eigenvectors().col(1);
    axes.col(2) = cross(axes.col(0), axes.col(1));
    return axes;
}

}  // namespace

Mat3 box_axes(const FitInput& input) {
    const bool has_area = input.moments != nullptr && input.moments->area > 0;
    return principal_axes(has_area ? input.moments->scatter : point_scatter(input));
}

}  // namespace scb
