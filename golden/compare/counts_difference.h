#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace scb::golden {

/// A count that differs: by its place, "frames/100/stages/ball-slab" or "bodies/A/volumes". A place
/// that only one side has has no value on the other.
struct CountChange {
    std::string place;
    std::optional<std::int64_t> before, after;
    /// What stands there instead of an integer of 64 bits, as JSON: "0.5", "\"scb\"", "{}". Empty
    /// where an integer or nothing does.
    std::string before_text{}, after_text{};

    friend bool operator==(const CountChange&, const CountChange&) = default;
};

/// Whether it is of a hash: that it changed says something, and by how much does not.
bool is_hash(const CountChange& change);

/// Every count that differs, in the order of their places, with frames and depths as numbers: "2"
/// before "10". Both are trees of objects whose leaves are integers; objects and lists are walked
/// by key and by index. Leaves of other kinds are compared as JSON text: 1.0 is not 1. An object or
/// list without entries is such a leaf, unless the other side has one of its kind with entries.
/// Where an object stands against a list or a leaf, everything in either has gone or come. Keys
/// with '/' or '~' have these as "~1" and "~0" in places, as in a JSON pointer (RFC 6901).
///
/// The result is empty if and only if the trees are equal.
std::vector<CountChange> counts_difference(const nlohmann::json& before,
                                           const nlohmann::json& after);

}  // namespace scb::golden
