#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace scb {

/// A count that differs: by its place, "frames/100/stages/ball-slab" or "bodies/A/volumes". A place
/// that only one side has has no value on the other.
struct CountChange {
    std::string place;
    std::optional<std::int64_t> before, after;

    friend bool operator==(const CountChange&, const CountChange&) = default;
};

/// Every count that differs, in the order of the places in `before`, then those that only `after`
/// has. Both are trees of objects whose leaves are integers; objects and lists are walked by key
/// and by index. Leaves of other kinds are compared as text, and have no values where they differ.
std::vector<CountChange> counts_difference(const nlohmann::json& before,
                                           const nlohmann::json& after);

}  // namespace scb
