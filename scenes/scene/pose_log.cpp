#include "scenes/scene/pose_log.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/text_format.h"
#include "core/platform/input_files.h"
#include "core/platform/number_rows.h"
#include "scb/error.h"
#include "scenes/scene/pose_rows.h"
#include "scenes/scene/scene.h"

namespace scb::scenes {
namespace {

constexpr std::size_t of_matrix = 12, of_position = 3, of_quaternion = 4,
                      of_trajectory = of_position + of_quaternion;

/// Whether a header names w before z, as other formats write quaternions.
bool names_w_first(const std::vector<std::string>& header) {
    const auto ends_with = [](char letter) {
        return [letter](std::string_view cell) { return cell.ends_with(letter); };
    };
    const auto w = std::find_if(header.begin(), header.end(), ends_with('w'));
    return w != header.end() && std::any_of(w, header.end(), ends_with('z'));
}

/// The rows of one log.
class LogReader {
  public:
    LogReader(const std::string& path, bool exact) : path_(path), rows_(path), exact_(exact) {}

    Motion read() {
        while (const std::optional<NumberRows::Cells> cells = rows_.next()) add(*cells);
        if (motion_.told.empty())
            throw InputError(path_ +
                             ": it has no poses; give rows of 12 numbers, [R|t] row by row, or of "
                             "tx ty tz qx qy qz qw.");
        motion_.log = path_;
        return std::move(motion_);
    }

  private:
    void add(const NumberRows::Cells& cells) {
        check_count(cells.size());
        if (motion_.told.size() == static_cast<std::size_t>(most_frames))
            rows_.refuse("more than " + counted(most_frames, "pose", "poses") +
                         "; give a part of the log.");
        const Pose pose = pose_of(rows_.numbers(cells, max_coordinate));
        const NearestPose nearest = rigid_pose(pose, exact_, rows_.place());
        if (nearest.correction > motion_.correction) {
            motion_.correction = nearest.correction;
            motion_.corrected_line = rows_.line();
        }
        motion_.told.push_back({static_cast<int>(motion_.told.size()), nearest.pose});
    }

    void check_count(std::size_t count) {
        if (columns_ == 0) {
            if (count != of_matrix && count != of_trajectory && count != of_trajectory + 1)
                rows_.refuse(
                    sentence("it has ", counted(count, "column", "columns"),
                             "; give 12 numbers, [R|t] row by row, or tx ty tz qx qy qz qw, "
                             "with or without a time stamp before."));
            if (count != of_matrix && names_w_first(rows_.header()))
                rows_.refuse("the header names w before z; write quaternions as qx qy qz qw.");
            columns_ = count;
        }
        if (count != columns_)
            rows_.refuse(sentence("it has ", counted(count, "column", "columns"),
                                  ", and the rows before have ", columns_,
                                  "; give one pose per row."));
    }

    Pose pose_of(const std::vector<double>& numbers) const {
        if (numbers.size() != of_matrix) {
            const double* const first = numbers.data() + numbers.size() - of_trajectory;
            Pose pose;
            pose.translation = Vec3(first[0], first[1], first[2]);
            pose.rotation = rotation_of(first + of_position);
            return pose;
        }
        PoseRows rows{};
        std::copy(numbers.begin(), numbers.end(), rows.begin());
        return scenes::pose_of(rows);
    }

    /// The rotation of a quaternion x y z w, times its length. So R^T R differs from the identity
    /// by as much as the squared length differs from 1.
    Mat3 rotation_of(const double* q) const {
        const double x = q[0], y = q[1], z = q[2], w = q[3],
                     squared = x * x + y * y + z * z + w * w, length = std::sqrt(squared),
                     defect = std::abs(squared - 1);
        if (!(defect <= (exact_ ? 1e-9 : 1e-3)))
            rows_.refuse(sentence("the squared length of the quaternion differs from 1 by ", defect,
                                  ", ", exact_ ? "1e-9" : "1e-3",
                                  " is allowed; give qx qy qz qw of a unit quaternion."));
        Mat3 m;
        m << x * x - y * y - z * z + w * w, 2 * (x * y - z * w), 2 * (x * z + y * w),  //
            2 * (x * y + z * w), y * y - x * x - z * z + w * w, 2 * (y * z - x * w),   //
            2 * (x * z - y * w), 2 * (y * z + x * w), z * z - x * x - y * y + w * w;
        return m / length;
    }

    std::string path_;
    NumberRows rows_;
    bool exact_;
    std::size_t columns_ = 0;  ///< of each row; 0: before the first
    Motion motion_;
};

}  // namespace

Motion PoseLogs::read(const std::filesystem::path& file) {
    note_input(file);
    Motion motion = LogReader(file.string(), exact_).read();
    const auto frames = static_cast<int>(motion.told.size());
    if (frames_ != 0 && frames != frames_)
        throw InputError(sentence(
            file.string(), ": it has ", counted(motion.told.size(), "pose", "poses"), ", and ",
            first_.string(), " has ", frames_, "; all logs must have as many rows."));
    if (frames_ == 0) first_ = file;
    frames_ = frames;
    return motion;
}

}  // namespace scb::scenes
