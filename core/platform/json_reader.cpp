#include "core/platform/json_reader.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/base/text_format.h"
#include "core/platform/file_bytes.h"
#include "scb/error.h"

namespace scb {
namespace {

using nlohmann::json;

std::string line_and_column(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t start =
        before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    return "line " + std::to_string(line) + ", column " +
           std::to_string(std::max<std::size_t>(1, before.size() - start));
}

/// The library's reason without its own number and position, on one line of plain characters.
std::string plain_reason(const char* what) {
    std::string_view reason = what;
    for (const std::string_view lead : {"] ", "column ", ": "})
        if (const std::size_t at = reason.find(lead); at != std::string_view::npos)
            reason.remove_prefix(at + lead.size());
    std::string plain(reason.substr(0, 200));
    for (char& c : plain)
        if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
    return plain;
}

/// The value as in the file, cut if it is long.
std::string shown(const json& value) {
    if (value.is_object()) return "an object";
    std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
    if (text.size() > 60) text = text.substr(0, 57) + "...";
    return text;
}

/// An iterator over characters that knows how far it has read.
class Cursor {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    Cursor(const char* at, std::size_t& read) : at_(at), read_(&read) {}
    reference operator*() const { return *at_; }
    Cursor& operator++() {
        ++at_;
        ++*read_;
        return *this;
    }
    bool operator==(const Cursor& other) const { return at_ == other.at_; }

  private:
    const char* at_;
    std::size_t* read_;
};

/// Refuses texts that are not JSON, values that are nested too deeply, and fields that occur twice
/// in one object. A pass of its own, since json::parse with a callback takes quadratic time, and
/// does not report the place of a number that is too large.
class StrictReader : public nlohmann::json_sax<json> {
  public:
    StrictReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    void read() {
        json::sax_parse(Cursor(text_.data(), read_), Cursor(text_.data() + text_.size(), read_),
                        this);
    }

    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool start_object(std::size_t) override { return open(); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(); }
    bool end_array() override { return close(); }
    bool key(string_t& name) override {
        if (fields_.back().insert(name).second) return true;
        refuse("the field " + shown(json(name)) + " stands twice in one object; keep one of them.");
    }
    bool parse_error(std::size_t position, const std::string&,
                     const json::exception& error) override {
        read_ = position;
        refuse("not valid JSON: " + plain_reason(error.what()) + "; correct it there.");
    }

  private:
    bool open() {
        // Printing a value needs stack for every level.
        if (fields_.size() >= max_json_depth)
            refuse("values are nested more than " + std::to_string(max_json_depth) +
                   " deep; no file here needs that.");
        fields_.emplace_back();
        return true;
    }
    bool close() {
        fields_.pop_back();
        return true;
    }

    [[noreturn]] void refuse(const std::string& sentence) const {
        throw InputError(file_ + ": " + line_and_column(text_, read_) + ": " + sentence);
    }

    std::string_view text_;
    const std::string& file_;
    std::size_t read_ = 0;
    std::vector<std::set<std::string>> fields_;  ///< of the open objects and arrays
};

template <class Json>
Json parsed(std::string_view text, const std::string& file) {
    // The parser would treat a zero byte as the end.
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
        throw InputError(file + ": " + line_and_column(text, zero + 1) +
                         ": not valid JSON: a zero byte; correct it there.");
    StrictReader(text, file).read();
    return Json::parse(text.begin(), text.end());
}

}  // namespace

json parse_json(std::string_view text, const std::string& file) { return parsed<json>(text, file); }

nlohmann::ordered_json parse_ordered_json(std::string_view text, const std::string& file) {
    return parsed<nlohmann::ordered_json>(text, file);
}

std::string read_text_file(const std::string& file, std::size_t largest) {
    std::string text = file_bytes(file, largest + 1);
    if (text.size() > largest)
        throw InputError(file + ": longer than " + std::to_string(largest >> 20) +
                         " MiB, which no such file is; check the path.");
    return text;
}

void refuse(const JsonPlace& place, const std::string& sentence) {
    throw InputError(place.file + ": " + (place.path.empty() ? "" : place.path + ": ") + sentence);
}

void refuse_value(const JsonPlace& place, const std::string& expected) {
    refuse(place, "expected " + expected + ", found " + shown(*place) + ".");
}

void check_fields(const JsonPlace& place, std::initializer_list<std::string_view> known) {
    if (!place.value->is_object()) refuse_value(place, "an object");
    for (const auto& entry : place.value->items())
        if (std::find(known.begin(), known.end(), entry.key()) == known.end())
            refuse(place, "unknown field " + shown(json(entry.key())) + "; known are " +
                              name_list(known) + ".");
}

bool has(const JsonPlace& object, const char* name) { return object.value->contains(name); }

JsonPlace field(const JsonPlace& object, const char* name) {
    if (!has(object, name))
        refuse(object, std::string("the field \"") + name + "\" is missing; add it.");
    return {&(*object).at(name), object.file,
            object.path + (object.path.empty() ? "" : ".") + name};
}

JsonPlace element(const JsonPlace& array, std::size_t index) {
    return {&(*array).at(index), array.file, array.path + "[" + std::to_string(index) + "]"};
}

std::size_t array_size(const JsonPlace& place, const char* expected) {
    if (!place.value->is_array()) refuse_value(place, expected);
    return place.value->size();
}

double read_number(const JsonPlace& place, double low, double high) {
    if (!place.value->is_number()) refuse_value(place, "a number");
    const double number = place.value->get<double>();
    if (!(number >= low && number <= high))
        refuse_value(place, "a number from " + exact_number(low) + " to " + exact_number(high));
    return number;
}

std::int64_t read_integer(const JsonPlace& place, std::int64_t low, std::int64_t high) {
    const nlohmann::json& value = *place;
    std::optional<std::int64_t> number;
    if (value.is_number_unsigned()) {
        if (std::in_range<std::int64_t>(value.get<std::uint64_t>()))
            number = value.get<std::int64_t>();
    } else if (value.is_number_integer()) {
        number = value.get<std::int64_t>();
    } else if (value.is_number_float()) {
        // A number such as 1e3 is an integer too, although JSON libraries store it as a double. All
        // doubles below 2^63 are in range, and 2^63 itself is the first that is not.
        const double real = value.get<double>();
        if (real >= -0x1p63 && real < 0x1p63 && real == std::floor(real))
            number = static_cast<std::int64_t>(real);
    }
    if (!number || *number < low || *number > high)
        refuse_value(place,
                     "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    return *number;
}

double read_positive(const JsonPlace& place) {
    const double number = read_number(place);
    if (!(number > 0)) refuse_value(place, "a number above 0");
    return number;
}

bool read_bool(const JsonPlace& place) {
    if (!place.value->is_boolean()) refuse_value(place, "true or false");
    return place.value->get<bool>();
}

std::string read_text(const JsonPlace& place) {
    if (!place.value->is_string()) refuse_value(place, "a text in quotes");
    return place.value->get<std::string>();
}

std::string read_plain_text(const JsonPlace& place) {
    const std::string text = read_text(place);
    const auto is_control = [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) == 0x7f;
    };
    if (text.empty() || std::any_of(text.begin(), text.end(), is_control))
        refuse_value(place, "a text that is not empty and has no control characters");
    return text;
}

Vec3 read_vec3(const JsonPlace& place) {
    if (!place.value->is_array() || place.value->size() != 3) refuse_value(place, "three numbers");
    Vec3 v;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!(*place)[i].is_number()) refuse_value(place, "three numbers");
        v[static_cast<Eigen::Index>(i)] = read_number(element(place, i));
    }
    return v;
}

Vec3 read_direction(const JsonPlace& place) {
    const Vec3 v = read_vec3(place);
    if (v[0] == 0 && v[1] == 0 && v[2] == 0)
        refuse_value(place, "three numbers that are not all zero");
    return v;
}

}  // namespace scb
