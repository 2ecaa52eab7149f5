#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/any_hierarchy.h"
#include "render/overlay.h"
#include "render/picture.h"
#include "render/plot_frame.h"

namespace scb {

/// What one kind of hierarchy did in each frame of a scene.
struct BenchSeries {
    std::string name;  ///< in the table, such as "ball, minimum"
    VolumeKind kind = VolumeKind::scb;
    std::vector<int> frames;  ///< ascending
    std::vector<double> n_v;  ///< volume pair tests, one for each frame, NaN where unknown
    std::vector<double> n_p;  ///< triangle pair tests, the same
    std::vector<double> ms;   ///< time in milliseconds, the same; empty where nothing was timed
};

/// Figure 11 of the paper for one scene: N_v (left) and time (right) per frame, one line for each
/// hierarchy, and a table of their means below.
struct BenchFigure {
    std::string scene;
    std::vector<std::uint64_t> triangles;  ///< of each body
    std::vector<BenchSeries> series;       ///< rows of the table, top down
    /// Frames to shade, such as those of parallel close proximity. The table has the speed-ups
    /// within the first range, too.
    std::vector<PlotRange> ranges;
    std::string footnote;  ///< such as how the program was compiled; wrapped
    const Theme* theme = &light_theme;
};

/// The mean of the values that are numbers, or nothing where there are none.
std::optional<double> mean_of(const std::vector<double>& values);

/// How many times as long `other` took as `scb` did, over the frames (from `from` to `to`) that
/// both were timed in; nothing where there are none, or `scb` took no time.
std::optional<double> speed_up(const BenchSeries& scb, const BenchSeries& other, double from,
                               double to);

/// Composes the figure: the picture has no panes, all is in the overlay. The plots lie above each
/// other where the picture is taller than wide. Where a picture is too small for everything, the
/// footnote goes first, then the table.
Picture compose(const BenchFigure& figure, int width, int height, Overlay& overlay);

}  // namespace scb
