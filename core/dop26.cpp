#include "core/dop26.h"

#include <limits>

namespace scb {
namespace {

// Direction.p for all 13 directions. dop26_directions() lists them in the same order.
inline std::array<double, Dop26::directions> project(double x, double y, double z) {
    const double xy = x + y, x_y = x - y;
    return {x, y, z, xy, x_y, x + z, x - z, y + z, y - z, xy + z, xy - z, x_y + z, x_y - z};
}

}  // namespace

const std::array<Vec3, Dop26::directions>& dop26_directions() {
    static const std::array<Vec3, Dop26::directions> list = [] {
        std::array<Vec3, Dop26::directions> result;
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 unit = Vec3::Unit(axis);
            const auto along = project(unit[0], unit[1], unit[2]);
            for (int i = 0; i < Dop26::directions; ++i)
                result[static_cast<std::size_t>(i)][axis] = along[static_cast<std::size_t>(i)];
        }
        return result;
    }();
    return list;
}

double dop26_inverse_length(int direction) {
    constexpr double inverse_sqrt2 = 0.70710678118654752440;
    constexpr double inverse_sqrt3 = 0.57735026918962576451;
    return direction < 3 ? 1.0 : direction < 9 ? inverse_sqrt2 : inverse_sqrt3;
}

Dop26 empty_dop26() {
    Dop26 dop;
    dop.upper.fill(-std::numeric_limits<double>::infinity());
    dop.lower.fill(std::numeric_limits<double>::infinity());
    dop.upper_id.fill(std::numeric_limits<std::uint32_t>::max());
    dop.lower_id.fill(std::numeric_limits<std::uint32_t>::max());
    return dop;
}

void add_point(Dop26& dop, double x, double y, double z, std::uint32_t id) {
    const auto along = project(x, y, z);
    for (std::size_t i = 0; i < along.size(); ++i) {
        const double value = along[i];
        if (value > dop.upper[i] || (value == dop.upper[i] && id < dop.upper_id[i])) {
            dop.upper[i] = value;
            dop.upper_id[i] = id;
        }
        if (value < dop.lower[i] || (value == dop.lower[i] && id < dop.lower_id[i])) {
            dop.lower[i] = value;
            dop.lower_id[i] = id;
        }
    }
}

Dop26 merge(const Dop26& a, const Dop26& b) {
    Dop26 dop;
    for (std::size_t i = 0; i < Dop26::directions; ++i) {
        // Without branches: which child is the more extreme cannot be predicted.
        const int b_upper = int{b.upper[i] > a.upper[i]} |
                            (int{b.upper[i] == a.upper[i]} & int{b.upper_id[i] < a.upper_id[i]});
        const int b_lower = int{b.lower[i] < a.lower[i]} |
                            (int{b.lower[i] == a.lower[i]} & int{b.lower_id[i] < a.lower_id[i]});
        dop.upper[i] = b_upper ? b.upper[i] : a.upper[i];
        dop.lower[i] = b_lower ? b.lower[i] : a.lower[i];
        dop.upper_id[i] = b_upper ? b.upper_id[i] : a.upper_id[i];
        dop.lower_id[i] = b_lower ? b.lower_id[i] : a.lower_id[i];
    }
    return dop;
}

Dop26 dop26_of(const PointsView& points, std::uint32_t first_id) {
    Dop26 dop = empty_dop26();
    for (std::size_t i = 0; i < points.size; ++i)
        add_point(dop, points.x[i], points.y[i], points.z[i],
                  first_id + static_cast<std::uint32_t>(i));
    return dop;
}

}  // namespace scb
