#include "render/figures/reason_words.h"

namespace scb::render {

ReasonWords words_of(PassReason reason, QueryKind kind) {
    const bool is_distance = is_of_distance(kind);
    switch (reason) {
        case PassReason::triangles_meet:
            if (is_distance) return {reason, "led to the answer", "needed", ""};
            return {reason, "true contact", "true", ""};
        case PassReason::loose_fit:
            return {reason, "fit too loose", "fit", "since volumes are too loose"};
        case PassReason::weak_test:
            if (is_distance)
                return {reason, "bound too weak", "bound", "since bounds are too weak"};
            return {reason, "test too weak", "test", "since the overlap test is too weak"};
        case PassReason::early:
            return {reason, "passed too early", "early", "before the distance was known"};
        case PassReason::unjudged:
            break;
    }
    return {reason, "not judged", "unjudged", "for a reason that is not judged"};
}

std::vector<ReasonWords> reason_words(QueryKind kind, const PassCounts& counts) {
    std::vector<ReasonWords> all = {words_of(PassReason::triangles_meet, kind)};
    for (const PassReason reason : waste_reasons(kind))
        if (reason != PassReason::unjudged || counts.passed(reason) > 0)
            all.push_back(words_of(reason, kind));
    return all;
}

}  // namespace scb::render
