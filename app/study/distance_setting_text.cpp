#include "app/study/distance_setting_text.h"

#include <string_view>

#include "core/base/text_format.h"
#include "scb/packed_hierarchy.h"

namespace scb::app {
namespace {

bool gives_leaf(const PackedLayout& layout) { return layout.leaf_triangles != most_leaf_triangles; }

}  // namespace

std::string setting_words(const DistanceSetting& setting, bool is_within) {
    std::string text = std::string(volume_kind_name(setting.hierarchy.volume)) + ", split " +
                       std::string(split_method_name(setting.hierarchy.split));
    if (!is_within) text += ", order " + std::string(distance_order_name(setting.order));
    if (setting.seeded) text += ", seeded";
    if (!setting.layout) return text;
    text += ", " + packed_layout_name(*setting.layout);
    if (gives_leaf(*setting.layout))
        text += format(" with leaves of %d", setting.layout->leaf_triangles);
    return text;
}

std::string distance_options(const DistanceSetting& setting) {
    const TuneSetting& hierarchy = setting.hierarchy;
    const TuneSetting usual;
    std::string text;
    const auto add = [&](bool given, const char* option, std::string_view value) {
        if (given) text += " " + std::string(option) + " " + std::string(value);
    };
    add(true, "--volume", volume_kind_name(hierarchy.volume));
    add(true, "--split", split_method_name(hierarchy.split));
    add(has_growth(hierarchy.volume) && hierarchy.growth != usual.growth, "--growth",
        ball_growth_name(hierarchy.growth));
    add(setting.order != DistanceOptions{}.order, "--order", distance_order_name(setting.order));
    if (setting.seeded) text += " --seed";
    if (!setting.layout) {
        add(hierarchy.descent != usual.descent, "--descent", descent_rule_name(hierarchy.descent));
        return text;
    }
    add(true, "--layout", packed_layout_name(*setting.layout));
    add(gives_leaf(*setting.layout), "--leaf", std::to_string(setting.layout->leaf_triangles));
    return text;
}

}  // namespace scb::app
