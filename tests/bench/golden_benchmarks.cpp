#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "core/platform/output_file.h"
#include "golden/compare/id_difference.h"
#include "golden/compare/image_difference.h"
#include "golden/suite/file_replacement.h"
#include "render/draw/renderer.h"
#include "render/files/image_file.h"
#include "render/view/fit_camera.h"
#include "render/view/palette.h"
#include "scb/hierarchy.h"
#include "scenes/shapes/procedural.h"
#include "tests/temporary_folder.h"

// Pairs of pictures of 512x512 as `scb golden check` compares them, on one core: a level of a
// sphere's hierarchy of slab cut balls, 512 volumes at one sample, and its ids. `pairs/s` is what
// counts; the goal is 200 for comparing alone. The kinds of pairs: 0 is equal, 1 has one volume of
// the second picture missing, 2 differs everywhere (another view).
namespace scb {
namespace {

enum Kind : std::int64_t { equal, one_missing, all_different };

render::Rendering draw(Kind kind) {
    const Hierarchy<Scb> hierarchy = build_hierarchy<Scb>(scenes::icosphere(6, 1));
    const std::vector<std::uint16_t> depths = node_depths(*hierarchy.topology);
    std::vector<AnyVolume> volumes;
    render::Pane pane;
    for (std::uint32_t i = 0; i < depths.size(); ++i) {
        if (depths[i] != 9) continue;
        volumes.push_back(hierarchy.volumes[i]);
        pane.volumes.push_back({hierarchy.volumes[i], render::category_color(i), i + 1});
    }
    pane.camera = render::fit_camera(
        kind == all_different ? render::orbit_axes(120, -35) : render::orbit_axes(30, 20),
        render::support_of(volumes), {});
    // The one whose center is nearest to the eye is seen whole.
    if (kind == one_missing) {
        const Vec3 eye = pane.camera.position;
        const auto distance = [&](const render::VolumeInstance& one) {
            return (std::get<Scb>(one.volume).c - eye).norm();
        };
        pane.volumes.erase(std::min_element(
            pane.volumes.begin(), pane.volumes.end(),
            [&](const auto& a, const auto& b) { return distance(a) < distance(b); }));
    }
    render::Picture picture;
    picture.width = picture.height = 512;
    picture.samples = 1;
    if (kind == all_different) picture.background = {250, 250, 250};
    pane.viewport = {0, 0, picture.width, picture.height};
    picture.panes.push_back(std::move(pane));
    const render::Context context(render::GlBackend::osmesa);
    return render::Renderer(context).draw(picture, nullptr, true);
}

/// A picture and another as files, and decoded.
struct Pair {
    render::Rendering a, b;
    TemporaryFolder folder;

    explicit Pair(const benchmark::State& state)
        : a(draw(equal)), b(draw(static_cast<Kind>(state.range(0)))) {
        write_file_whole(folder / "a.png", render::encode_png(a.image));
        write_file_whole(folder / "b.png", render::encode_png(b.image));
        write_file_whole(folder / "a.ids.png", render::encode_png(*a.ids));
        write_file_whole(folder / "b.ids.png", render::encode_png(*b.ids));
    }
};

void finish(benchmark::State& state, std::size_t pixels) {
    state.counters["pairs/s"] =
        benchmark::Counter(1, benchmark::Counter::kIsIterationInvariantRate);
    state.counters["pixels"] = static_cast<double>(pixels);
}

void compare_colors(benchmark::State& state) {
    const Pair pair(state);
    golden::ImageDifference difference;
    for (auto _ : state)
        benchmark::DoNotOptimize(difference = golden::image_difference(pair.a.image, pair.b.image));
    finish(state, difference.pixels);
}

void compare_ids(benchmark::State& state) {
    const Pair pair(state);
    golden::IdDifference difference;
    for (auto _ : state)
        benchmark::DoNotOptimize(difference = golden::id_difference(*pair.a.ids, *pair.b.ids));
    finish(state, difference.pixels);
    state.counters["things"] = static_cast<double>(difference.changes.size());
}

void read_and_compare_colors(benchmark::State& state) {
    const Pair pair(state);
    const std::string a = pair.folder / "a.png", b = pair.folder / "b.png";
    std::size_t pixels = 0;
    for (auto _ : state)
        pixels = golden::image_difference(render::read_png(a), render::read_png(b)).pixels;
    finish(state, pixels);
}

void read_and_compare_ids(benchmark::State& state) {
    const Pair pair(state);
    const std::string a = pair.folder / "a.ids.png", b = pair.folder / "b.ids.png";
    std::size_t pixels = 0;
    for (auto _ : state)
        pixels = golden::id_difference(render::unpack_ids(render::read_png(a)),
                                       render::unpack_ids(render::read_png(b)))
                     .pixels;
    finish(state, pixels);
}

void compare_files(benchmark::State& state) {
    const Pair pair(state);
    const std::string a = pair.folder / "a.png", b = pair.folder / "b.png";
    for (auto _ : state) benchmark::DoNotOptimize(golden::files_equal(a, b));
    finish(state, 0);
    state.counters["bytes"] = static_cast<double>(std::filesystem::file_size(a));
}

void draw_the_difference(benchmark::State& state) {
    const Pair pair(state);
    for (auto _ : state)
        benchmark::DoNotOptimize(golden::difference_picture(pair.a.image, pair.b.image));
    finish(state, 0);
}

#define SCB_PAIR_BENCHMARK(name)           \
    BENCHMARK(name)                        \
        ->ArgName("kind")                  \
        ->DenseRange(equal, all_different) \
        ->Unit(benchmark::kMicrosecond)
SCB_PAIR_BENCHMARK(compare_colors);
SCB_PAIR_BENCHMARK(compare_ids);
SCB_PAIR_BENCHMARK(read_and_compare_colors);
SCB_PAIR_BENCHMARK(read_and_compare_ids);
SCB_PAIR_BENCHMARK(compare_files);
SCB_PAIR_BENCHMARK(draw_the_difference);
#undef SCB_PAIR_BENCHMARK

}  // namespace
}  // namespace scb

BENCHMARK_MAIN();
