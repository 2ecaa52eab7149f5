#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/pictures/query_view.h"
#include "render/figures/heat_figure.h"

namespace scb::app {

/// Options of pictures that color triangles by their number of tests.
struct HeatOptions {
    std::optional<HeatOf> of;  ///< no value: the picture has other colors
    std::optional<int> end;

    /// Throws InputError for an end without a heat, or below 2.
    void check() const;
    /// For heat_of.
    std::optional<std::uint32_t> scale_end() const;
    /// "heat of wasted tests".
    std::string title() const;
    /// "heat-wasted", for file names.
    std::string name() const;
};

/// --heat and --heat-end. `found`: the answer that a wasted test did not lead to.
void add_heat_options(const Command& command, HeatOptions& options, const std::string& found);

/// A picture of both bodies in the colors of their numbers of tests, without a camera.
render::SceneFigure heat_figure(const QueryView& view, const QuerySource& source,
                                const QueryTrace& frame, const HeatOptions& options);

}  // namespace scb::app
