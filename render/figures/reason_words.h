#pragma once

#include <string>
#include <vector>

#include "core/analysis/inspection.h"

namespace scb::render {

/// How reports speak of a reason for which pairs pass.
struct ReasonWords {
    PassReason reason{};
    const char* title = "";    ///< in lists: "fit too loose"
    const char* column = "";   ///< heading of a column: "fit"
    const char* because = "";  ///< "since volumes are too loose"; empty unless tests are wasted
};

/// The reasons of these queries: first triangles_meet, then waste_reasons. Pairs that are not
/// judged have a place only if there are some.
std::vector<ReasonWords> reason_words(QueryKind kind, const PassCounts& counts);

/// The words of one reason.
ReasonWords words_of(PassReason reason, QueryKind kind);

}  // namespace scb::render
