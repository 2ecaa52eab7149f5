#include "scenes/scene/pose_rows.h"

namespace scb::scenes {

PoseRows rows_of(const Pose& pose) {
    PoseRows rows{};
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const auto row = static_cast<Eigen::Index>(k / 4),
                   column = static_cast<Eigen::Index>(k % 4);
        rows[k] = column < 3 ? pose.rotation(row, column) : pose.translation[row];
    }
    return rows;
}

Pose pose_of(const PoseRows& rows) {
    Pose pose;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const auto row = static_cast<Eigen::Index>(k / 4),
                   column = static_cast<Eigen::Index>(k % 4);
        (column < 3 ? pose.rotation(row, column) : pose.translation[row]) = rows[k];
    }
    return pose;
}

}  // namespace scb::scenes
