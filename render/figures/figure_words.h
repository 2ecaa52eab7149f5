#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/trace.h"
#include "core/model/tree.h"
#include "render/overlay/side_panel.h"
#include "scb/mesh.h"

namespace scb::render {

/// The names of one or two bodies in the columns of a panel: their own names if these are short,
/// else A and B, and then a note is added with the full names: "A spider, B
/// ultimaker_robot_support". `has_letters`: the panel uses A and B elsewhere, so the names are
/// always A and B.
std::vector<std::string> column_names(std::vector<PanelItem>& items,
                                      const std::vector<std::string>& names,
                                      bool has_letters = false);

/// The kind and number of a body's items: its triangles or, if it has none, objects.
struct ItemCount {
    std::string_view what;
    std::size_t count = 0;
};
ItemCount item_count(const Mesh& mesh, const Tree& tree);

/// "triangles", "objects", or "items" for both.
std::string_view item_words(const std::vector<ItemCount>& counts);

/// The name of a kind of volume in titles, tables and legends: "SCB", "ball", "ball (Ritter)",
/// "OBB", "SCB2". (For file names and options see volume_kind_name.)
std::string_view volume_title(VolumeKind kind);

/// The name of the volumes of a trace's queries; for another engine, with its name: "FCL 0.7, OBB".
std::string volume_title(const TraceHeader& header);

}  // namespace scb::render
