#include "golden/compare/verdict.h"

#include <array>
#include <cstddef>

namespace scb::golden {
bool is_failure(Verdict verdict) { return verdict != Verdict::same && verdict != Verdict::skipped; }

}  // namespace scb::golden
