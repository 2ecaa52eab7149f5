#include <benchmark/benchmark.h>

#include <time.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>

#include "core/analysis/trace.h"
#include "core/hierarchy/fit_volumes.h"
#include "core/hierarchy/mesh_topology.h"
#include "render/draw/renderer.h"
#include "render/figures/pairs_figure.h"
#include "render/figures/rejections_figure.h"
#include "render/files/encode_queue.h"
#include "scenes/scene/builtin.h"

// Sequences of pictures as `scb render rejections` and `scb render pairs` draw them: spheres-l1 at
// 1280x720, every frame queried, drawn, encoded and written. Load, hierarchies, context and camera
// come before the clock starts.
//
// Counters, as shares of wall time: `query`, `prepare` (tree, front, panel, layout), `draw`
// (Renderer::draw, which waits for the OpenGL library's own threads) and `wait` (blocked in
// EncodeQueue, also at the end) are what the drawing thread did; they add up to 1. `cpu_encode`
// and `cpu_draw` are the processor time of all threads of the queue and of the OpenGL library, and
// `cpu` is the same of the process: 2 is two cores at work all the time. `peak20_MiB` and
// `peak_MiB` are the peaks of resident memory since the sequence began, after 20 pictures and after
// all. To have a peak without the sequences before, run one benchmark alone (--benchmark_filter).
namespace scb {
namespace {

namespace fs = std::filesystem;

constexpr int width = 1280, height = 720;

/// Two bodies of one scene with hierarchies of slab cut balls.
struct Spheres {
    scenes::Scene scene = scenes::load_builtin(*scenes::find_builtin("spheres-l1"));
    std::vector<AnyHierarchy> hierarchies;  ///< per mesh
    std::vector<Tree> trees;
    TraceHeader header;

    Spheres() {
        for (const scenes::NamedMesh& named : scene.meshes) {
            const auto topology = std::make_shared<const Topology>(build_topology(named.mesh));
            hierarchies.push_back(
                fit_any(VolumeKind::scb, topology, leaf_order(named.mesh, *topology)));
        }
        for (const AnyHierarchy& hierarchy : hierarchies) trees.emplace_back(hierarchy);
        header.scene = scene.name;
        for (std::size_t side = 0; side < 2; ++side)
            header.bodies[side].name = scene.bodies[side].name;
    }

    render::QueryBodies bodies(int frame, const std::vector<render::MeshHandle>& handles) const {
        render::QueryBodies bodies;
        std::uint32_t id = 1;
        for (std::size_t side = 0; side < 2; ++side) {
            const scenes::Body& body = scene.bodies[side];
            bodies[side] = {
                body.name,          &scene.meshes[body.mesh].mesh,       &trees[body.mesh],
                handles[body.mesh], scenes::pose_at(body.motion, frame), id};
            id += static_cast<std::uint32_t>(bodies[side].tree->size());
        }
        for (render::QueryBody& body : bodies) {
            body.first_triangle_id = id;
            id += static_cast<std::uint32_t>(body.mesh->triangles.size());
        }
        return bodies;
    }
};

void ask(const Spheres& spheres, const render::QueryBodies& bodies, const TraceHeader& header,
         int frame, QueryTrace& result) {
    const auto& [a, b] = std::pair(spheres.scene.bodies[0].mesh, spheres.scene.bodies[1].mesh);

    StepRecorder recorder{std::move(result.steps)};
    recorder.steps.volumes.clear();
    recorder.steps.items.clear();
    result.frame = frame;
    result.b_to_a = relative_pose(bodies[0].pose, bodies[1].pose);
    result.found = collide(spheres.hierarchies[a], *bodies[0].mesh, spheres.hierarchies[b],
                           *bodies[1].mesh, result.b_to_a, header.options, recorder);
    result.steps = std::move(recorder.steps);
}

enum class What { rejections, pairs };

void describe(render::SceneFigure& figure, What what, const render::QueryBodies& bodies,
              const TraceHeader& header, const QueryTrace& frame) {
    std::vector<render::Segment> contact = render::contact_segments(bodies, header, frame);
    if (what == What::pairs) {
        const render::PairsStyle style;
        figure.pane =
            render::pairs_pane(bodies, header, frame, std::move(contact), style, 1u << 30);
        figure.panel = render::pairs_panel(bodies, header, frame, style);
        return;
    }
    const render::RejectionsStyle style;
    const Outcomes outcomes = outcomes_of(header, frame);
    const render::EndedNodes ended = render::ended_nodes(bodies, frame, outcomes, style);
    figure.pane =
        render::rejections_pane(bodies, frame, outcomes, ended, std::move(contact), style);
    figure.panel = render::rejections_panel(bodies, header, frame, outcomes, ended, style);
    figure.chart = render::endings_chart(header, frame, outcomes, style);
}

/// The upper levels of both bodies at all of these frames, which the camera has to hold.
std::vector<AnyVolume> held_volumes(const Spheres& spheres, const std::vector<int>& frames) {
    const std::vector<render::MeshHandle> none(spheres.scene.meshes.size());
    std::vector<AnyVolume> volumes;
    for (const int frame : frames)
        for (const render::QueryBody& body : spheres.bodies(frame, none)) {
            const std::vector<std::uint32_t>& depths = body.tree->shape().depths;
            for (std::uint32_t node = 0; node < depths.size(); ++node)
                if (depths[node] <= 6) volumes.push_back(render::volume_of(body, node));
        }
    return volumes;
}

/// Wall time by what it went into; each moment belongs to one of these.
enum Part : std::size_t { query, prepare, draw, wait, parts };

class PartClock {
  public:
    /// The time since the last call went into this.
    void add(Part part) {
        const Clock::time_point now = Clock::now();
        spent_[part] += now - last_;
        last_ = now;
    }
    double of(Part part) const { return std::chrono::duration<double>(spent_[part]).count(); }
    double all() const {
        double sum = 0;
        for (std::size_t part = 0; part < parts; ++part) sum += of(static_cast<Part>(part));
        return sum;
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
    std::array<Clock::duration, parts> spent_{};
};

double seconds_of(clockid_t clock) {
    timespec time{};
    ::clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Processor time in seconds, by the threads' names. Threads of the OpenGL library have names of
/// its own. Threads of an EncodeQueue have the name of the process.
struct ProcessorTime {
    double all = 0, encode = 0, draw = 0;

    static ProcessorTime now() {
        ProcessorTime time;
        time.all = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
        const std::string main = std::to_string(::getpid());
        const std::string name = first_line("/proc/self/comm");
        for (const auto& task : fs::directory_iterator("/proc/self/task")) {
            if (task.path().filename() == main) continue;
            // Nanoseconds on a processor come first.
            const double seconds =
                1e-9 * std::strtod(first_line(task.path() / "schedstat").c_str(), nullptr);
            (first_line(task.path() / "comm") == name ? time.encode : time.draw) += seconds;
        }
        return time;
    }
    static std::string first_line(const fs::path& path) {
        std::string line;
        std::getline(std::ifstream(path), line);
        return line;
    }
};

/// The peak of resident memory, in MiB.
double peak_memory() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::strtod(line.c_str() + 6, nullptr) / 1024;
    return 0;
}

void forget_peak_memory() { std::ofstream("/proc/self/clear_refs") << 5; }

void sequence(benchmark::State& state, What what) {
    const Spheres spheres;
    const auto count = static_cast<int>(state.range(0));
    std::vector<int> frames;
    for (int i = 0; i < count; ++i) frames.push_back(i * spheres.scene.frames / count);
    const fs::path folder =
        fs::temp_directory_path() / ("scb_sequence_" + std::to_string(::getpid()));
    fs::create_directories(folder);
    forget_peak_memory();

    const render::Context context(render::GlBackend::osmesa);
    render::Renderer renderer(context);
    std::vector<render::MeshHandle> handles;
    for (const scenes::NamedMesh& named : spheres.scene.meshes)
        handles.push_back(renderer.upload(named.mesh));
    const std::vector<AnyVolume> held = held_volumes(spheres, frames);
    const render::Support support = render::support_of(held);
    const scenes::CameraView wish = spheres.scene.camera.value_or(scenes::CameraView{});
    render::CameraFit fit;
    fit.aspect = render::aspect_of(render::figure_layout(width, height).view);
    fit.vertical_fov = wish.field_of_view;
    const render::Camera camera =
        render::fit_camera(render::orbit_axes(wish.azimuth, wish.elevation), support, fit);
    const Vec3 center = render::center_of(support);

    for (auto _ : state) {
        // As many as `scb render` has of both.
        render::EncodeQueue queue(8, std::max(1u, std::thread::hardware_concurrency()));
        render::Overlay overlay;
        QueryTrace frame;
        double peak_after_20 = 0;
        int drawn = 0;
        const ProcessorTime before = ProcessorTime::now();
        PartClock clock;
        for (const int number : frames) {
            const render::QueryBodies bodies = spheres.bodies(number, handles);
            ask(spheres, bodies, spheres.header, number, frame);
            clock.add(query);
            render::SceneFigure figure;
            figure.title = "spheres-l1 · SCB";
            figure.subtitle = "frame " + std::to_string(number);
            describe(figure, what, bodies, spheres.header, frame);
            figure.pane.camera = camera;
            figure.center = center;
            const render::Picture picture = render::compose(
                std::move(figure), width, height, static_cast<int>(state.range(1)), overlay);
            clock.add(prepare);
            render::Rendering rendering = renderer.draw(picture, &overlay);
            clock.add(draw);
            queue.push(folder / (std::to_string(number) + ".png"), std::move(rendering.image));
            clock.add(wait);
            if (++drawn == 20) peak_after_20 = peak_memory();
        }
        queue.finish();
        clock.add(wait);
        const ProcessorTime after = ProcessorTime::now();
        const double wall = clock.all();
        state.counters["fps"] = count / wall;
        state.counters["query"] = clock.of(query) / wall;
        state.counters["prepare"] = clock.of(prepare) / wall;
        state.counters["draw"] = clock.of(draw) / wall;
        state.counters["wait"] = clock.of(wait) / wall;
        state.counters["cpu"] = (after.all - before.all) / wall;
        state.counters["cpu_draw"] = (after.draw - before.draw) / wall;
        state.counters["cpu_encode"] = (after.encode - before.encode) / wall;
        state.counters["peak20_MiB"] = peak_after_20;
        state.counters["peak_MiB"] = peak_memory();
    }
    fs::remove_all(folder);
}

void rejections(benchmark::State& state) { sequence(state, What::rejections); }
void pairs(benchmark::State& state) { sequence(state, What::pairs); }

// Frames evenly from the scene's 500.
void sequences(benchmark::internal::Benchmark* benchmark) {
    benchmark->ArgNames({"frames", "samples"})
        ->ArgsProduct({{50, 500}, {1, 4}})
        ->Iterations(1)
        ->Unit(benchmark::kSecond)
        ->UseRealTime();
}
BENCHMARK(rejections)->Apply(sequences);
BENCHMARK(pairs)->Apply(sequences);

}  // namespace
}  // namespace scb

BENCHMARK_MAIN();
