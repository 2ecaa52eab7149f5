#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/overlay/overlay.h"
#include "render/view/picture.h"

namespace scb::render {

/// A setting, as a bar: what it took, as a multiple of what the base did.
struct TuneBar {
    std::string name;  ///< such as "scb2, split cost, descent area"
    double n_v = 1, operations = 1;
    struct Times {
        double least = 1, median = 1, most = 1;
    };
    std::optional<Times> time;  ///< nothing where it was not timed
    bool misses_pairs = false;
    bool fewest_tests = false, fewest_operations = false, least_time = false;  ///< of all settings
};

/// What settings cost in a scene, the base being 1: volume tests, and beside them the time of those
/// that were timed, or where there is none the operations of the tests.
struct TuneFigure {
    std::string title, subtitle;
    std::vector<TuneBar> bars;  ///< top down, the base among them
    std::string footnote;       ///< small, wrapped; left out where there is no room
    const Theme* theme = &light_theme;
};

/// Composes the figure; all is in the overlay. Time lies right of the tests, or below them where
/// the picture is taller than wide.
Picture compose(const TuneFigure& figure, int width, int height, Overlay& overlay);

}  // namespace scb::render
