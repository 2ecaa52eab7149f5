#include <benchmark/benchmark.h>

#include <array>

#include "scb/packed_distance.h"
#include "scenes/scene/motion.h"
#include "scenes/shapes/procedural.h"

// The distance of two bodies of 20 thousand triangles, by the reference and by packed hierarchies,
// at gaps from a thousandth of their size to their size. The bodies are spheres with two axes
// shortened, turned against each other. Other poses follow in turn, so that no branch is learnt by
// heart. Compare medians of repetitions: --benchmark_repetitions=9.
namespace scb {
namespace {

constexpr std::size_t poses_of_gap = 16;

struct Bodies {
    Mesh mesh = scenes::icosphere(5, 1);
    Hierarchy<Scb2> reference;
    PackedHierarchy<QuickestCodec> packed;

    Bodies() {
        for (Vec3& v : mesh.vertices) v = v.cwiseProduct(Vec3(1, 0.7, 0.4));
        reference = build_hierarchy<Scb2>(mesh, packed_build);
        packed = build_packed(mesh);
    }
    PackedCollider<QuickestCodec> packed_side() const { return {packed, mesh}; }
    Collider<Scb2> reference_side() const { return {reference, mesh}; }

    /// Poses in which the distance is `gap`.
    std::array<Pose, poses_of_gap> poses(double gap) const {
        std::array<Pose, poses_of_gap> poses;
        for (std::size_t i = 0; i < poses.size(); ++i) {
            poses[i].rotation = scenes::rotation_about({3, -1, 2}, 30 + 17.0 * double(i));
            double near = 0, far = 4;
            for (int k = 0; k < 50; ++k) {
                const double middle = (near + far) / 2;
                poses[i].translation = middle * Vec3(0.6, 0.8 - 0.1 * double(i), 0.5);
                const double found =
                    distance_packed(packed_side(), packed_side(), poses[i]).found.distance;
                (found < gap ? near : far) = middle;
            }
        }
        return poses;
    }
};
const Bodies& bodies() {
    static const Bodies built;
    return built;
}

/// The gap is 1 / range of the size, 2.
double gap_of(const benchmark::State& state) { return 2.0 / double(state.range(0)); }

template <class Query>
void distances(benchmark::State& state, const Query& query) {
    const auto poses = bodies().poses(gap_of(state));
    std::size_t i = 0;
    double n_v = 0, n_p = 0;
    for (auto _ : state) {
        const auto found = query(poses[i++ % poses.size()]);
        n_v += double(found.n_v);
        n_p += double(found.n_p);
    }
    state.counters["n_v"] = n_v / double(state.iterations());
    state.counters["n_p"] = n_p / double(state.iterations());
}

void reference_distance(benchmark::State& state) {
    distances(state, [side = bodies().reference_side()](const Pose& pose) {
        return distance(side, side, pose);
    });
}
void packed_distance(benchmark::State& state) {
    distances(state, [side = bodies().packed_side()](const Pose& pose) {
        return distance_packed(side, side, pose);
    });
}

void gaps(benchmark::internal::Benchmark* of) {
    of->ArgName("size/gap")->Arg(1000)->Arg(100)->Arg(10)->Arg(1)->Unit(benchmark::kMicrosecond);
}
BENCHMARK(reference_distance)->Apply(gaps);
BENCHMARK(packed_distance)->Apply(gaps);

}  // namespace
}  // namespace scb

BENCHMARK_MAIN();
