#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/model/engine_nodes.h"
#include "scb/mesh.h"

namespace scb {

/// x -> scale * rotation * x + shift.
struct Similarity {
    Mat3 rotation = Mat3::Identity();
    double scale = 1;
    Vec3 shift = Vec3::Zero();

    Vec3 operator()(const Vec3& x) const { return scale * rotate(rotation, x) + shift; }
};

/// The map of the mesh after which the flat faces of the nodes' volumes touch what is below them:
/// a start from the middles of the leaves (Davenport's q-method, as in Wahba, "A Least Squares
/// Estimate of Satellite Attitude", 1965), then Gauss-Newton steps. Within a step, the vertex that
/// is farthest along a face stays the same. Empty if there are too few faces.
std::optional<Similarity> fit_similarity(const EngineNodes& tree, const TreeShape& shape,
                                         const Mesh& mesh);

/// "a rotation by 35 degrees about z, a scale by 2 and a shift by (0, 0, 1)". Parts that move no
/// point of a mesh of this reach by more than `tolerance` are left out.
std::string words_of(const Similarity& map, double reach, double tolerance);

}  // namespace scb
