#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "render/figures/frame_sheet.h"

namespace scb::app {

/// The contact sheet of the pictures of a run, which grows picture by picture. Of these, only small
/// views are kept.
struct SheetRun {
    std::string name;        ///< of the file, without its extension
    render::PixelRect view;  ///< what of a picture its cell shows
    bool one_frame = false;  ///< so captions need not name it
    render::FrameSheet sheet;
    std::string scale_end;  ///< of the picture that comes next; empty where it has no scale

    /// Takes title and legend over from those of the picture that comes next.
    void explain(const std::string& title, const std::vector<render::PanelItem>& panel);
    /// What explain() was told once, and tells it again elsewhere.
    nlohmann::ordered_json explanation() const;
    void explain(const nlohmann::ordered_json& explanation);
    /// The part of a picture that a cell shows, in the cell's size.
    render::Image shrunk(const render::Image& picture) const;
    /// Adds a cell with this view, with what the index says of the picture as its caption: the
    /// counts of its query, or of both.
    void add(render::Image view_of_cell, const nlohmann::ordered_json& entry);
};

}  // namespace scb::app
