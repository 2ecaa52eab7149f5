#include <benchmark/benchmark.h>

#include <array>
#include <memory>

#include "core/collide/query_placement.h"
#include "core/explain/exact_overlap.h"
#include "core/overlap/test_functors.h"
#include "core/volumes/any_volume.h"
#include "scb/collide.h"
#include "scenes/scene/load_scene.h"

namespace scb {
namespace {

constexpr int frames[] = {50, 150, 240, 250, 300};

/// Keeps the nodes of every volume test.
struct PairRecorder {
    std::vector<IndexPair> pairs;
    void volume_test(const Step& step) { pairs.push_back(step.nodes); }
    void item_test(const ItemStep&) {}
};

/// The volume tests that a query makes in five frames of spheres-l1, in their order.
template <Volume V>
struct Recorded {
    std::vector<Hierarchy<V>> hierarchies;
    struct Frame {
        Pose b_to_a;
        Placement placement;
        std::vector<IndexPair> pairs;
    };
    std::vector<Frame> list;
};

template <Volume V>
const Recorded<V>& recorded() {
    static const Recorded<V> result = [] {
        const scenes::Scene scene = scenes::load_scene({"spheres-l1"});
        Recorded<V> r;
        for (const scenes::NamedMesh& mesh : scene.meshes)
            r.hierarchies.push_back(build_hierarchy<V>(mesh.mesh));
        for (const int frame : frames) {
            const Pose pose = relative_pose(scenes::pose_at(scene.bodies[0].motion, frame),
                                            scenes::pose_at(scene.bodies[1].motion, frame));
            const Collider<V> a{r.hierarchies[0], scene.meshes[0].mesh},
                b{r.hierarchies[1], scene.meshes[1].mesh};
            PairRecorder recorder;
            collide(a, b, pose, {}, recorder);
            r.list.push_back(
                {pose, query_placement(a.hierarchy, b.hierarchy, pose), recorder.pairs});
        }
        return r;
    }();
    return result;
}

/// Nanoseconds per test over the recorded pairs. So the mix of outcomes and branches is the mix in
/// a query. All tests of slab cut balls see the same pairs.
template <Volume V, class Test>
void volume_tests(benchmark::State& state, const Test& test) {
    const Recorded<V>& r = recorded<V>();
    std::size_t tests = 0;
    StageCounts stages{};
    for (auto _ : state)
        for (const auto& frame : r.list) {
            for (const IndexPair& pair : frame.pairs)
                ++stages[static_cast<std::size_t>(test(r.hierarchies[0].volumes[pair.a],
                                                       r.hierarchies[1].volumes[pair.b],
                                                       frame.placement))];
            tests += frame.pairs.size();
        }
    benchmark::DoNotOptimize(stages);
    state.counters["per_test"] = benchmark::Counter(
        static_cast<double>(tests), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// The same of the exact test, which proves each verdict; with B's volume carried into A's frame.
template <Volume V>
void exact_verdicts(benchmark::State& state) {
    const Recorded<V>& r = recorded<V>();
    std::size_t tests = 0;
    std::array<std::uint64_t, 3> verdicts{};
    for (auto _ : state)
        for (const auto& frame : r.list) {
            for (const IndexPair& pair : frame.pairs)
                ++verdicts[static_cast<std::size_t>(
                    exact_overlap(r.hierarchies[0].volumes[pair.a],
                                  placed(r.hierarchies[1].volumes[pair.b], frame.b_to_a))
                        .contact)];
            tests += frame.pairs.size();
        }
    benchmark::DoNotOptimize(verdicts);
    state.counters["per_test"] = benchmark::Counter(
        static_cast<double>(tests), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void printed(benchmark::State& state) {
    volume_tests<Scb>(state, ScbTest<OverlapTest::printed>{0.7});
}
void corrected(benchmark::State& state) {
    volume_tests<Scb>(state, ScbTest<OverlapTest::corrected>{0.7});
}
void symmetric(benchmark::State& state) {
    volume_tests<Scb>(state, ScbTest<OverlapTest::symmetric>{0.7});
}
void extents(benchmark::State& state) {
    volume_tests<Scb>(state, ScbTest<OverlapTest::extents>{0.7});
}
void ball(benchmark::State& state) { volume_tests<Ball>(state, BallTest{}); }
void obb(benchmark::State& state) { volume_tests<Obb>(state, ObbTest{}); }
void exact_scb(benchmark::State& state) { exact_verdicts<Scb>(state); }
void exact_ball(benchmark::State& state) { exact_verdicts<Ball>(state); }
void exact_obb(benchmark::State& state) { exact_verdicts<Obb>(state); }

BENCHMARK(printed);
BENCHMARK(corrected);
BENCHMARK(symmetric);
BENCHMARK(extents);
BENCHMARK(ball);
BENCHMARK(obb);
BENCHMARK(exact_scb);
BENCHMARK(exact_ball);
BENCHMARK(exact_obb);

}  // namespace
}  // namespace scb

BENCHMARK_MAIN();
