#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace scb {

/// Which of two overlapping nodes is divided: A's node if its size is not below the size of B's, so
/// a tie divides A. If one cannot be divided, the other is.
enum class DescentRule {
    radius,       ///< the larger descent_size: the paper's rule (Section 5)
    area,         ///< the larger surface area
    volume,       ///< the larger volume
    alternating,  ///< in turn, A first
};

/// "radius", "area", "volume", "alternating".
std::string_view descent_rule_name(DescentRule rule);
/// The rule of this name, or nothing where there is none.
std::optional<DescentRule> descent_rule_of(std::string_view name);
/// All rules, in the order in which they are declared.
std::span<const DescentRule> all_descent_rules();

}  // namespace scb
