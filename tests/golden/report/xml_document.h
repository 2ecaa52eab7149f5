#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace scb::golden {

/// An element of an XML document: everything in it but comments.
struct XmlElement {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::string text;  ///< its own text, without its children's text
    std::vector<XmlElement> children;

    /// The children of that name.
    std::vector<XmlElement> all(std::string_view wanted) const {
        std::vector<XmlElement> found;
        for (const XmlElement& child : children)
            if (child.name == wanted) found.push_back(child);
        return found;
    }
};

/// The outermost element of a document. Throws std::runtime_error with line and reason where it is
/// not well-formed.
XmlElement parse_xml(const std::string& document);

}  // namespace scb::golden
