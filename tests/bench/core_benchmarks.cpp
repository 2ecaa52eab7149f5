#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "core/base/portable_math.h"
#include "core/base/random.h"
#include "core/geometry/orientation.h"
#include "core/geometry/triangle_segment.h"
#include "scb/hierarchy.h"
#include "scb/triangle_overlap.h"
#include "scenes/meshes/mesh_file.h"

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
    const Mesh mesh = scenes::load_mesh(path);
    for (auto _ : state) benchmark::DoNotOptimize(build_hierarchy<Scb>(mesh));
    per_n_log_n(state, static_cast<double>(mesh.triangles.size()));
}
BENCHMARK_CAPTURE(build_model, horse, "horse.ply")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build_model, dragon, "dragon.ply")->Unit(benchmark::kMillisecond);

struct CornerPair {
    TriangleCorners a, b;
};

// Pairs of triangles of about unit size whose boxes overlap, 1024 of a kind, all different.
// (crossing_thirds: coordinates with all digits, whose differences are no doubles.)
enum class PairKind {
    rejected_by_plane,
    apart_beyond_planes,
    crossing,
    crossing_thirds,
    coplanar,
    nearly_coplanar,
    nearly_coplanar_apart,
    common_edge,
    axis_plane,
};

CornerPair random_pair(Random& random, PairKind kind) {
    const auto point = [&] {
        return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    };
    CornerPair pair{{point(), point(), point()}, {point(), point(), point()}};
    if (kind == PairKind::coplanar || kind == PairKind::nearly_coplanar ||
        kind == PairKind::nearly_coplanar_apart) {
        // Few digits, so that the sums are exact: corners are in the plane; or rounded to be near.
        const double unit = kind == PairKind::coplanar ? 256.0 : 0x1p48;
        const auto rounded = [&](const Vec3& p) {
            return Vec3(std::round(p[0] * unit) / unit, std::round(p[1] * unit) / unit,
                        std::round(p[2] * unit) / unit);
        };
        const Vec3 u = rounded(point()), v = rounded(point());
        for (TriangleCorners* t : {&pair.a, &pair.b})
            for (Vec3& p : *t) {
                const Vec3 q = rounded(point());
                p = q[0] * u + q[1] * v;
            }
    }
    if (kind == PairKind::crossing_thirds)
        for (TriangleCorners* t : {&pair.a, &pair.b})
            for (Vec3& p : *t) p /= 3;
    if (kind == PairKind::common_edge) pair.b = {pair.a[1], pair.a[0], pair.b[2]};
    if (kind == PairKind::axis_plane)
        for (std::size_t i = 0; i < 3; ++i) pair.a[i][2] = pair.b[i][2] = 0.5;
    return pair;
}

bool is_of_kind(const CornerPair& pair, PairKind kind) {
    const PlaneFilter plane_a(pair.a[0], pair.a[1], pair.a[2]),
        plane_b(pair.b[0], pair.b[1], pair.b[2]);
    const auto beside = [](const PlaneFilter& plane, const TriangleCorners& t) {
        return std::abs(plane.side(t[0]) + plane.side(t[1]) + plane.side(t[2])) == 3;
    };
    const bool rejected = beside(plane_a, pair.b) || beside(plane_b, pair.a);
    for (int axis = 0; axis < 3; ++axis) {
        const auto range = [axis](const TriangleCorners& t) {
            return std::minmax({t[0][axis], t[1][axis], t[2][axis]});
        };
        const auto a = range(pair.a), b = range(pair.b);
        if (a.first > b.second || b.first > a.second) return false;
    }
    switch (kind) {
        case PairKind::rejected_by_plane:
            return rejected;
        case PairKind::nearly_coplanar_apart:
            return !triangles_overlap(pair.a, pair.b);
        case PairKind::apart_beyond_planes:
            return !rejected && !triangles_overlap(pair.a, pair.b);
        case PairKind::crossing:
            return triangles_overlap(pair.a, pair.b);
        default:
            return true;
    }
}

std::vector<CornerPair> corner_pairs(PairKind kind) {
    Random random(7);
    std::vector<CornerPair> pairs;
    while (pairs.size() < 1024) {
        const CornerPair pair = random_pair(random, kind);
        if (is_of_kind(pair, kind)) pairs.push_back(pair);
    }
    return pairs;
}

void per_pair(benchmark::State& state) {
    state.counters["time/pair"] = benchmark::Counter(
        1024, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void overlap_of(benchmark::State& state, PairKind kind) {
    const std::vector<CornerPair> pairs = corner_pairs(kind);
    for (auto _ : state)
        for (const CornerPair& pair : pairs)
            benchmark::DoNotOptimize(triangles_overlap(pair.a, pair.b));
    per_pair(state);
}
BENCHMARK_CAPTURE(overlap_of, rejected_by_plane, PairKind::rejected_by_plane);
BENCHMARK_CAPTURE(overlap_of, apart_beyond_planes, PairKind::apart_beyond_planes);
BENCHMARK_CAPTURE(overlap_of, crossing, PairKind::crossing);
BENCHMARK_CAPTURE(overlap_of, coplanar, PairKind::coplanar);
BENCHMARK_CAPTURE(overlap_of, nearly_coplanar, PairKind::nearly_coplanar);
BENCHMARK_CAPTURE(overlap_of, nearly_coplanar_apart, PairKind::nearly_coplanar_apart);
BENCHMARK_CAPTURE(overlap_of, common_edge, PairKind::common_edge);
BENCHMARK_CAPTURE(overlap_of, axis_plane, PairKind::axis_plane);

// The exact fallback of one determinant: with differences that are doubles, and without.
void orient3d_exact_of(benchmark::State& state, PairKind kind) {
    const std::vector<CornerPair> pairs = corner_pairs(kind);
    for (auto _ : state)
        for (const CornerPair& pair : pairs)
            benchmark::DoNotOptimize(orient3d_exact(pair.a[0], pair.a[1], pair.a[2], pair.b[0]));
    per_pair(state);
}
BENCHMARK_CAPTURE(orient3d_exact_of, few_digits, PairKind::coplanar);
BENCHMARK_CAPTURE(orient3d_exact_of, all_digits, PairKind::crossing_thirds);

void intersection_of(benchmark::State& state, PairKind kind) {
    const std::vector<CornerPair> pairs = corner_pairs(kind);
    for (auto _ : state)
        for (const CornerPair& pair : pairs)
            benchmark::DoNotOptimize(triangles_intersection(pair.a, pair.b));
    per_pair(state);
}
BENCHMARK_CAPTURE(intersection_of, crossing, PairKind::crossing);
BENCHMARK_CAPTURE(intersection_of, coplanar, PairKind::coplanar);

BENCHMARK(fit_scb_of)->RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(build<Scb>)->RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(build<Ball>)->RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(build<Obb>)->RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace scb

BENCHMARK_MAIN();
