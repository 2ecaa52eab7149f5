#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scb::scenes {

/// A part of an XML document.
struct XmlEvent {
    enum Kind { start, end, text };
    Kind kind = start;
    std::string_view name{};        ///< of the element that starts or ends
    std::string_view attributes{};  ///< of the element that starts, as written
    std::string_view content{};     ///< the text
    bool is_cdata = false;          ///< its content is literal
};

/// The parts of an XML document in UTF-8, one after the other; an empty element starts and ends.
/// Comments, processing instructions and the document type are skipped, and nothing is decoded.
class XmlReader {
  public:
    /// Both must outlive this. `name` begins messages.
    XmlReader(std::string_view text, const std::string& name);

    /// Nothing at the end of the document. Throws InputError if it is not well-formed.
    std::optional<XmlEvent> next();

  private:
    XmlEvent start_element();
    XmlEvent end_element();
    /// Skips text up to these characters; returns it.
    std::string_view take_until(std::string_view end);
    void skip_document_type();
    [[noreturn]] void refuse(const char* what) const;

    std::string_view text_;
    const std::string& name_;
    std::size_t at_ = 0;
    std::vector<std::string_view> open_;
    bool is_empty_ = false;  ///< the element that started last ends at once
};

/// The value of an attribute as written; nothing if it is missing.
std::optional<std::string_view> xml_attribute(std::string_view attributes, std::string_view name);

}  // namespace scb::scenes
