#include <benchmark/benchmark.h>

#include <cmath>
#include <map>

#include "scb/any_packed.h"
#include "scenes/scene/motion.h"
#include "scenes/shapes/procedural.h"

// How build and query grow with the number of triangles, from 20 thousand to 5 million: two spheres
// of triangles. From size to size each triangle is divided into four. If surfaces cross in a curve,
// a query's work is proportional to the pairs found, about the square root of the triangles.
namespace scb {
namespace {

const Mesh& sphere(int subdivisions) {
    static std::map<int, Mesh> meshes;
    const auto [at, is_new] = meshes.try_emplace(subdivisions);
    if (is_new) at->second = scenes::icosphere(subdivisions, 1);
    return at->second;
}

void count(benchmark::State& state, const char* name, double of) {
    state.counters[name] = benchmark::Counter(
        of, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void build(benchmark::State& state) {
    const Mesh& mesh = sphere(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(build_packed(mesh));
    const auto n = static_cast<double>(mesh.triangles.size());
    state.counters["triangles"] = n;
    count(state, "time/(n log2 n)", n * std::log2(n));
}

void query(benchmark::State& state) {
    const Mesh& mesh = sphere(static_cast<int>(state.range(0)));
    const auto packed = build_packed(mesh);
    const PackedCollider side{packed, mesh};
    // Other poses in turn, so that no branch is learnt by heart.
    constexpr int poses = 16;
    std::vector<Pose> b_to_a(poses);
    for (int i = 0; i < poses; ++i) {
        b_to_a[static_cast<std::size_t>(i)].rotation =
            scenes::rotation_about({3, -1, 2}, 30 + 7.0 * i);
        b_to_a[static_cast<std::size_t>(i)].translation = {0.9, 0.01 * i, 0};
    }
    PackedWorkspace workspace;
    std::size_t i = 0, pairs = 0;
    for (auto _ : state) {
        const PackedCollision found =
            collide_packed(side, side, b_to_a[i++ % poses], {}, &workspace);
        pairs += found.pairs.size();
    }
    const auto n = static_cast<double>(mesh.triangles.size());
    const double found = static_cast<double>(pairs) / static_cast<double>(state.iterations());
    state.counters["triangles"] = n;
    state.counters["pairs"] = found;
    count(state, "time/(pairs log2 n)", found * std::log2(n));
}

BENCHMARK(build)->DenseRange(5, 9)->Unit(benchmark::kMillisecond);
BENCHMARK(query)->DenseRange(5, 9)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace scb

BENCHMARK_MAIN();
