#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/study/mesh_trial.h"
#include "core/analysis/tested_triangles.h"

namespace scb::app {

/// Triangles of one mesh that were cut, see cut_triangles.
struct MeshCut {
    std::size_t side = 0;              ///< the first body with the mesh: A (0) or B (1)
    std::vector<std::uint32_t> seeds;  ///< empty: all triangles with a side longer than `longest`
    double longest = 0;                ///< of the sides of pieces
    std::size_t triangles = 0, pieces = 0;
};

/// The same queries of meshes with cut triangles.
struct CutTrial {
    std::vector<MeshCut> meshes;
    TrialWork work;
};

/// Cuts the triangles that take most of the triangle tests, at several lengths, and takes the
/// length of the least cost with the recommended setting or layout; if no cut saves a tenth of that
/// cost, the length of the least cost with the base setting, if that saves a quarter. If these
/// triangles are many, all triangles with longer sides are cut. None if no cut saves that much, or
/// if `progress` ended the trial. `tested`: of A and of B, the latter empty in a self query.
std::optional<CutTrial> try_cuts(const scenes::Scene& scene, std::size_t a, std::size_t b,
                                 const SceneTuning& tuning,
                                 const std::array<std::vector<TestedTriangle>, 2>& tested,
                                 const TuneProgress& progress);

}  // namespace scb::app
