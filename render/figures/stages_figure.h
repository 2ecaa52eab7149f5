#pragma once

#include <string>
#include <vector>

#include "render/overlay/overlay.h"
#include "render/plots/ending_colors.h"
#include "render/view/picture.h"

namespace scb::render {

/// How the paths of a traversal ended, frame by frame, as one stacked bar for each frame. It shows
/// which stages of the overlap test justify their operations (Table 1 of the paper).
struct StagesFigure {
    std::string title;
    std::string subtitle;
    std::vector<EndingGroup> groups;   ///< from the bottom of a bar to its top
    std::vector<int> frames;           ///< ascending
    std::vector<EndingCounts> counts;  ///< one for each frame
    double least_top = 0;  ///< the least upper end of the axis: equal for figures to compare
    const Theme* theme = &light_theme;
};

/// The paths of the frame with the most paths, the end of the axis without least_top.
double most_paths(const StagesFigure& figure);

/// Composes the picture: the bars, and their means per frame in a panel. If there are more frames
/// than pixels, a bar is the mean of the frames at its place.
Picture compose(const StagesFigure& figure, int width, int height, Overlay& overlay);

}  // namespace scb::render
