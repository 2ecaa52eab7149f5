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

/// The counts and times of one kind of hierarchy in each frame of a scene.
struct BenchSeries {
    std::string name;  ///< in the legend, such as "ball (Ritter)"
    VolumeKind kind = VolumeKind::scb;
    std::vector<int> frames;         ///< ascending
    std::vector<double> n_v;         ///< volume pair tests, one for each frame, NaN where unknown
    std::vector<double> n_p;         ///< triangle pair tests, the same
    std::vector<double> ms;          ///< time in milliseconds, the same; empty if nothing was timed
    std::vector<double> pairs = {};  ///< pairs of triangles that collide, the same
};

/// Figure 11 of the paper for one scene: N_v (left) and time (right) per frame, one line for each
/// hierarchy, and a legend with their means below (see bench_legend). With fewer than 4 frames it
/// has bars of the means instead of lines.
struct BenchFigure {
    std::string scene;
    std::vector<std::uint64_t> triangles;  ///< of each body
    std::vector<BenchSeries> series;       ///< rows of the legend, top down
    /// Frames to shade, such as frames of parallel close proximity. The legend compares the times
    /// within the first range, too.
    std::vector<PlotRange> ranges;
    std::string footnote;  ///< such as how the program was compiled; small, wrapped
    const Theme* theme = &light_theme;
};

/// The least number of frames for lines.
inline constexpr std::size_t least_frames_of_lines = 4;

/// The frames of the series, ascending.
std::vector<int> frames_of(const BenchFigure& figure);

/// The frames in words: "frames 0 to 499" if there are no gaps, else "25 frames, 0 to 480", or
/// "frames 0, 20 and 40" or "frame 7" if they are few.
std::string frames_text(const std::vector<int>& frames);

/// The ratio of the time of `other` to the time of `scb`, over the frames (from `from` to `to`) in
/// which both were timed; nothing if there are none, or if `scb` took no time.
std::optional<double> time_over_scb(const BenchSeries& scb, const BenchSeries& other, double from,
                                    double to);

/// Composes the figure: the picture has no panes, all is in the overlay. The plots lie above each
/// other if the picture is taller than wide. If a picture is too small for everything, the legend's
/// text gets smaller, then the footnote is left out, then the legend, and names are in the plots.
Picture compose(const BenchFigure& figure, int width, int height, Overlay& overlay);

}  // namespace scb::render
