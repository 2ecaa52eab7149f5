#include "scenes/scene/pose_log.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "core/base/text_format.h"
#include "core/platform/input_files.h"
#include "core/platform/text_lines.h"
#include "core/platform/tokens.h"
#include "scb/error.h"
#include "scenes/scene/pose_rows.h"
#include "scenes/scene/scene.h"

namespace scb::scenes {
namespace {

using Cells = std::vector<std::string_view>;

constexpr std::size_t of_matrix = 12, of_position = 3, of_quaternion = 4,
                      of_trajectory = of_position + of_quaternion;

/// What blanks, commas or semicolons separate; blanks about a comma or semicolon belong to it.
Cells cells_of(std::string_view line) {
    constexpr std::string_view blanks = " \t\r\v\f", separators = " \t\r\v\f,;";
    const auto skip_blanks = [&] {
        line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    };
    Cells cells;
    skip_blanks();
    while (true) {
        const std::size_t end = std::min(line.find_first_of(separators), line.size());
        cells.push_back(line.substr(0, end));
        line.remove_prefix(end);
        skip_blanks();
        if (line.empty()) return cells;
        if (line.front() != ',' && line.front() != ';') continue;
        line.remove_prefix(1);
        skip_blanks();
    }
}

bool has_number(const Cells& cells) {
    return std::any_of(cells.begin(), cells.end(),
                       [](std::string_view cell) { return number_in(cell).has_value(); });
}

/// Whether a header names w before z, as other formats write quaternions.
bool names_w_first(const Cells& header) {
    const auto ends_with = [](char letter) {
        return [letter](std::string_view cell) { return cell.ends_with(letter); };
    };
    const auto w = std::find_if(header.begin(), header.end(), ends_with('w'));
    return w != header.end() && std::any_of(w, header.end(), ends_with('z'));
}

/// The rows of one log.
class LogReader {
  public:
    LogReader(const std::string& path, bool exact) : path_(path), lines_(path), exact_(exact) {}

    Motion read() {
        while (const std::optional<std::string_view> line = lines_.next()) {
            const Cells cells = cells_of(*line);
            const bool is_blank = cells.size() == 1 && cells[0].empty();
            if (!is_blank && !cells[0].starts_with('#')) add(cells);
        }
        if (motion_.told.empty())
            throw InputError(path_ +
                             ": it has no poses; give rows of 12 numbers, [R|t] row by row, or of "
                             "tx ty tz qx qy qz qw.");
        motion_.log = path_;
        return std::move(motion_);
    }

  private:
    [[noreturn]] void refuse(const std::string& sentence) const {
        throw InputError(lines_.place() + ": " + sentence);
    }

    void add(const Cells& cells) {
        if (!has_header_ && motion_.told.empty() && !has_number(cells)) {
            has_header_ = true;
            has_w_first_ = names_w_first(cells);
            return;
        }
        check_count(cells.size());
        if (motion_.told.size() == static_cast<std::size_t>(most_frames))
            refuse("more than " + counted(most_frames, "pose", "poses") +
                   "; give a part of the log.");
        const Pose pose = pose_of(numbers_of(cells));
        const NearestPose nearest = rigid_pose(pose, exact_, lines_.place());
        if (nearest.correction > motion_.correction) {
            motion_.correction = nearest.correction;
            motion_.corrected_line = lines_.number();
        }
        motion_.told.push_back({static_cast<int>(motion_.told.size()), nearest.pose});
    }

    void check_count(std::size_t count) {
        if (columns_ == 0) {
            if (count != of_matrix && count != of_trajectory && count != of_trajectory + 1)
                refuse(sentence("it has ", counted(count, "column", "columns"),
                                "; give 12 numbers, [R|t] row by row, or tx ty tz qx qy qz qw, "
                                "with or without a time stamp before."));
            if (count != of_matrix && has_w_first_)
                refuse("the header names w before z; write quaternions as qx qy qz qw.");
            columns_ = count;
        }
        if (count != columns_)
            refuse(sentence("it has ", counted(count, "column", "columns"),
                            ", and the rows before have ", columns_, "; give one pose per row."));
    }

    std::vector<double> numbers_of(const Cells& cells) const {
        std::vector<double> numbers;
        for (const std::string_view cell : cells) {
            const std::optional<double> number = number_in(cell);
            if (!number || !(std::abs(*number) <= max_coordinate))
                refuse("'" + excerpt(cell) + "' is not a number within 1e70; correct the row.");
            numbers.push_back(*number);
        }
        return numbers;
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
            refuse(sentence("the squared length of the quaternion differs from 1 by ", defect, ", ",
                            exact_ ? "1e-9" : "1e-3",
                            " is allowed; give qx qy qz qw of a unit quaternion."));
        Mat3 m;
        m << x * x - y * y - z * z + w * w, 2 * (x * y - z * w), 2 * (x * z + y * w),  //
            2 * (x * y + z * w), y * y - x * x - z * z + w * w, 2 * (y * z - x * w),   //
            2 * (x * z - y * w), 2 * (y * z + x * w), z * z - x * x - y * y + w * w;
        return m / length;
    }

    std::string path_;
    TextLines lines_;
    bool exact_;
    bool has_header_ = false, has_w_first_ = false;
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
