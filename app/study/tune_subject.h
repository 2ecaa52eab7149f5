#pragma once

#include <vector>

#include "app/study/query_timing.h"
#include "app/study/scene_query.h"
#include "core/analysis/tuning.h"
#include "scb/any_packed.h"

namespace scb::app {

/// The hierarchies of a setting, one per mesh.
struct BuiltSetting {
    TuneSetting setting;
    scenes::SharedHierarchies hierarchies;
    double ms = 0;  ///< processor time of building them
};

/// The hierarchies of two bodies, packed.
struct BuiltLayout {
    AnyPacked a, b;
    double ms = 0;  ///< of building and packing
};

/// A scene, two of its bodies (or one twice for a self query), frames, and data for the queries.
class TuneSubject {
  public:
    TuneSubject(const scenes::Scene& scene, std::size_t a, std::size_t b,
                const std::vector<int>& frames, const BuildOptions& build);

    std::size_t frames() const { return poses_.size(); }

    BuiltSetting build(const TuneSetting& setting);
    /// Whether the queries can use packed layouts: only queries of two bodies.
    bool has_layouts() const { return joined_.empty(); }
    /// Throws InputError if the layout cannot hold a mesh.
    BuiltLayout pack(const BuiltSetting& built, const PackedLayout& layout) const;

    /// Of both bodies, topology included.
    double bytes_per_triangle(const BuiltSetting& built) const;
    double bytes_per_triangle(const BuiltLayout& built) const;

    Collision query(const BuiltSetting& built, const TuneSetting& setting, std::size_t frame) const;
    /// Pairs and counts, without N_u. Not for several threads at a time.
    PackedCollision query(const BuiltLayout& built, std::size_t frame);
    /// Queries of distances.
    QueryAnswer query(const BuiltSetting& built, const DistanceQuery& asked,
                      std::size_t frame) const;
    QueryAnswer query(const BuiltLayout& built, const DistanceQuery& asked,
                      std::size_t frame) const;

    /// Makes a timed query independent of the one before it. A setting would be quicker right after
    /// one with the same hierarchies, which are then in the caches, or with the same overlap test,
    /// whose branches it repeats. So this brings the nodes into the caches by a query with the
    /// slowest test, and with A and B exchanged.
    void prepare(const BuiltSetting& built, std::size_t frame) const;
    /// The same; a layout has only one test.
    void prepare(const BuiltLayout& built, std::size_t frame);
    /// The same for queries of distances, with A and B exchanged.
    void prepare(const BuiltSetting& built, const DistanceQuery& asked, std::size_t frame) const;
    void prepare(const BuiltLayout& built, const DistanceQuery& asked, std::size_t frame) const;

  private:
    struct Split {
        std::vector<MeshTopology> topologies;
        double ms = 0;
    };

    double per_triangle(std::size_t bytes) const;

    const scenes::Scene& scene_;
    BuildOptions build_;
    std::size_t mesh_a_, mesh_b_;
    std::vector<std::uint32_t> joined_;  // of a self query
    Split splits_[2];
    std::vector<Pose> poses_;  // per frame
    PackedWorkspace workspace_;
};

}  // namespace scb::app
