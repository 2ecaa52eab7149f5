#include "golden/suite/case_counts.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "scb/error.h"

namespace scb::golden {
namespace {

using Json = nlohmann::json;

/// The name of an element of a list; empty if it has none.
std::string name_of(const Json& element) {
    const auto text = [&element](const char* key) {
        return element[key].is_string() ? element[key].get<std::string>() : element[key].dump();
    };
    for (const char* key : {"frame", "body"})
        if (element.contains(key)) return text(key);
    // A query of one of several pairs of bodies. Its depth is a count.
    if (element.contains("bodies")) return text("bodies");
    if (element.contains("depth")) return text("depth");
    if (!element.contains("test") || !element["test"].is_string()) return "";
    const std::string test = element["test"];
    return element.contains("threshold") ? test + " " + element["threshold"].dump() : test;
}

/// Numbers that are not counts, such as the first ids of pixels.
bool is_no_count(const std::string& key) {
    constexpr std::string_view keys[] = {"first_id", "pair_ids", "frame", "depth_of_pair", "test"};
    return std::find(std::begin(keys), std::end(keys), key) != std::end(keys);
}

/// Whether it is a query of a distance, as `scb distance` prints it.
bool has_distance(const Json& query) {
    return query.contains("rounding") && query.contains("distance") &&
           query["distance"].is_number() && query["rounding"].is_number();
}

/// The distance with its bound, and the closest triangles. At distance 0, any triangles that
/// intersect are right.
void add_distance(const Json& query, Json& counts) {
    counts["distance"] = {{"value", query["distance"]}, {"bound", query["rounding"]}};
    if (query["distance"] > 0)
        counts["triangles"] = {{"a", query["triangles"].at(0)}, {"b", query["triangles"].at(1)}};
}

/// Nothing if it has no counts; only objects, lists, integers and booleans may have.
std::optional<Json> counts_in(const Json& value, const std::string& place);

std::int64_t hash_count(const Json& hash, const std::string& place) {
    constexpr int dropped_bits = 64 - 53;
    const std::string text = hash.is_string() ? hash.get<std::string>() : "";
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    if (text.size() != 16 || std::from_chars(text.data(), end, value, 16).ptr != end)
        throw InputError(place +
                         " is not a hash of 16 hexadecimal digits; was it made by this scb?");
    return static_cast<std::int64_t>(value >> dropped_bits);
}

std::optional<Json> counts_in_list(const Json& list, const std::string& place) {
    Json counts = Json::object();
    for (const Json& element : list) {
        if (!element.is_object()) return std::nullopt;
        const std::string name = name_of(element);
        if (name.empty() || counts.contains(name))
            throw InputError(
                place +
                (name.empty() ? " has an element without a name" : " has " + name + " twice") +
                ", so its counts cannot be told apart; make a case of each.");
        counts[name] = counts_in(element, place + "/" + name).value_or(Json::object());
    }
    return counts;
}

std::optional<Json> counts_in_object(const Json& object, const std::string& place) {
    Json counts = Json::object();
    for (const auto& [key, inner] : object.items()) {
        if (is_no_count(key)) continue;
        if (key == "inside" && inner.is_array()) {
            counts[key] = inner.size();
            continue;
        }
        const std::string inner_place = place + "/" + key;
        if (key == "pairs_hash") {
            counts[key] = hash_count(inner, inner_place);
        } else if (std::optional<Json> found = counts_in(inner, inner_place)) {
            counts[key] = std::move(*found);
        }
    }
    if (has_distance(object)) add_distance(object, counts);
    if (counts.empty()) return std::nullopt;
    return counts;
}

std::optional<Json> counts_in(const Json& value, const std::string& place) {
    if (value.is_boolean()) return Json(value.get<bool>() ? 1 : 0);
    if (value.is_number_integer()) return value;
    std::optional<Json> counts;
    if (value.is_array()) counts = counts_in_list(value, place);
    if (value.is_object()) counts = counts_in_object(value, place);
    if (counts && counts->empty()) return std::nullopt;
    return counts;
}

/// Whether some part of the document says that queries are left out.
bool leaves_out_queries(const Json& document) {
    if (document.is_object() && document.contains("left_out")) return true;
    return document.is_structured() &&
           std::any_of(document.begin(), document.end(), leaves_out_queries);
}

}  // namespace

Json case_counts(GoldenRun run, const Json& document) {
    // A change of these queries would not be found.
    if (leaves_out_queries(document))
        throw InputError(
            "Frames of the recording have several queries of these bodies, and one query of each "
            "frame is counted; select queries with --query or --tag in `arguments`.");
    Json counts = Json::object();
    const auto take = [&](const char* from, const char* to) {
        if (!document.is_object() || !document.contains(from))
            throw InputError(std::string("The output of the run has no `") + from +
                             "`, whose counts are compared; check that this scb made it.");
        counts[to] = counts_in(document[from], from).value_or(Json::object());
    };
    if (run == GoldenRun::inspect) {
        for (const char* key : {"frames", "sum", "depths", "other_tests"}) take(key, key);
    } else {
        take(has_picture(run) ? "files" : "frames", "frames");
    }
    if (counts["frames"].empty())
        throw InputError("It made no counts of any frame, so nothing would be compared.");
    return counts;
}

std::string only_frame(const Json& counts) {
    const auto frames = counts.find("frames");
    if (frames == counts.end() || !frames->is_object() || frames->size() != 1) return "";
    const auto only = frames->begin();
    return only->is_object() && only->contains("queries") ? "" : only.key();
}

}  // namespace scb::golden
