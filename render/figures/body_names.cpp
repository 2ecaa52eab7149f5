#include "render/figures/body_names.h"

#include <algorithm>
#include <string_view>

namespace scb::render {

std::vector<std::string> column_names(std::vector<PanelItem>& items,
                                      const std::vector<std::string>& names, bool has_letters) {
    // So many characters fit beside another body's name.
    constexpr std::size_t most = 7;
    constexpr std::string_view letters = "AB";
    const bool are_short = std::all_of(names.begin(), names.end(),
                                       [](const std::string& name) { return name.size() <= most; });
    const bool are_letters = names == std::vector<std::string>{"A", "B"};
    if (names.size() > letters.size() || are_letters || (are_short && !has_letters)) return names;
    std::vector<std::string> columns;
    std::string note;
    for (std::size_t b = 0; b < names.size(); ++b) {
        columns.emplace_back(1, letters[b]);
        note += (b == 0 ? "" : ", ") + columns.back() + " " + names[b];
    }
    items.emplace_back(PanelNote{note});
    return columns;
}

}  // namespace scb::render
