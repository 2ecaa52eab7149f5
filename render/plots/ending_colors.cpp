#include "render/plots/ending_colors.h"

#include <algorithm>

namespace scb::render {
namespace {

Rgba8 color_of(Hue hue, const Theme& theme) {
    switch (hue) {
        case Hue::grey:
            return {0xAC, 0xAC, 0xAC};
        case Hue::blue:
            return {0x00, 0x72, 0xB2};
        case Hue::sky:
            return {0x56, 0xB4, 0xE9};
        case Hue::green:
            return {0x00, 0x9E, 0x73};
        case Hue::yellow:
            return {0xF0, 0xE4, 0x42};
        case Hue::vermillion:
            return {0xD5, 0x5E, 0x00};
        case Hue::purple:
            return {0xCC, 0x79, 0xA7};
        case Hue::left_over:
            return theme.left_over;
        // Beyond the palette: far from all others, and from bodies, also as a deuteranope sees
        // them.
        case Hue::violet:
            return {0x77, 0x33, 0xEE};
        case Hue::olive:
            return {0x5F, 0x5F, 0x00};
        case Hue::navy:
            return {0x00, 0x2B, 0x5C};
        case Hue::brown:
            return {0x8C, 0x51, 0x0A};
        case Hue::mint:
            return {0x80, 0xCD, 0xC1};
        case Hue::tan:
            return {0xD9, 0xB3, 0x82};
    }
    return {};
}

}  // namespace

std::vector<EndingGroup> ending_groups(const std::vector<Stage>& endings, const Theme& theme,
                                       const StageTable& stages) {
    std::vector<EndingGroup> groups;
    for (const Stage ending : endings) {
        const StageRow row = stages.row(ending);
        auto known = std::find_if(groups.begin(), groups.end(), [&row](const EndingGroup& group) {
            return group.label == row.group;
        });
        if (known == groups.end())
            known = groups.insert(
                groups.end(), EndingGroup{std::string(row.group), ending_color(ending, theme), {}});
        known->endings.push_back(ending);
    }
    return groups;
}

std::vector<EndingGroup> ending_groups(const TraceHeader& header, const Theme& theme) {
    return ending_groups(endings_of(header), theme, header.stages);
}

Rgba8 ending_color(Stage ending, const Theme& theme) { return color_of(hue_of(ending), theme); }

std::uint64_t count_of(const EndingGroup& group, const EndingCounts& counts) {
    std::uint64_t sum = 0;
    for (const Stage ending : group.endings) sum += counts[static_cast<std::size_t>(ending)];
    return sum;
}

}  // namespace scb::render
