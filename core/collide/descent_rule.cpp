#include "scb/descent_rule.h"

#include <array>

namespace scb {
namespace {

constexpr std::array rules = {DescentRule::radius, DescentRule::area, DescentRule::volume,
                              DescentRule::alternating};
constexpr std::array<std::string_view, rules.size()> names = {"radius", "area", "volume",
                                                              "alternating"};

}  // namespace

std::string_view descent_rule_name(DescentRule rule) {
    return names[static_cast<std::size_t>(rule)];
}

std::optional<DescentRule> descent_rule_of(std::string_view name) {
    for (const DescentRule rule : rules)
        if (descent_rule_name(rule) == name) return rule;
    return std::nullopt;
}

std::span<const DescentRule> all_descent_rules() { return rules; }

}  // namespace scb
