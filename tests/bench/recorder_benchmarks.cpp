#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>

#include "scb/collide.h"
#include "scenes/scene/load_scene.h"
#define SCB_RECORD_ON
#include <scb_record.h>

// What it costs to record every test of a query: `horses`, frame 100, two slab cut balls a test.

namespace scb {
namespace {

scenes::Scene horses() {
    scenes::LoadOptions options;
    if (const char* models = std::getenv("SCB_MODELS")) options.models_dir = models;
    return scenes::load_scene({"horses"}, options);
}

struct Query {
    scenes::Scene scene = horses();
    Hierarchy<Scb> a = build_hierarchy<Scb>(scene.meshes[scene.bodies[0].mesh].mesh),
                   b = build_hierarchy<Scb>(scene.meshes[scene.bodies[1].mesh].mesh);
    Pose b_to_a = relative_pose(scenes::pose_at(scene.bodies[0].motion, 100),
                                scenes::pose_at(scene.bodies[1].motion, 100));

    template <class... Observer>
    Collision collide(Observer&... observer) const {
        return scb::collide(Collider<Scb>{a, scene.meshes[scene.bodies[0].mesh].mesh},
                            Collider<Scb>{b, scene.meshes[scene.bodies[1].mesh].mesh}, b_to_a, {},
                            observer...);
    }
};

const Query& query() {
    static const Query result;
    return result;
}

struct WritingObserver {
    scb_recorder* recorder;
    void volume_test(const Step& step) {
        scb_record_test(recorder, step.nodes.a, step.nodes.b,
                        static_cast<std::uint8_t>(step.stage));
    }
    void item_test(const ItemStep& test) {
        scb_record_items(recorder, test.items.a, test.items.b, test.hit);
    }
};

/// Counts, so that what is left between the two is the recorder.
struct CountingObserver {
    std::uint64_t tests = 0;
    void volume_test(const Step& step) {
        benchmark::DoNotOptimize(step.nodes);
        ++tests;
    }
    void item_test(const ItemStep& test) {
        benchmark::DoNotOptimize(test.items);
        ++tests;
    }
};

std::uint64_t tests_of_query() {
    CountingObserver counter;
    query().collide(counter);
    return counter.tests;
}

void unrecorded(benchmark::State& state) {
    CountingObserver counter;
    for (auto _ : state) query().collide(counter);
    state.SetItemsProcessed(static_cast<std::int64_t>(counter.tests));
}
BENCHMARK(unrecorded);

/// To a file in the folder for such, begun anew every 100 queries.
void recorded(benchmark::State& state) {
    const std::string path = std::filesystem::temp_directory_path() / "scb-recorder-benchmark";
    scb_recorder recorder;
    std::int64_t queries = 0;
    for (auto _ : state) {
        if (queries % 100 == 0) {
            state.PauseTiming();
            if (queries > 0) scb_record_close(&recorder);
            scb_record_open(&recorder, path.c_str(), "benchmark");
            state.ResumeTiming();
        }
        scb_record_query(&recorder, 0, 1);
        WritingObserver observer{&recorder};
        query().collide(observer);
        scb_record_query_end(&recorder, 1, 0);
        ++queries;
    }
    if (scb_record_close(&recorder) != 0) state.SkipWithError("nothing could be written");
    std::filesystem::remove(path);
    state.SetItemsProcessed(queries * static_cast<std::int64_t>(tests_of_query()));
}
BENCHMARK(recorded);

/// The events alone, to a file that takes nothing: the recorder without the system.
void events(benchmark::State& state) {
    scb_recorder recorder;
    scb_record_open(&recorder, "/dev/null", "benchmark");
    std::uint32_t node = 0;
    for (auto _ : state) {
        scb_record_test(&recorder, node, node + 1, 0);
        ++node;
    }
    scb_record_close(&recorder);
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(events);

}  // namespace
}  // namespace scb

BENCHMARK_MAIN();
