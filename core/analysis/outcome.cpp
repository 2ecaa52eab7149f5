#include "core/analysis/outcome.h"

namespace scb {

std::string_view outcome_name(Outcome outcome) {
    switch (outcome) {
        case Outcome::triangles_apart:
            return "triangles apart";
        case Outcome::triangles_meet:
            return "triangles meet";
        case Outcome::found:
            return "found";
        case Outcome::left_over:
            return "left over";
        case Outcome::divided_a:
            return "divided a";
        case Outcome::divided_b:
            return "divided b";
        case Outcome::divided_both:
            return "divided both";
    }
    return stage_name(static_cast<Stage>(outcome));
}

}  // namespace scb
