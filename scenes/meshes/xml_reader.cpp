#include "scenes/meshes/xml_reader.h"

#include <algorithm>

#include "core/platform/tokens.h"
#include "scb/error.h"

namespace scb::scenes {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

void skip_blanks(std::string_view& text) {
    while (!text.empty() && is_blank(text[0])) text.remove_prefix(1);
}

struct Attribute {
    std::string_view name, value;
};

/// Takes the first of the attributes; nothing if it is invalid.
std::optional<Attribute> take_attribute(std::string_view& attributes) {
    skip_blanks(attributes);
    Attribute attribute;
    attribute.name = attributes.substr(0, attributes.find_first_of(" \t\r\n=\"'<>&"));
    attributes.remove_prefix(attribute.name.size());
    skip_blanks(attributes);
    if (attribute.name.empty() || !attributes.starts_with('=')) return std::nullopt;
    attributes.remove_prefix(1);
    skip_blanks(attributes);
    if (attributes.empty() || (attributes[0] != '"' && attributes[0] != '\'')) return std::nullopt;
    const std::size_t end = attributes.find(attributes[0], 1);
    if (end == attributes.npos) return std::nullopt;
    attribute.value = attributes.substr(1, end - 1);
    attributes.remove_prefix(end + 1);
    return attribute;
}

}  // namespace

XmlReader::XmlReader(std::string_view text, const std::string& name) : text_(text), name_(name) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

std::optional<XmlEvent> XmlReader::next() {
    if (is_empty_) return end_element();
    for (;;) {
        const std::string_view rest = text_.substr(at_);
        if (rest.empty()) {
            if (!open_.empty()) refuse("ends inside an element");
            return std::nullopt;
        }
        if (rest.starts_with("<!--")) {
            at_ += 4;
            take_until("-->");
        } else if (rest.starts_with("<![CDATA[")) {
            at_ += 9;
            XmlEvent event{XmlEvent::text};
            event.content = take_until("]]>");
            event.is_cdata = true;
            if (open_.empty()) refuse("has text outside of its root");
            return event;
        } else if (rest.starts_with("<?")) {
            take_until("?>");
        } else if (rest.starts_with("<!")) {
            skip_document_type();
        } else if (rest.starts_with("</")) {
            return end_element();
        } else if (rest.starts_with('<')) {
            return start_element();
        } else {
            XmlEvent event{XmlEvent::text};
            event.content = rest.substr(0, rest.find('<'));
            at_ += event.content.size();
            if (!open_.empty()) return event;
            if (!std::all_of(event.content.begin(), event.content.end(), is_blank))
                refuse("has text outside of its root");
        }
    }
}

XmlEvent XmlReader::start_element() {
    const std::size_t start = ++at_;
    const std::size_t name_end = std::min(text_.find_first_of(" \t\r\n/>", start), text_.size());
    XmlEvent event{XmlEvent::start};
    event.name = text_.substr(start, name_end - start);
    if (event.name.empty() || event.name.find_first_of("<&'\"=") != event.name.npos)
        refuse("has an element without a name");
    std::string_view rest = text_.substr(name_end);
    for (;;) {
        skip_blanks(rest);
        is_empty_ = rest.starts_with("/>");
        if (is_empty_ || rest.starts_with('>')) break;
        if (!take_attribute(rest)) refuse("has a broken attribute");
    }
    const auto end = static_cast<std::size_t>(rest.data() - text_.data());
    event.attributes = text_.substr(name_end, end - name_end);
    at_ = end + (is_empty_ ? 2 : 1);
    open_.push_back(event.name);
    return event;
}

XmlEvent XmlReader::end_element() {
    XmlEvent event{XmlEvent::end};
    if (!is_empty_) {
        at_ += 2;
        event.name = take_until(">");
        while (!event.name.empty() && is_blank(event.name.back())) event.name.remove_suffix(1);
        if (open_.empty() || open_.back() != event.name) refuse("has an end without its start");
    }
    is_empty_ = false;
    event.name = open_.back();
    open_.pop_back();
    return event;
}

std::string_view XmlReader::take_until(std::string_view end) {
    const std::size_t found = text_.find(end, at_);
    if (found == text_.npos) refuse("ends too early");
    const std::string_view taken = text_.substr(at_, found - at_);
    at_ = found + end.size();
    return taken;
}

void XmlReader::skip_document_type() {
    int depth = 0;
    for (; at_ < text_.size(); ++at_) {
        depth += text_[at_] == '<';
        depth -= text_[at_] == '>';
        if (depth > 0) continue;
        ++at_;
        return;
    }
    refuse("ends too early");
}

void XmlReader::refuse(const char* what) const {
    const auto line =
        1 + std::count(text_.begin(),
                       text_.begin() + static_cast<std::ptrdiff_t>(std::min(at_, text_.size())),
                       '\n');
    throw InputError(name_ + ": line " + std::to_string(line) + ": the XML " + what +
                     "; get the file again, or export it again.");
}

std::optional<std::string_view> xml_attribute(std::string_view attributes, std::string_view name) {
    while (const std::optional<Attribute> attribute = take_attribute(attributes))
        if (attribute->name == name) return attribute->value;
    return std::nullopt;
}

}  // namespace scb::scenes
