#pragma once

#include <string>
#include <vector>

namespace scb::app {

/// A part of the text below the options of a help: a paragraph, or a block of indented lines.
struct FooterPart {
    enum class Section { description, examples, statuses };

    Section section = Section::description;
    bool is_literal = false;           ///< lines that stand as they are
    std::vector<std::string> lines{};  ///< without indentation, and without "Exit status: "
};

/// The parts of a footer. A paragraph that begins with "Example" heads the examples and is left
/// out. One that begins with "Exit status: " has the exit statuses.
std::vector<FooterPart> footer_parts(const std::string& footer);

/// The parts of one section.
std::vector<FooterPart> footer_parts(const std::string& footer, FooterPart::Section section);

}  // namespace scb::app
