#include "app/python/binding/collide.h"

#include <pybind11/stl.h>

#include "app/python/binding/collide_options.h"

namespace scb::python {
namespace {

FoundPairs collide_once(const BuiltHierarchy& a, const BuiltHierarchy& b, const py::object& pose,
                        const CollideArguments& asked) {
    const Pose b_to_a = pose_of(pose, "pose");
    const CollideOptions options = asked.options(a, b);
    Collision found;
    {
        const py::gil_scoped_release unlocked;
        found = collide(a.hierarchy, *a.mesh, b.hierarchy, *b.mesh, b_to_a, options);
    }
    return found_pairs(std::move(found), a.kind, options.overlap);
}

}  // namespace

std::vector<Stage> endings_of(VolumeKind kind, const OverlapOptions& options) {
    std::vector<Stage> endings = {Stage::overlapping};
    for (const Stage stage : stages_of(kind, options)) endings.push_back(stage);
    return endings;
}

FoundPairs found_pairs(Collision&& found, VolumeKind kind, const OverlapOptions& options) {
    static_assert(sizeof(IndexPair) == 8);
    FoundPairs result;
    result.n_v = found.n_v;
    result.n_p = found.n_p;
    result.n_u = found.n_u;
    for (const Stage stage : endings_of(kind, options))
        result.stages[py::str(std::string(stage_name(stage)))] =
            found.stages[static_cast<std::size_t>(stage)];
    result.depth = found.depth;
    result.complete = found.complete;
    result.pairs = array_of<std::uint32_t>(std::move(found.pairs), 2);
    return result;
}

void add_collide(py::module_& module) {
    py::class_<FoundPairs>(module, "Collision", py::is_final(), "What a query found.")
        .def_readonly(
            "pairs", &FoundPairs::pairs,
            R"(n x 2 uint32, sorted, each once: triangles of a and b that intersect, as row numbers of
mesh.triangles; with stop_level the nodes that overlap. Read-only, without a copy.)")
        .def_readonly("n_v", &FoundPairs::n_v, "Tests of two volumes.")
        .def_readonly("n_p", &FoundPairs::n_p, "Tests of two triangles.")
        .def_readonly("n_u", &FoundPairs::n_u,
                      "Points and directions of volumes of b that were transformed for the tests.")
        .def_readonly(
            "stages", &FoundPairs::stages,
            R"(Volume tests by how they ended: "overlapping", or the stage that rejected.)")
        .def_readonly("depth", &FoundPairs::depth,
                      "Of the deepest volume test: the depths of both nodes added.")
        .def_readonly("complete", &FoundPairs::complete,
                      "False where max_pairs ended the query: there may be more pairs.")
        .def("__repr__", [](const FoundPairs& f) {
            return "<scb.Collision: " + std::to_string(f.pairs.shape(0)) +
                   " pairs, N_v = " + std::to_string(f.n_v) + ", N_p = " + std::to_string(f.n_p) +
                   ">";
        });
    module.def(
        "collide",
        [](const BuiltHierarchy& a, const BuiltHierarchy& b, const py::object& pose,
           const std::string& test, double threshold, const std::string& descent,
           std::optional<std::int64_t> max_pairs, std::optional<std::int64_t> stop_level) {
            return collide_once(a, b, pose, {test, threshold, descent, max_pairs, stop_level});
        },
        py::arg("a"), py::arg("b"), py::arg("pose") = py::none(), py::kw_only(),
        py::arg("test") = "symmetric", py::arg("threshold") = 0.7, py::arg("descent") = "radius",
        py::arg("max_pairs") = py::none(), py::arg("stop_level") = py::none(),
        R"(Find the pairs of triangles of a and b that intersect.

pose: 4 x 4 or 3 x 4, from b's frame to a's; None is the identity. Triangles that touch intersect, and the test
of two triangles is exact. test, threshold: the overlap test for slab cut balls. descent: which of two
nodes is divided, by "radius", "area", "volume" or "alternating". max_pairs: the query ends once it has
so many; None means 100,000,000. stop_level: nodes at this depth count as leaves, and no triangles are tested.

Runs in one thread, without the interpreter's lock. Raises InputError where the pose is not rigid, or
the volumes of a and b are not of one kind.)");
}

}  // namespace scb::python
