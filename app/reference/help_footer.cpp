#include "app/reference/help_footer.h"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace scb::app {

std::vector<FooterPart> footer_parts(const std::string& footer) {
    constexpr std::string_view status = "Exit status: ";
    std::vector<FooterPart> parts;
    auto section = FooterPart::Section::description;
    bool begins = true;  // a paragraph
    std::istringstream lines(footer);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty()) {
            begins = true;
            continue;
        }
        const bool is_literal = line.starts_with("  ");
        const bool begins_paragraph = begins && !is_literal;
        begins = false;
        if (begins_paragraph) {
            section = line.starts_with("Example") ? FooterPart::Section::examples
                      : line.starts_with(status)  ? FooterPart::Section::statuses
                                                  : FooterPart::Section::description;
            if (section == FooterPart::Section::examples) continue;
            if (section == FooterPart::Section::statuses) line.erase(0, status.size());
        }
        if (begins_paragraph || parts.empty() || parts.back().section != section ||
            parts.back().is_literal != is_literal)
            parts.push_back({section, is_literal});
        parts.back().lines.push_back(is_literal ? line.substr(2) : line);
    }
    return parts;
}

std::vector<FooterPart> footer_parts(const std::string& footer, FooterPart::Section section) {
    const std::vector<FooterPart> all = footer_parts(footer);
    std::vector<FooterPart> parts;
    std::copy_if(all.begin(), all.end(), std::back_inserter(parts),
                 [&](const FooterPart& part) { return part.section == section; });
    return parts;
}

}  // namespace scb::app
