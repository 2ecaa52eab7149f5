#include "core/judge/pose_fit.h"

#include "core/judge/item_contact.h"
#include "core/judge/node_contact.h"
#include "core/judge/test_links.h"

namespace scb {

PoseFit fit_of_pose(const EngineQuery& query, const Pose& b_to_a) {
    PoseFit fit;
    for (const EngineEvent& event : query.events) {
        if (event.kind == EngineEvent::Kind::pair) continue;
        if (event.kind != EngineEvent::Kind::volumes) {
            fit.wrong_items += error_of(query, b_to_a, event).has_value();
            continue;
        }
        // The bounds of a distance query depend on its answer, which another pose changes.
        if (query.kind == QueryKind::distance) continue;
        const double reach = query.kind == QueryKind::within ? query.limit : 0;
        const TestVerdict verdict = verdict_of(
            certificate_of(query, b_to_a, nodes_of(query, event), reach), event.stage == 0);
        fit.wrong += verdict == TestVerdict::wrong;
        fit.false_positive += verdict == TestVerdict::false_positive;
    }
    return fit;
}

}  // namespace scb
