#include "scb/fit_points.h"

#include "core/fit/box_axes.h"

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

}  // namespace scb
