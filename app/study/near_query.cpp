#include "app/study/near_query.h"

#include "scb/any_distance.h"

namespace scb::app {
namespace {

QueryAnswer answer_of(const Distance& nearest) {
    QueryAnswer answer{{}, nearest.found.distance};
    answer.found.n_v = nearest.n_v;
    answer.found.n_p = nearest.n_p;
    answer.found.n_u = nearest.n_u;
    return answer;
}

}  // namespace

QueryAnswer near_answer(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                        const Mesh& mesh_b, const Pose& b_to_a, const DistanceQuery& asked) {
    if (asked.within)
        return {within(a, mesh_a, b, mesh_b, b_to_a, *asked.within, asked.limits.descent)};
    return answer_of(distance(a, mesh_a, b, mesh_b, b_to_a, asked.limits));
}

QueryAnswer near_answer(const AnyPacked& a, const Mesh& mesh_a, const AnyPacked& b,
                        const Mesh& mesh_b, const Pose& b_to_a, const DistanceQuery& asked,
                        SimdLevel level) {
    if (asked.within)
        return {collision_of(within_packed(a, mesh_a, b, mesh_b, b_to_a, *asked.within, level))};
    return answer_of(
        distance_of(distance_packed(a, mesh_a, b, mesh_b, b_to_a, asked.limits, level)));
}

}  // namespace scb::app
