#include "golden/report/report_values.h"

#include "core/base/text_format.h"

namespace scb::golden::report {

using kainjow::mustache::data;

data flag(bool value) { return data(value ? data::type::bool_true : data::type::bool_false); }

std::string percent(double part, double whole) {
    return format("%.4g", whole > 0 ? 100 * part / whole : 0);
}

std::string box_numbers(const PixelBox& box) {
    if (box.empty()) return "";
    return std::to_string(box.left) + " " + std::to_string(box.top) + " " +
           std::to_string(box.right) + " " + std::to_string(box.bottom);
}

}  // namespace scb::golden::report
