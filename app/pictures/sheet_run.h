#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "render/figures/frame_sheet.h"

namespace scb::app {

/// The contact sheet of a run's pictures, built picture by picture. It keeps only small views.
struct SheetRun {
    std::string name;        ///< of the file, without its extension
    render::PixelRect view;  ///< the part of a picture that its cell shows
    bool one_frame = false;  ///< so captions need not name it
    render::FrameSheet sheet;
    std::string scale_end;  ///< of the next picture; empty if it has no scale

    /// Takes over the title and legend of the next picture.
    void explain(const std::string& title, const std::vector<render::PanelItem>& panel);
    /// The latest arguments of explain(), for explain() in another process.
    nlohmann::ordered_json explanation() const;
    void explain(const nlohmann::ordered_json& explanation);
    /// The part of a picture that a cell shows, in the cell's size.
    render::Image shrunk(const render::Image& picture) const;
    /// Adds a cell with this view. The caption comes from the picture's entry in the index: the
    /// counts of its query, or of both queries.
    void add(render::Image view_of_cell, const nlohmann::ordered_json& entry);
};

}  // namespace scb::app
