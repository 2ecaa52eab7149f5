#include "app/python/binding/distance.h"

#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "app/python/binding/arrays.h"
#include "app/python/binding/hierarchy.h"
#include "app/python/binding/packed.h"
#include "app/python/binding/signals.h"
#include "app/python/binding/source.h"
#include "app/study/query_timing.h"
#include "core/base/parallel_for.h"
#include "core/base/text_format.h"
#include "scb/any_distance.h"

namespace scb::python {
namespace {

/// The distance at one pose, for Python.
struct FoundDistance {
    double distance = 0;
    std::optional<std::array<std::uint32_t, 2>> triangles;
    py::object points = py::none();
    std::uint64_t n_v = 0, n_p = 0;
    std::optional<std::uint64_t> n_u;
    std::optional<py::dict> stages;
};

/// The distances at several poses: a row per pose.
struct FoundDistances {
    py::array distance, triangles, points, n_v, n_p;
};

double length_of(const char* name, double value) {
    if (std::isnan(value) || value < 0) refuse(name, "give 0 or more.");
    return value;
}

Distance nearest(const BuiltHierarchy& a, const BuiltHierarchy& b, const Pose& b_to_a,
                 const DistanceOptions& options) {
    return distance(a.hierarchy, *a.mesh, b.hierarchy, *b.mesh, b_to_a, options);
}
Distance nearest(const BuiltPacked& a, const BuiltPacked& b, const Pose& b_to_a,
                 const DistanceOptions& options) {
    return app::distance_of(distance_packed(a.packed, *a.mesh, b.packed, *b.mesh, b_to_a, options));
}

std::vector<IndexPair> pairs_within(const BuiltHierarchy& a, const BuiltHierarchy& b,
                                    const Pose& b_to_a, double tolerance) {
    return within(a.hierarchy, *a.mesh, b.hierarchy, *b.mesh, b_to_a, tolerance).pairs;
}
std::vector<IndexPair> pairs_within(const BuiltPacked& a, const BuiltPacked& b, const Pose& b_to_a,
                                    double tolerance) {
    return within_packed(a.packed, *a.mesh, b.packed, *b.mesh, b_to_a, tolerance).pairs;
}

/// N_u and stages, which packed queries do not count.
void add_counts(FoundDistance& result, const Distance& found, const BuiltHierarchy& side) {
    result.n_u = found.n_u;
    result.stages = py::dict();
    (*result.stages)["near"] = found.stages[static_cast<std::size_t>(Stage::overlapping)];
    for (const Stage stage : distance_stages(side.kind))
        (*result.stages)[py::str(std::string(stage_name(stage)))] =
            found.stages[static_cast<std::size_t>(stage)];
}
void add_counts(FoundDistance&, const Distance&, const BuiltPacked&) {}

template <class Side>
void check_alike(const Side& a, const Side& b) {
    if (a.kind != b.kind)
        refuse("a and b", "they have different volumes; build both with the same.");
}

/// The options of a query, from Python's arguments.
template <class Side>
DistanceOptions options_of(const Side& a, const Side& b, const std::string& order, double limit,
                           double relative_error) {
    check_alike(a, b);
    DistanceOptions options;
    const std::optional<DistanceOrder> named = distance_order_of(order);
    if (!named) refuse("order", "\"" + order + "\" is none; give nearest, depth-first or hybrid.");
    options.order = *named;
    options.limit = length_of("limit", limit);
    options.relative_error = length_of("relative_error", relative_error);
    if (std::isinf(options.relative_error)) refuse("relative_error", "give a finite number.");
    return options;
}

std::vector<double> coordinates(const TriangleDistance& found) {
    std::vector<double> numbers;
    for (const Vec3& p : {found.point_a, found.point_b})
        numbers.insert(numbers.end(), {p[0], p[1], p[2]});
    return numbers;
}

template <class Side>
FoundDistance distance_once(const Side& a, const Side& b, const py::object& pose,
                            const std::string& order, double limit, double relative_error,
                            const std::optional<std::array<std::uint32_t, 2>>& seed) {
    const Pose b_to_a = pose_of(pose, "pose");
    DistanceOptions options = options_of(a, b, order, limit, relative_error);
    if (seed) {
        if ((*seed)[0] >= a.mesh->triangles.size() || (*seed)[1] >= b.mesh->triangles.size())
            refuse("seed", "a mesh has no such triangle; give a triangle of a and one of b.");
        options.seed = IndexPair{(*seed)[0], (*seed)[1]};
    }
    Distance found;
    {
        const py::gil_scoped_release unlocked;
        found = nearest(a, b, b_to_a, options);
    }
    FoundDistance result;
    result.distance = found.found.distance;
    if (found.triangles) {
        result.triangles = {found.triangles->a, found.triangles->b};
        result.points = array_of<double>(coordinates(found.found), 3);
    }
    result.n_v = found.n_v;
    result.n_p = found.n_p;
    add_counts(result, found, a);
    return result;
}

template <class Side>
FoundDistances distance_poses(const Side& a, const Side& b, const py::object& matrices,
                              std::int64_t thread_count, const std::string& order, double limit,
                              double relative_error) {
    const std::vector<Pose> poses = poses_of(matrices, "poses");
    const DistanceOptions options = options_of(a, b, order, limit, relative_error);
    const int threads = threads_of(thread_count);
    std::vector<double> distances(poses.size()),
        points(6 * poses.size(), std::numeric_limits<double>::quiet_NaN());
    std::vector<std::int64_t> triangles(2 * poses.size(), -1);
    std::vector<std::uint64_t> n_v(poses.size()), n_p(poses.size());
    {
        const py::gil_scoped_release unlocked;
        SignalWatch watch;
        parallel_for(threads, poses.size(), [&](std::size_t i) {
            if (watch.stopped()) return;
            const Distance found = nearest(a, b, poses[i], options);
            distances[i] = found.found.distance;
            n_v[i] = found.n_v;
            n_p[i] = found.n_p;
            if (!found.triangles) return;
            triangles[2 * i] = found.triangles->a;
            triangles[2 * i + 1] = found.triangles->b;
            const std::vector<double> numbers = coordinates(found.found);
            std::copy(numbers.begin(), numbers.end(),
                      points.begin() + 6 * static_cast<std::ptrdiff_t>(i));
        });
        watch.rethrow();
    }
    FoundDistances result;
    result.distance = array_of<double>(std::move(distances));
    result.triangles = array_of<std::int64_t>(std::move(triangles)).attr("reshape")(-1, 2);
    result.points = array_of<double>(std::move(points)).attr("reshape")(-1, 2, 3);
    result.n_v = array_of<std::uint64_t>(std::move(n_v));
    result.n_p = array_of<std::uint64_t>(std::move(n_p));
    return result;
}

template <class Side>
py::array within_once(const Side& a, const Side& b, double tolerance, const py::object& pose) {
    const Pose b_to_a = pose_of(pose, "pose");
    check_alike(a, b);
    if (std::isinf(length_of("tolerance", tolerance))) refuse("tolerance", "give a finite number.");
    std::vector<IndexPair> pairs;
    {
        const py::gil_scoped_release unlocked;
        pairs = pairs_within(a, b, b_to_a, tolerance);
    }
    return array_of<std::uint32_t>(std::move(pairs), 2);
}

template <class Side>
void add_functions(py::module_& module) {
    constexpr double no_limit = std::numeric_limits<double>::infinity();
    module.def("distance", &distance_once<Side>, py::arg("a"), py::arg("b"),
               py::arg("pose") = py::none(), py::kw_only(), py::arg("order") = "hybrid",
               py::arg("limit") = no_limit, py::arg("relative_error") = 0.0,
               py::arg("seed") = py::none(),
               R"(Find the smallest distance of a triangle of a and a triangle of b.

pose: 4 x 4 or 3 x 4, from b's frame to a's; None is the identity. order: "nearest", "depth-first" or
"hybrid"; the distance is the same, the counts are not. limit: nothing beyond is looked for.
relative_error: the answer may be too large by this share. seed: triangles of a and b to begin with,
such as Distance.triangles of the pose before; the nearer they are, the fewer tests follow.

a and b are hierarchies, or packed hierarchies, which are quicker by far. Bodies inside each other
have the distance of their surfaces. Runs in one thread, without the
interpreter's lock. Raises InputError where the pose is not rigid, or the volumes of a and b are not
of one kind.)");
    module.def("distance_poses", &distance_poses<Side>, py::arg("a"), py::arg("b"),
               py::arg("poses"), py::kw_only(), py::arg("threads") = 0, py::arg("order") = "hybrid",
               py::arg("limit") = no_limit, py::arg("relative_error") = 0.0,
               R"(distance at n poses, in threads, without the interpreter's lock.

poses: n x 4 x 4 or n x 3 x 4, from b's frame to a's. threads: how many share the poses, 0 for one per
processor; the result is the same for any number. Ctrl-C ends it between two poses.)");
    module.def("within", &within_once<Side>, py::arg("a"), py::arg("b"), py::arg("tolerance"),
               py::arg("pose") = py::none(),
               R"(Find the pairs of triangles of a and b that are at most tolerance apart.

Returns n x 2 uint32, sorted: row numbers of mesh.triangles. pose: from b's frame to a's.)");
}

}  // namespace

void add_distance(py::module_& module) {
    py::class_<FoundDistance>(module, "Distance", py::is_final(), "How far apart two bodies are.")
        .def_readonly("distance", &FoundDistance::distance,
                      "Of the closest triangles; 0 if and only if triangles intersect. Infinity if "
                      "nothing is within the limit.")
        .def_readonly("triangles", &FoundDistance::triangles,
                      "The closest triangles of a and b, as row numbers of mesh.triangles; None if "
                      "nothing is within the limit.")
        .def_readonly("points", &FoundDistance::points,
                      "2 x 3 float64: the closest points of a and of b, in a's frame; or None.")
        .def_readonly("n_v", &FoundDistance::n_v, "Pairs of volumes whose distance was bounded.")
        .def_readonly("n_p", &FoundDistance::n_p, "Pairs of triangles that were measured.")
        .def_readonly("n_u", &FoundDistance::n_u,
                      "Points and directions of volumes that were transformed for the bounds; None "
                      "of packed hierarchies.")
        .def_readonly(
            "stages", &FoundDistance::stages,
            R"(Pairs of volumes by how their test ended: "near", or the direction of the bound that left the
pair out. None for packed hierarchies, which do not count them.)")
        .def("__repr__", [](const FoundDistance& f) {
            return "<scb.Distance: " + exact_number(f.distance) +
                   ", N_v = " + std::to_string(f.n_v) + ", N_p = " + std::to_string(f.n_p) + ">";
        });
    py::class_<FoundDistances>(module, "Distances", py::is_final(),
                               "How far apart two bodies are at n poses. Arrays have a row per "
                               "pose.")
        .def_readonly("distance", &FoundDistances::distance, "n float64: see Distance.distance.")
        .def_readonly("triangles", &FoundDistances::triangles,
                      "n x 2 int64: the closest triangles; -1 if nothing is within the limit.")
        .def_readonly(
            "points", &FoundDistances::points,
            "n x 2 x 3 float64: the closest points in a's frame; NaN if nothing is within "
            "the limit.")
        .def_readonly("n_v", &FoundDistances::n_v, "n uint64: see Distance.n_v.")
        .def_readonly("n_p", &FoundDistances::n_p, "n uint64: see Distance.n_p.")
        .def("__len__", [](const FoundDistances& f) { return f.distance.shape(0); })
        .def("__repr__", [](const FoundDistances& f) {
            return "<scb.Distances: " + std::to_string(f.distance.shape(0)) + " poses>";
        });
    add_functions<BuiltHierarchy>(module);
    add_functions<BuiltPacked>(module);
}

}  // namespace scb::python
