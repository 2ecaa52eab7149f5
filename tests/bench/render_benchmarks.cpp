#include <benchmark/benchmark.h>

#include "render/draw/renderer.h"
#include "render/files/image_file.h"
#include "render/view/fit_camera.h"
#include "render/view/palette.h"
#include "scb/hierarchy.h"
#include "scenes/shapes/procedural.h"

namespace scb {
namespace {

// The nodes of one level of a sphere's hierarchy, seen whole at 1280x720.
render::Picture level_of_a_sphere(int level, int samples) {
    const Hierarchy<Scb> hierarchy = build_hierarchy<Scb>(scenes::icosphere(6, 1));
    const std::vector<std::uint16_t> depths = node_depths(*hierarchy.topology);
    std::vector<AnyVolume> volumes;
    render::Pane pane;
    for (std::uint32_t i = 0; i < depths.size(); ++i) {
        if (depths[i] != level) continue;
        volumes.push_back(hierarchy.volumes[i]);
        pane.volumes.push_back({hierarchy.volumes[i], render::body_a_color, i + 1});
    }
    render::Picture picture;
    picture.samples = samples;
    pane.viewport = {0, 0, picture.width, picture.height};
    pane.camera = render::fit_camera(render::orbit_axes(30, 20), render::support_of(volumes), {});
    picture.panes.push_back(std::move(pane));
    return picture;
}

void draw_level(benchmark::State& state) {
    const render::Picture picture =
        level_of_a_sphere(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    const render::Context context(render::GlBackend::osmesa);
    render::Renderer renderer(context);
    for (auto _ : state) benchmark::DoNotOptimize(renderer.draw(picture));
    state.counters["volumes"] = static_cast<double>(picture.panes[0].volumes.size());
}
BENCHMARK(draw_level)
    ->ArgNames({"level", "samples"})
    ->ArgsProduct({{5, 9, 12, 15}, {1, 4}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void encode_level(benchmark::State& state) {
    const render::Context context(render::GlBackend::osmesa);
    render::Renderer renderer(context);
    const render::Image image =
        renderer.draw(level_of_a_sphere(static_cast<int>(state.range(0)), 4)).image;
    std::size_t bytes = 0;
    for (auto _ : state) bytes = render::encode_png(image).size();
    state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(encode_level)->ArgName("level")->Arg(5)->Arg(9)->Arg(15)->Unit(benchmark::kMillisecond);

void make_context(benchmark::State& state) {
    for (auto _ : state) render::Context context(render::GlBackend::osmesa);
}
BENCHMARK(make_context)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace scb

BENCHMARK_MAIN();
