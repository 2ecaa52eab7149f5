#include "golden/report_words.h"

#include <array>
#include <cstdio>

namespace scb::report {
namespace {

using kainjow::mustache::data;

std::uint64_t magnitude(std::int64_t n) {
    const auto bits = static_cast<std::uint64_t>(n);
    return n < 0 ? 0 - bits : bits;
}

std::string signed_text(bool negative, std::uint64_t size) {
    return (negative ? "−" : "") + grouped(size);
}

}  // namespace

data flag(bool value) { return data(value ? data::type::bool_true : data::type::bool_false); }

std::string grouped(std::uint64_t n) {
    std::string text = std::to_string(n);
    for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
    return text;
}

std::string grouped_signed(std::int64_t n) { return signed_text(n < 0, magnitude(n)); }

std::string change_of(std::int64_t before, std::int64_t after) {
    const auto a = static_cast<std::uint64_t>(before), b = static_cast<std::uint64_t>(after);
    return after < before ? signed_text(true, a - b) : "+" + grouped(b - a);
}

std::string counted(std::uint64_t n, const char* one, const char* many) {
    return grouped(n) + " " + (n == 1 ? one : many);
}

std::string percent(double part, double whole) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", whole > 0 ? 100 * part / whole : 0);
    return text.data();
}

std::string box_numbers(const PixelBox& box) {
    if (box.empty()) return "";
    return std::to_string(box.left) + " " + std::to_string(box.top) + " " +
           std::to_string(box.right) + " " + std::to_string(box.bottom);
}

std::string box_words(const PixelBox& box) {
    if (box.empty()) return "";
    if (box.right == box.left + 1 && box.bottom == box.top + 1)
        return "at (" + std::to_string(box.left) + ", " + std::to_string(box.top) + ")";
    return "from (" + std::to_string(box.left) + ", " + std::to_string(box.top) + ") to (" +
           std::to_string(box.right - 1) + ", " + std::to_string(box.bottom - 1) + ")";
}

}  // namespace scb::report
