#pragma once

#include <optional>
#include <vector>

#include "app/study/mesh_trial.h"

namespace scb::app {

/// A mesh without copies and degenerate triangles, see CleanMesh.
struct CuredMesh {
    std::size_t side = 0;  ///< the first body with the mesh: A (0) or B (1)
    std::size_t copies = 0, degenerate = 0;
};

/// The same queries of such meshes.
struct CureTrial {
    std::vector<CuredMesh> meshes;
    TrialWork work;
};

/// The queries without the copies and degenerate triangles of meshes that have at least 1 % of
/// these. None if that saves too little, see TrialWork::pays, or if `progress` ended the trial.
std::optional<CureTrial> try_clean_meshes(const scenes::Scene& scene, std::size_t a, std::size_t b,
                                          const SceneTuning& tuning, const TuneProgress& progress);

}  // namespace scb::app
