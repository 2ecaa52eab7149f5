#include "scenes/scene/kept_hierarchies.h"

#include <algorithm>
#include <cstring>

namespace scb::scenes {
namespace {

/// Enough for all kinds of volumes of a mesh of 20,000 triangles.
constexpr std::size_t most_bytes = std::size_t{1} << 28;

template <class T>
bool same_bytes(const std::vector<T>& x, const std::vector<T>& y) {
    return x.size() == y.size() && (x.empty() || std::memcmp(static_cast<const void*>(x.data()),
                                                             static_cast<const void*>(y.data()),
                                                             x.size() * sizeof(T)) == 0);
}

/// Whether both give the same volumes. A caller that counts the work of fitting gets a new fit.
bool same_fit(const FitOptions& x, const FitOptions& y) {
    return !x.counts && !y.counts && x.growth == y.growth && x.ball_method == y.ball_method &&
           x.margin == y.margin;
}

}  // namespace

bool KeptHierarchies::are_latest(const Scene& scene) const {
    return std::equal(scene.meshes.begin(), scene.meshes.end(), meshes_.begin(), meshes_.end(),
                      [](const NamedMesh& named, const Mesh& kept) {
                          return same_bytes(named.mesh.triangles, kept.triangles) &&
                                 same_bytes(named.mesh.vertices, kept.vertices);
                      });
}

std::vector<MeshTopology> KeptHierarchies::topologies(const Scene& scene, SplitMethod split) const {
    const std::lock_guard lock(mutex_);
    for (const Split& kept : splits_)
        if (kept.method == split && are_latest(scene)) return kept.topologies;
    return {};
}

void KeptHierarchies::keep(const Scene& scene, SplitMethod split,
                           const std::vector<MeshTopology>& topologies) {
    const std::lock_guard lock(mutex_);
    if (!are_latest(scene)) {
        fitted_.clear();
        splits_.clear();
        meshes_.clear();
        bytes_ = 0;
        for (const NamedMesh& named : scene.meshes) meshes_.push_back(named.mesh);
    }
    splits_.push_back({split, topologies});
}

const KeptHierarchies::Split* KeptHierarchies::split_of(
    const std::vector<MeshTopology>& topologies) const {
    for (const Split& kept : splits_)
        if (std::equal(topologies.begin(), topologies.end(), kept.topologies.begin(),
                       kept.topologies.end(), [](const MeshTopology& x, const MeshTopology& y) {
                           return x.topology == y.topology;
                       }))
            return &kept;
    return nullptr;
}

SharedHierarchies KeptHierarchies::hierarchies(const std::vector<MeshTopology>& topologies,
                                               VolumeKind kind, const FitOptions& options,
                                               int deepest) const {
    const std::lock_guard lock(mutex_);
    const Split* const split = split_of(topologies);
    if (split == nullptr) return nullptr;
    for (const Fitted& kept : fitted_)
        if (kept.split == split->method && kept.kind == kind && kept.deepest == deepest &&
            same_fit(kept.options, options))
            return kept.hierarchies;
    return nullptr;
}

void KeptHierarchies::keep(const std::vector<MeshTopology>& topologies, VolumeKind kind,
                           const FitOptions& options, int deepest,
                           const SharedHierarchies& hierarchies) {
    const std::lock_guard lock(mutex_);
    const Split* const split = split_of(topologies);
    std::size_t bytes = 0;
    for (const AnyHierarchy& hierarchy : *hierarchies) bytes += bytes_of(hierarchy);
    if (split == nullptr || bytes_ + bytes > most_bytes) return;
    bytes_ += bytes;
    fitted_.push_back({split->method, kind, options, deepest, hierarchies});
}

}  // namespace scb::scenes
