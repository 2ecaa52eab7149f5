#include "app/study/proven_distance.h"

namespace scb::app {

CertifiedDistance certified_distance(const SceneQuery& query, const Pose& b_to_a,
                                     const IndexPair& closest, double distance) {
    const MeshTree a = query.mesh_tree(query.a), b = query.mesh_tree(query.b);
    const DistanceCertificate certificate = make_certificate(a, b, b_to_a, closest);
    CertifiedDistance result{check_distance(a, b, b_to_a, certificate),
                             certificate.directions.size()};
    result.certified = certifies(result.proven, distance);
    return result;
}

bool is_certified(const SceneQuery& query, const QueryTrace& frame) {
    if (!frame.nearest || frame.found.pairs.empty()) return false;
    if (query.distance && query.distance->limits.relative_error > 0) return false;
    return certified_distance(query, frame.b_to_a, frame.found.pairs.front(),
                              frame.nearest->distance)
        .certified;
}

}  // namespace scb::app
