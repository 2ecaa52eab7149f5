#include <array>

#include "core/base/enum_names.h"
#include "core/base/simd_targets.h"

// After the line above.
#include <hwy/highway.h>

namespace scb {
namespace {

[[maybe_unused]] std::int64_t targets_of(SimdLevel level) {
    switch (level) {
        case SimdLevel::base:
            return 0;
        case SimdLevel::sse4:
            return HWY_SSE4;
        case SimdLevel::avx2:
            return HWY_AVX2;
        case SimdLevel::avx512:
            return HWY_AVX3;
        case SimdLevel::best:
            break;
    }
    return ~std::int64_t{0};
}

}  // namespace

#if (HWY_TARGETS & (HWY_TARGETS - 1)) == 0

// One target was compiled: there is no choice, and Highway's library is not needed.
std::size_t simd_target_index(SimdLevel) { return 0; }
std::vector<SimdLevel> available_simd_levels() { return {SimdLevel::best, SimdLevel::base}; }

#else

// Asking the CPU takes a microsecond, and many in a virtual machine.
std::int64_t supported() {
    static const std::int64_t targets = hwy::SupportedTargets();
    return targets;
}

// Once, since a query asks several times.
std::size_t simd_target_index(SimdLevel level) {
    constexpr std::size_t level_count = 5;
    static_assert(static_cast<std::size_t>(SimdLevel::avx512) + 1 == level_count);
    static const std::array<std::size_t, level_count> indices = [] {
        std::array<std::size_t, level_count> result{};
        for (std::size_t i = 0; i < result.size(); ++i) {
            hwy::ChosenTarget chosen;
            chosen.Update(supported() & targets_of(static_cast<SimdLevel>(i)));
            result[i] = chosen.GetIndex();
        }
        return result;
    }();
    return indices[static_cast<std::size_t>(level)];
}

std::vector<SimdLevel> available_simd_levels() {
    std::vector<SimdLevel> levels = {SimdLevel::best, SimdLevel::base};
    for (const SimdLevel level : {SimdLevel::sse4, SimdLevel::avx2, SimdLevel::avx512})
        if ((supported() & HWY_TARGETS & targets_of(level)) != 0) levels.push_back(level);
    return levels;
}

#endif

std::string_view simd_level_name(SimdLevel level) {
    return EnumNames<SimdLevel, 5>{"best", "base", "sse4", "avx2", "avx512"}[level];
}

}  // namespace scb
