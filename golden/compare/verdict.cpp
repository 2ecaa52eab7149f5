#include "golden/compare/verdict.h"

#include <array>
#include <cstddef>

namespace scb::golden {
namespace {

/// In the order of Verdict.
constexpr std::array<std::string_view, 7> verdict_names{
    "same",       "different",     "size differs", "missing baseline",
    "new output", "could not run", "skipped"};

}  // namespace

std::string_view verdict_name(Verdict verdict) {
    return verdict_names[static_cast<std::size_t>(verdict)];
}

std::optional<Verdict> verdict_of(std::string_view name) {
    for (std::size_t i = 0; i < verdict_names.size(); ++i)
        if (verdict_names[i] == name) return static_cast<Verdict>(i);
    return std::nullopt;
}

bool is_failure(Verdict verdict) { return verdict != Verdict::same && verdict != Verdict::skipped; }

}  // namespace scb::golden
