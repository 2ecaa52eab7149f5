#include "tests/golden/report/xml_document.h"

#include <expat.h>

#include <memory>
#include <stdexcept>

namespace scb::golden {
namespace {

using Open = std::vector<XmlElement>;

void start(void* data, const XML_Char* name, const XML_Char** attributes) {
    XmlElement element{name, {}, {}, {}};
    for (; *attributes; attributes += 2) element.attributes[attributes[0]] = attributes[1];
    static_cast<Open*>(data)->push_back(std::move(element));
}

void end(void* data, const XML_Char*) {
    Open& open = *static_cast<Open*>(data);
    XmlElement closed = std::move(open.back());
    open.pop_back();
    open.back().children.push_back(std::move(closed));
}

void text(void* data, const XML_Char* characters, int size) {
    static_cast<Open*>(data)->back().text.append(characters, static_cast<std::size_t>(size));
}

}  // namespace

XmlElement parse_xml(const std::string& document) {
    const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr),
                                                                         XML_ParserFree);
    Open open(1);
    XML_SetUserData(parser.get(), &open);
    XML_SetElementHandler(parser.get(), start, end);
    XML_SetCharacterDataHandler(parser.get(), text);
    if (XML_Parse(parser.get(), document.data(), static_cast<int>(document.size()), 1) !=
        XML_STATUS_OK)
        throw std::runtime_error("line " + std::to_string(XML_GetCurrentLineNumber(parser.get())) +
                                 ": " + XML_ErrorString(XML_GetErrorCode(parser.get())));
    return open.back().children.at(0);
}

}  // namespace scb::golden
