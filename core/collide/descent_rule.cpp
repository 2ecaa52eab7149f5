#include "scb/descent_rule.h"

#include <array>

#include "core/base/enum_names.h"

namespace scb {
namespace {

constexpr std::array rules = {DescentRule::radius, DescentRule::area, DescentRule::volume,
                              DescentRule::alternating};
constexpr EnumNames<DescentRule, rules.size()> rule_names = {"radius", "area", "volume",
                                                             "alternating"};

}  // namespace

std::string_view descent_rule_name(DescentRule rule) { return rule_names[rule]; }
std::optional<DescentRule> descent_rule_of(std::string_view name) { return rule_names.find(name); }

std::span<const DescentRule> all_descent_rules() { return rules; }

}  // namespace scb
