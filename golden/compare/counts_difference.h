#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace scb::golden {

/// A count that differs: by its place, "frames/100/stages/ball-slab" or "bodies/A/volumes". If only
/// one side has the place, the other has no value.
struct CountChange {
    std::string place;
    std::optional<std::int64_t> before, after;
    /// A value that is not an integer of 64 bits, as JSON: "0.5", "\"scb\"", "{}". Empty for an
    /// integer or no value.
    std::string before_text{}, after_text{};
    /// Of distances, the difference that was allowed, as JSON; empty for others.
    std::string bound{};

    friend bool operator==(const CountChange&, const CountChange&) = default;
};

/// Whether it is a hash, whose changes have no meaningful size.
bool is_hash(const CountChange& change);

/// Every count that differs, in the order of their places, with frames and depths as numbers: "2"
/// before "10". Both are trees of objects whose leaves are integers; objects and lists are compared
/// by key and by index. Leaves of other kinds are compared as JSON text: 1.0 is not 1. An object or
/// list without entries is such a leaf, unless the other side has one of its kind with entries. If
/// an object is compared with a list or a leaf, everything in the one is removed, and everything in
/// the other is added. '/' and '~' in keys are "~1" and "~0" in places, as in a JSON pointer (RFC
/// 6901).
///
/// Two objects {"value": x, "bound": b} of numbers are one value each, such as a distance. They are
/// equal if the values differ by at most the bound on the side of `before`.
///
/// Without such objects, the result is empty if and only if the trees are equal.
std::vector<CountChange> counts_difference(const nlohmann::json& before,
                                           const nlohmann::json& after);

}  // namespace scb::golden
