#include "golden/case_counts.h"

#include <algorithm>

namespace scb {
namespace {

using Json = nlohmann::json;

/// What the elements of a list are called after; empty where they have no names.
std::string name_of(const Json& element) {
    for (const char* key : {"frame", "body", "depth"})
        if (element.contains(key))
            return element[key].is_string() ? element[key].get<std::string>() : element[key].dump();
    if (!element.contains("test") || !element["test"].is_string()) return "";
    const std::string test = element["test"];
    return element.contains("threshold") ? test + " " + element["threshold"].dump() : test;
}

/// Where pixels' ids begin, and what else are numbers but no counts.
bool is_no_count(const std::string& key) {
    constexpr std::string_view keys[] = {"first_id", "pair_ids", "frame", "depth_of_pair", "test"};
    return std::find(std::begin(keys), std::end(keys), key) != std::end(keys);
}

Json counts_in(const Json& value);

Json counts_in_list(const Json& list) {
    Json counts = Json::object();
    for (const Json& element : list) {
        if (!element.is_object()) return Json();
        const std::string name = name_of(element);
        if (name.empty() || counts.contains(name)) return Json();
        Json inner = counts_in(element);
        if (!inner.empty()) counts[name] = std::move(inner);
    }
    return counts;
}

/// Null where there is none.
Json counts_in(const Json& value) {
    if (value.is_number_integer() || value.is_boolean())
        return value.is_boolean() ? Json(value.get<bool>() ? 1 : 0) : value;
    if (value.is_array()) return counts_in_list(value);
    if (!value.is_object()) return Json();
    Json counts = Json::object();
    for (const auto& [key, inner] : value.items()) {
        if (is_no_count(key)) continue;
        Json found = counts_in(inner);
        if (!found.is_null() && !(found.is_object() && found.empty()))
            counts[key] = std::move(found);
    }
    return counts;
}

}  // namespace

Json case_counts(GoldenRun run, const Json& document) {
    Json counts = Json::object();
    const auto take = [&](const char* from, const char* to) {
        if (!document.contains(from)) return;
        Json found = counts_in(document[from]);
        if (!found.is_null()) counts[to] = std::move(found);
    };
    if (run == GoldenRun::inspect) {
        for (const char* key : {"frames", "sum", "depths", "other_tests"}) take(key, key);
    } else {
        take(has_picture(run) ? "files" : "frames", "frames");
    }
    return counts;
}

}  // namespace scb
