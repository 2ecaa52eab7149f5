#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/overlay/overlay.h"
#include "render/view/picture.h"

namespace scb::render {

/// What a setting took, as a multiple of what the base did.
struct TuneCosts {
    double n_v = 1, operations = 1;
    std::optional<double> time;  ///< nothing where nothing was timed
};

/// A setting, as a bar.
struct TuneBar {
    std::string name;  ///< such as "descent area"
    TuneCosts costs;
    bool misses_pairs = false;
    bool fewest_operations = false, least_time = false;  ///< of all settings
};

/// What settings cost in a scene, the base being 1: lines over the threshold a of the test
/// `corrected`, where there are any, and a bar for every other setting: operations, and time where
/// that was measured.
struct TuneFigure {
    std::string title, subtitle;
    std::vector<double> thresholds;         ///< ascending
    std::vector<TuneCosts> over_threshold;  ///< one for each
    std::vector<TuneBar> bars;              ///< top down, the base among them
    std::string footnote;                   ///< small, wrapped; left out where there is no room
    const Theme* theme = &light_theme;
};

/// Composes the figure; all is in the overlay. The bars lie right of the lines, or below them where
/// the picture is taller than wide.
Picture compose(const TuneFigure& figure, int width, int height, Overlay& overlay);

}  // namespace scb::render
