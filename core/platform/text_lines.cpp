#include "core/platform/text_lines.h"

#include "scb/error.h"

namespace scb {
namespace {

constexpr std::size_t longest_line = std::size_t{64} << 10;

}  // namespace

TextLines::TextLines(const std::string& path) : file_(path) {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    if (file_.ahead(mark.size()).starts_with(mark)) file_.skip(mark.size());
}

std::optional<std::string_view> TextLines::next() {
    file_.skip(taken_);
    std::string_view line = file_.ahead(longest_line + 1).substr(0, longest_line + 1);
    taken_ = 0;
    if (line.empty()) return std::nullopt;
    ++number_;
    const std::size_t end = line.find('\n');
    if (end == line.npos && line.size() > longest_line)
        throw InputError(place() + ": it has more than 64 KiB; give a text file.");
    line = line.substr(0, end);
    taken_ = line.size() + (end == line.npos ? 0 : 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

std::string TextLines::place() const { return file_.name() + ": line " + std::to_string(number_); }

}  // namespace scb
