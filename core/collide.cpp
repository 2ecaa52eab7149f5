#include "core/collide.h"

#include <array>

namespace scb {
namespace {

constexpr std::array rules = {DescentRule::radius, DescentRule::area, DescentRule::volume,
                              DescentRule::alternating};
constexpr std::array<std::string_view, rules.size()> names = {"radius", "area", "volume",
                                                              "alternating"};

std::uint64_t tests(const StageCounts& stages) {
    std::uint64_t sum = 0;
    for (const std::uint64_t count : stages) sum += count;
    return sum;
}

std::uint64_t at(const StageCounts& stages, Stage stage) {
    return stages[static_cast<std::size_t>(stage)];
}

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

template <>
std::uint64_t transforms<Scb>(const StageCounts& stages, const OverlapOptions& options) {
    std::uint64_t without_normal = at(stages, Stage::ball_ball);
    if (options.test != OverlapTest::extents) without_normal += at(stages, Stage::slab_ball);
    return 2 * tests(stages) - without_normal;
}

template <>
std::uint64_t transforms<Ball>(const StageCounts& stages, const OverlapOptions&) {
    return tests(stages);
}

template <>
std::uint64_t transforms<Obb>(const StageCounts& stages, const OverlapOptions&) {
    return 4 * tests(stages);
}

}  // namespace scb
