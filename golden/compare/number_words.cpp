#include "golden/compare/number_words.h"

#include "core/base/text_format.h"

namespace scb::golden::words {
namespace {

std::uint64_t magnitude(std::int64_t n) {
    const auto bits = static_cast<std::uint64_t>(n);
    return n < 0 ? 0 - bits : bits;
}

std::string place(int x, int y) { return "(" + std::to_string(x) + ", " + std::to_string(y) + ")"; }

}  // namespace

std::string grouped_signed(std::int64_t n, const char* minus) {
    return (n < 0 ? minus : "") + count_text(magnitude(n));
}

std::string change_of(std::int64_t before, std::int64_t after, const char* minus) {
    const auto a = static_cast<std::uint64_t>(before), b = static_cast<std::uint64_t>(after);
    return after < before ? minus + count_text(a - b) : "+" + count_text(b - a);
}

std::string box_words(const PixelBox& box) {
    if (box.empty()) return "";
    if (box.right == box.left + 1 && box.bottom == box.top + 1)
        return "at " + place(box.left, box.top);
    return "from " + place(box.left, box.top) + " to " + place(box.right - 1, box.bottom - 1);
}

}  // namespace scb::golden::words
