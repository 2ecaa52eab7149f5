#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "scb/volume.h"

namespace scb {

/// Which of two overlapping nodes is divided: A's where its size is not below B's, so a tie divides
/// A. A node that cannot be divided never is.
enum class DescentRule {
    radius,       ///< the larger descent_size: the paper's rule (Section 5)
    area,         ///< the larger surface area
    volume,       ///< the larger volume
    alternating,  ///< in turn, A first
};

/// "radius", "area", "volume", "alternating".
std::string_view descent_rule_name(DescentRule rule);
std::optional<DescentRule> descent_rule_of(std::string_view name);
std::span<const DescentRule> all_descent_rules();

/// Whether A's node is the one that is divided. `depth` is that of the pair: both nodes' depths
/// added.
template <DescentRule rule, Volume V>
bool descends_into_a(const V& a, const V& b, int depth) {
    if constexpr (rule == DescentRule::radius) return descent_size(a) >= descent_size(b);
    if constexpr (rule == DescentRule::area) return surface_area(a) >= surface_area(b);
    if constexpr (rule == DescentRule::volume) return volume(a) >= volume(b);
    return depth % 2 == 0;
}

}  // namespace scb
