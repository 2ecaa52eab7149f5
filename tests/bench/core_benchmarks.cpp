#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "core/hierarchy.h"
#include "core/random.h"
#include "core/trigonometry.h"
#include "scenes/mesh_file.h"

namespace scb {
namespace {

std::vector<Vec3> shell(std::size_t count) {
    Random random(1);
    std::vector<Vec3> points;
    while (points.size() < count) {
        const Vec3 p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        const double squared = squared_norm(p);
        if (squared > 0.01 && squared <= 1)
            points.push_back((1 + 0.05 * random.uniform()) / std::sqrt(squared) *
                             Vec3(p[0], p[1], 0.4 * p[2]));
    }
    return points;
}

// A torus with about `triangles` triangles, in rows of vertices as a mesh generator would write
// them.
Mesh torus(std::size_t triangles) {
    const auto n =
        static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(triangles) / 2)));
    Mesh mesh;
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const SinCos u = sin_cos_turns(static_cast<double>(i) / n),
                         v = sin_cos_turns(static_cast<double>(j) / n);
            mesh.vertices.emplace_back((2 + v.cos) * u.cos, (2 + v.cos) * u.sin, v.sin);
        }
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * n + i, b = j * n + (i + 1) % n;
            const std::uint32_t c = (j + 1) % n * n + i, d = (j + 1) % n * n + (i + 1) % n;
            mesh.triangles.push_back({a, b, d});
            mesh.triangles.push_back({a, d, c});
        }
    return mesh;
}

void per_n_log_n(benchmark::State& state, double n) {
    state.counters["time/(n log2 n)"] =
        benchmark::Counter(n * std::log2(n), benchmark::Counter::kIsIterationInvariantRate |
                                                 benchmark::Counter::kInvert);
}

void fit_scb_of(benchmark::State& state) {
    const std::vector<Vec3> points = shell(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(fit_scb(points));
    state.counters["time/n"] = benchmark::Counter(
        static_cast<double>(points.size()),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class V>
void build(benchmark::State& state) {
    const Mesh mesh = torus(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(build_hierarchy<V>(mesh));
    per_n_log_n(state, static_cast<double>(mesh.triangles.size()));
}

// A model of the models folder (SCB_MODELS, or shared/models beside the project); skipped, with its
// name, where that is missing.
void build_model(benchmark::State& state, const char* name) {
    const char* folder = std::getenv("SCB_MODELS");
    const std::filesystem::path path =
        std::filesystem::path(folder != nullptr ? folder : SCB_SOURCE_DIR "/../shared/models") /
        name;
    if (!std::filesystem::exists(path))
        return state.SkipWithError((path.string() + " is missing").c_str());
    const Mesh mesh = load_mesh(path);
    for (auto _ : state) benchmark::DoNotOptimize(build_hierarchy<Scb>(mesh));
    per_n_log_n(state, static_cast<double>(mesh.triangles.size()));
}
BENCHMARK_CAPTURE(build_model, horse, "horse.ply")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build_model, dragon, "dragon.ply")->Unit(benchmark::kMillisecond);

BENCHMARK(fit_scb_of)->RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(build<Scb>)->RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(build<Ball>)->RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(build<Obb>)->RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace scb

BENCHMARK_MAIN();
