#include "app/python/binding/collide_poses.h"

#include <pybind11/stl.h>

#include "app/python/binding/collide.h"
#include "app/python/binding/collide_options.h"
#include "app/python/binding/signals.h"
#include "app/python/binding/source.h"
#include "core/base/parallel_for.h"

namespace scb::python {
namespace {

/// Results of queries at several poses: a row per pose.
struct FoundAtPoses : PairsAtPoses {
    py::array n_v, n_p, n_u, depth, complete, stages;
    std::vector<std::string> stage_names;
};

/// The same under construction, by several threads.
struct Rows {
    std::vector<std::uint64_t> n_v, n_p, n_u, stages;
    std::vector<std::int32_t> depth;
    std::vector<std::uint8_t> complete;
    std::vector<std::vector<IndexPair>> pairs;

    Rows(std::size_t poses, std::size_t endings)
        : n_v(poses),
          n_p(poses),
          n_u(poses),
          stages(poses * endings),
          depth(poses),
          complete(poses),
          pairs(poses) {}

    void set(std::size_t i, Collision&& found, const std::vector<Stage>& endings) {
        n_v[i] = found.n_v;
        n_p[i] = found.n_p;
        n_u[i] = found.n_u;
        depth[i] = found.depth;
        complete[i] = found.complete;
        for (std::size_t k = 0; k < endings.size(); ++k)
            stages[i * endings.size() + k] = found.stages[static_cast<std::size_t>(endings[k])];
        pairs[i] = std::move(found.pairs);
    }
};

FoundAtPoses collide_poses(const BuiltHierarchy& a, const BuiltHierarchy& b,
                           const py::object& matrices, std::int64_t thread_count,
                           const CollideArguments& asked) {
    const std::vector<Pose> poses = poses_of(matrices, "poses");
    const CollideOptions options = asked.options(a, b);
    const std::vector<Stage> endings = endings_of(a.kind, options.overlap);
    const int threads = threads_of(thread_count);
    Rows rows(poses.size(), endings.size());
    {
        const py::gil_scoped_release unlocked;
        SignalWatch watch;
        parallel_for(threads, poses.size(), [&](std::size_t i) {
            if (watch.stopped()) return;
            rows.set(i, collide(a.hierarchy, *a.mesh, b.hierarchy, *b.mesh, poses[i], options),
                     endings);
        });
        watch.rethrow();
    }
    FoundAtPoses result;
    result.set(std::move(rows.pairs));
    for (const Stage stage : endings) result.stage_names.emplace_back(stage_name(stage));
    result.n_v = array_of<std::uint64_t>(std::move(rows.n_v));
    result.n_p = array_of<std::uint64_t>(std::move(rows.n_p));
    result.n_u = array_of<std::uint64_t>(std::move(rows.n_u));
    result.depth = array_of<std::int32_t>(std::move(rows.depth));
    result.complete = array_of<bool>(std::move(rows.complete));
    result.stages =
        array_of<std::uint64_t>(std::move(rows.stages), static_cast<py::ssize_t>(endings.size()));
    return result;
}

}  // namespace

void PairsAtPoses::set(std::vector<std::vector<IndexPair>>&& of_poses) {
    std::vector<std::int64_t> begins = {0};
    std::vector<IndexPair> all;
    {
        const py::gil_scoped_release unlocked;
        for (const auto& each : of_poses)
            begins.push_back(begins.back() + static_cast<std::int64_t>(each.size()));
        all.reserve(static_cast<std::size_t>(begins.back()));
        for (auto& each : of_poses) {
            all.insert(all.end(), each.begin(), each.end());
            std::vector<IndexPair>().swap(each);  // frees memory early
        }
    }
    pairs = array_of<std::uint32_t>(std::move(all), 2);
    offsets = array_of<std::int64_t>(std::move(begins));
}

py::array PairsAtPoses::pairs_of(std::int64_t index) const {
    const py::ssize_t count = size();
    if (index < -count || index >= count)
        throw py::index_error("there is no pose " + std::to_string(index) + " of " +
                              std::to_string(count) + ".");
    const auto* begins = static_cast<const std::int64_t*>(offsets.data());
    const py::ssize_t i = index < 0 ? index + count : index;
    return pairs[py::slice(begins[i], begins[i + 1], 1)].cast<py::array>();
}

void add_collide_poses(py::module_& module) {
    py::class_<FoundAtPoses>(module, "Collisions", py::is_final(),
                             "What queries at n poses found. Arrays have a row per pose.")
        .def_readonly("n_v", &FoundAtPoses::n_v, "n uint64: tests of two volumes.")
        .def_readonly("n_p", &FoundAtPoses::n_p, "n uint64: tests of two triangles.")
        .def_readonly("n_u", &FoundAtPoses::n_u, "n uint64: points and directions transformed.")
        .def_readonly("depth", &FoundAtPoses::depth, "n int32: see Collision.depth.")
        .def_readonly("complete", &FoundAtPoses::complete, "n bool: see Collision.complete.")
        .def_readonly("stages", &FoundAtPoses::stages,
                      "n x k uint64: volume tests by how they ended; stage_names has the columns.")
        .def_readonly("stage_names", &FoundAtPoses::stage_names,
                      R"(k names: "overlapping", then the stages that reject.)")
        .def_readonly("pairs", &FoundAtPoses::pairs,
                      "m x 2 uint32: the pairs of all poses, pose after pose.")
        .def_readonly("offsets", &FoundAtPoses::offsets,
                      "n + 1 int64: the pairs of pose i are pairs[offsets[i]:offsets[i + 1]].")
        .def("pairs_of", &FoundAtPoses::pairs_of, py::arg("index"),
             "The pairs of one pose, without a copy. Raises IndexError.")
        .def("__len__", &FoundAtPoses::size)
        .def("__repr__", [](const FoundAtPoses& f) {
            return "<scb.Collisions: " + std::to_string(f.size()) + " poses, " +
                   std::to_string(f.pairs.shape(0)) + " pairs>";
        });
    module.def(
        "collide_poses",
        [](const BuiltHierarchy& a, const BuiltHierarchy& b, const py::object& poses,
           std::int64_t threads, const std::string& test, double threshold,
           const std::string& descent, std::optional<std::int64_t> max_pairs,
           std::optional<std::int64_t> stop_level) {
            return collide_poses(a, b, poses, threads,
                                 {test, threshold, descent, max_pairs, stop_level});
        },
        py::arg("a"), py::arg("b"), py::arg("poses"), py::kw_only(), py::arg("threads") = 0,
        py::arg("test") = "symmetric", py::arg("threshold") = 0.7, py::arg("descent") = "radius",
        py::arg("max_pairs") = py::none(), py::arg("stop_level") = py::none(),
        R"(collide at n poses, in threads, without the interpreter's lock.

poses: n x 4 x 4 or n x 3 x 4, from b's frame to a's. threads: how many share the poses, 0 for one per processor;
the result is the same for any number. max_pairs is of each pose. Ctrl-C ends it between two poses.

Raises InputError as collide does, before the first query; the sentence names the first bad pose.)");
}

}  // namespace scb::python
