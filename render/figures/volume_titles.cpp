#include "render/figures/volume_titles.h"

#include <array>

#include "scb/any_hierarchy.h"

namespace scb::render {

std::string_view volume_title(VolumeKind kind) {
    // In the order of the enumeration.
    constexpr std::array<std::string_view, 4> titles = {"SCB", "ball", "ball (Ritter)", "OBB"};
    return titles[static_cast<std::size_t>(kind)];
}

}  // namespace scb::render
