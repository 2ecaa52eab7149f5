#include "golden/compare/counts_difference.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <utility>

#include "core/distance/distance_certificate.h"

namespace scb::golden {
namespace {

using nlohmann::json;

bool is_container(const json& value) { return value.is_object() || value.is_array(); }

/// An object or a list with entries.
bool is_branch(const json& value) { return is_container(value) && !value.empty(); }

std::optional<std::int64_t> integer_in(const json& leaf) {
    if (leaf.is_number_unsigned()) {
        const auto value = leaf.get<std::uint64_t>();
        if (value > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
            return std::nullopt;
        return static_cast<std::int64_t>(value);
    }
    if (leaf.is_number_integer()) return leaf.get<std::int64_t>();
    return std::nullopt;
}

/// Whether it is a value that may differ a little, see counts_difference.
bool is_measured(const json& value) {
    return value.is_object() && value.size() == 2 && value.contains("value") &&
           value.contains("bound") && value["value"].is_number() && value["bound"].is_number();
}

bool equal_measured(const json& before, const json& after) {
    return equal_distances(before["value"].get<double>(), after["value"].get<double>(),
                           before["bound"].get<double>());
}

/// The leaf as JSON, on one line.
std::string text_of(const json& leaf) {
    return leaf.dump(-1, ' ', false, json::error_handler_t::replace);
}

bool equal_leaves(const json& a, const json& b) {
    if (integer_in(a) || integer_in(b)) return integer_in(a) == integer_in(b);
    // Texts that are not UTF-8 would look equal when printed.
    return a.is_string() ? a == b : text_of(a) == text_of(b);
}

std::string below(const std::string& place, const std::string& key) {
    std::string path = place.empty() ? "" : place + "/";
    for (const char c : key) {
        if (c == '~') path += "~0";
        if (c == '/') path += "~1";
        if (c != '~' && c != '/') path += c;
    }
    return path;
}

/// Frames and depths are ordered as numbers, "2" before "10", and come before other keys.
struct NumbersFirst {
    bool operator()(const std::string& a, const std::string& b) const {
        const bool a_counts = is_number(a), b_counts = is_number(b);
        if (a_counts != b_counts) return a_counts;
        if (a_counts && a.size() != b.size()) return a.size() < b.size();
        return a < b;
    }

  private:
    /// As counts write numbers: without leading zeros.
    static bool is_number(const std::string& key) {
        return !key.empty() && (key[0] != '0' || key.size() == 1) &&
               std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; });
    }
};

std::set<std::string, NumbersFirst> keys_of(const json& a, const json& b) {
    std::set<std::string, NumbersFirst> keys;
    for (const json* object : {&a, &b})
        for (const auto& member : object->items()) keys.insert(member.key());
    return keys;
}

class Walk {
  public:
    /// `before` and `after` are the values at `place`; null: that side has none.
    void compare(const json* before, const json* after, const std::string& place) {
        if (before && after && is_measured(*before) && is_measured(*after)) {
            if (equal_measured(*before, *after)) return;
            changes_.push_back({place,
                                {},
                                {},
                                text_of((*before)["value"]),
                                text_of((*after)["value"]),
                                text_of((*before)["bound"])});
            return;
        }
        const bool alike =
            before && after && is_container(*before) && before->type() == after->type();
        if (alike && before->is_object()) return compare_objects(*before, *after, place);
        if (alike) return compare_lists(*before, *after, place);
        const bool leaves = before && after && !is_branch(*before) && !is_branch(*after);
        if (leaves && equal_leaves(*before, *after)) return;
        if (leaves) return add(place, before, after);
        if (before) add_leaves(*before, place, true);
        if (after) add_leaves(*after, place, false);
    }

    std::vector<CountChange> result() && { return std::move(changes_); }

  private:
    void compare_objects(const json& before, const json& after, const std::string& place) {
        const auto in = [](const json& object, const std::string& key) {
            const auto found = object.find(key);
            return found == object.end() ? nullptr : &*found;
        };
        for (const std::string& key : keys_of(before, after))
            compare(in(before, key), in(after, key), below(place, key));
    }

    void compare_lists(const json& before, const json& after, const std::string& place) {
        for (std::size_t i = 0; i < before.size() || i < after.size(); ++i)
            compare(i < before.size() ? &before[i] : nullptr,
                    i < after.size() ? &after[i] : nullptr, below(place, std::to_string(i)));
    }

    /// Adds all leaves at or below a value that the other side does not have.
    void add_leaves(const json& value, const std::string& place, bool is_before) {
        if (!is_branch(value))
            return is_before ? add(place, &value, nullptr) : add(place, nullptr, &value);
        if (value.is_object())
            for (const std::string& key : keys_of(value, json::object()))
                add_leaves(value[key], below(place, key), is_before);
        else
            for (std::size_t i = 0; i < value.size(); ++i)
                add_leaves(value[i], below(place, std::to_string(i)), is_before);
    }

    void add(const std::string& place, const json* before, const json* after) {
        CountChange change{place, {}, {}};
        if (before && !(change.before = integer_in(*before))) change.before_text = text_of(*before);
        if (after && !(change.after = integer_in(*after))) change.after_text = text_of(*after);
        changes_.push_back(std::move(change));
    }

    std::vector<CountChange> changes_;
};

}  // namespace

bool is_hash(const CountChange& change) {
    constexpr std::string_view name = "pairs_hash";
    return std::string_view(change.place).ends_with(name);
}

std::vector<CountChange> counts_difference(const json& before, const json& after) {
    Walk walk;
    walk.compare(&before, &after, "");
    return std::move(walk).result();
}

}  // namespace scb::golden
