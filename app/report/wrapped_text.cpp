#include "app/report/wrapped_text.h"

#include "core/base/text_format.h"
#include "core/platform/number_list.h"

namespace scb::app {

std::string wrapped_text(const std::string& text, std::size_t indent) {
    const std::vector<std::string> words = split_list(text, ' ');
    std::string lines, line = words.front();
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string longer = line + " " + words[i];
        const bool fits = character_count(longer) <= report_width;
        if (!fits) lines += line + "\n";
        line = fits ? longer : std::string(indent, ' ') + words[i];
    }
    return lines + line;
}

}  // namespace scb::app
