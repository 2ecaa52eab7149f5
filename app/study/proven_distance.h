#pragma once

#include "app/study/scene_query.h"
#include "core/distance/distance_certificate.h"

namespace scb::app {

/// What a certificate proves of the distance of A and B.
struct CertifiedDistance {
    ProvenDistance proven;
    std::size_t directions = 0;  ///< of the certificate
    bool certified = false;      ///< whether it proves `distance`
};

/// Makes a certificate of a distance and checks it. `closest`: the triangles that a query without
/// relative error found, at the pose `b_to_a`.
CertifiedDistance certified_distance(const SceneQuery& query, const Pose& b_to_a,
                                     const IndexPair& closest, double distance);

/// Whether a certificate proves the distance that a query found. False if the query looked for
/// something else, found nothing, or had a relative error.
bool is_certified(const SceneQuery& query, const QueryTrace& frame);

}  // namespace scb::app
