#include "render/plots/ending_colors.h"

#include <algorithm>
#include <array>

namespace scb::render {
namespace {

constexpr Rgba8 grey{0xAC, 0xAC, 0xAC}, blue{0x00, 0x72, 0xB2}, sky{0x56, 0xB4, 0xE9},
    green{0x00, 0x9E, 0x73}, yellow{0xF0, 0xE4, 0x42}, vermillion{0xD5, 0x5E, 0x00},
    purple{0xCC, 0x79, 0xA7};

// Beyond the palette: far from all others, and from bodies, also as a deuteranope sees them.
constexpr Rgba8 violet{0x77, 0x33, 0xEE}, olive{0x5F, 0x5F, 0x00};

/// Of the stages of another engine, in their order; the last one is that of all others.
constexpr std::size_t most_foreign = 9;
constexpr std::array<Rgba8, most_foreign + 1> foreign_colors = {blue,
                                                                sky,
                                                                green,
                                                                yellow,
                                                                violet,
                                                                olive,
                                                                Rgba8{0x00, 0x2B, 0x5C},
                                                                Rgba8{0x8C, 0x51, 0x0A},
                                                                Rgba8{0x80, 0xCD, 0xC1},
                                                                grey};

struct Look {
    std::string_view label;
    Rgba8 color;
};

Look look_of(Outcome ending, const Theme& theme) {
    switch (ending) {
        case Outcome::triangles_apart:
            return {"triangles apart", purple};
        case Outcome::triangles_meet:
            return {"triangles meet", vermillion};
        case Outcome::found:
            return {"overlap", vermillion};
        case Outcome::neighbors:
            return {"triangles share a vertex", Rgba8{0xD9, 0xB3, 0x82}};
        case Outcome::left_over:
            return {"left over", theme.left_over};
        case Outcome::divided_a:
        case Outcome::divided_b:
        case Outcome::divided_both:
            break;
    }
    const auto stage = static_cast<Stage>(ending);
    if (is_foreign(stage)) {
        const unsigned number = foreign_number(stage);
        return {number <= most_foreign ? "" : "other stages",
                foreign_colors[std::min<std::size_t>(number, most_foreign + 1) - 1]};
    }
    switch (stage) {
        case Stage::overlapping:
            break;
        case Stage::ball_ball:
            return {"ball A, ball B", grey};
        case Stage::slab_ball:
            return {"slab A, ball B", blue};
        case Stage::ball_slab:
            return {"ball A, slab B", sky};
        case Stage::slab_cylinder:
            return {"slab A, cylinder B", green};
        case Stage::cylinder_slab:
            return {"cylinder A, slab B", yellow};
        case Stage::slab_a:
            return {"normal of A", blue};
        case Stage::second_slab_a:
            return {"second normal of A", violet};
        case Stage::second_slab_b:
            return {"second normal of B", olive};
        case Stage::long_axes:
            return {"long axes", yellow};
        case Stage::slab_b:
            return {"normal of B", sky};
        case Stage::center_line:
            return {"line of centers", green};
        case Stage::search:
            return {"by search", sky};
        case Stage::axis_a0:
        case Stage::axis_a1:
        case Stage::axis_a2:
            return {"faces of A", blue};
        case Stage::axis_b0:
        case Stage::axis_b1:
        case Stage::axis_b2:
            return {"faces of B", sky};
        case Stage::axis_a0_b0:
        case Stage::axis_a0_b1:
        case Stage::axis_a0_b2:
        case Stage::axis_a1_b0:
        case Stage::axis_a1_b1:
        case Stage::axis_a1_b2:
        case Stage::axis_a2_b0:
        case Stage::axis_a2_b1:
        case Stage::axis_a2_b2:
            return {"edges A × B", green};
    }
    return {"", grey};
}

}  // namespace

std::vector<EndingGroup> ending_groups(const std::vector<Outcome>& endings, const Theme& theme) {
    std::vector<EndingGroup> groups;
    for (const Outcome ending : endings) {
        const Look look = look_of(ending, theme);
        if (groups.empty() || groups.back().label != look.label)
            groups.push_back({std::string(look.label), look.color, {}});
        groups.back().endings.push_back(ending);
    }
    return groups;
}

std::vector<EndingGroup> ending_groups(const TraceHeader& header, const Theme& theme) {
    const std::vector<Outcome> endings = endings_of(header);
    if (!header.engine) return ending_groups(endings, theme);
    std::vector<EndingGroup> groups;
    for (const Outcome ending : endings) {
        const Look look = look_of(ending, theme);
        const std::string label =
            look.label.empty() ? ending_words(header, ending) : std::string(look.label);
        auto known = std::find_if(groups.begin(), groups.end(), [&label](const EndingGroup& group) {
            return group.label == label;
        });
        if (known == groups.end())
            known = groups.insert(groups.end(), EndingGroup{label, look.color, {}});
        known->endings.push_back(ending);
    }
    return groups;
}

Rgba8 ending_color(Outcome ending, const Theme& theme) { return look_of(ending, theme).color; }

std::uint64_t count_of(const EndingGroup& group, const EndingCounts& counts) {
    std::uint64_t sum = 0;
    for (const Outcome ending : group.endings) sum += counts[static_cast<std::size_t>(ending)];
    return sum;
}

}  // namespace scb::render
