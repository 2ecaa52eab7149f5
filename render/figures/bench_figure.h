#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render/overlay/overlay.h"
#include "render/plots/plot_frame.h"
#include "render/view/picture.h"
#include "scb/any_hierarchy.h"

namespace scb::render {

/// What one kind of hierarchy did in each frame of a scene.
struct BenchSeries {
    std::string name;  ///< in the legend, such as "ball (Ritter)"
    VolumeKind kind = VolumeKind::scb;
    std::vector<int> frames;  ///< ascending
    std::vector<double> n_v;  ///< volume pair tests, one for each frame, NaN where unknown
    std::vector<double> n_p;  ///< triangle pair tests, the same
    std::vector<double> ms;   ///< time in milliseconds, the same; empty where nothing was timed
    std::vector<double> pairs = {};  ///< of triangles that collide, the same
};

/// Figure 11 of the paper for one scene: N_v (left) and time (right) per frame, one line for each
/// hierarchy, and a legend with their means below (see bench_legend). Of fewer than 4 frames it has
/// bars of the means instead of lines.
struct BenchFigure {
    std::string scene;
    std::vector<std::uint64_t> triangles;  ///< of each body
    std::vector<BenchSeries> series;       ///< rows of the legend, top down
    /// Frames to shade, such as those of parallel close proximity. The legend compares the times
    /// within the first range, too.
    std::vector<PlotRange> ranges;
    std::string footnote;  ///< such as how the program was compiled; small, wrapped
    const Theme* theme = &light_theme;
};

/// From this many frames on there are lines.
inline constexpr std::size_t least_frames_of_lines = 4;

/// Which frames the series have, ascending.
std::vector<int> frames_of(const BenchFigure& figure);

/// Which frames the figure is about: "frames 0 to 499" where they are all of these, "25 frames, 0
/// to 480" where not, "frames 0, 20 and 40" or "frame 7" where they are few.
std::string frames_text(const std::vector<int>& frames);

/// How many times as long `other` took as `scb` did, over the frames (from `from` to `to`) that
/// both were timed in; nothing where there are none, or `scb` took no time.
std::optional<double> time_over_scb(const BenchSeries& scb, const BenchSeries& other, double from,
                                    double to);

/// Composes the figure: the picture has no panes, all is in the overlay. The plots lie above each
/// other where the picture is taller than wide. Where a picture is too small for everything, the
/// legend's text is set smaller, then the footnote goes, then the legend, and names are in the
/// plots.
Picture compose(const BenchFigure& figure, int width, int height, Overlay& overlay);

}  // namespace scb::render
