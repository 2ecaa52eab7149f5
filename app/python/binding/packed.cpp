#include "app/python/binding/packed.h"

#include <pybind11/stl.h>

#include "app/python/binding/collide_poses.h"
#include "app/python/binding/mesh.h"
#include "app/python/binding/signals.h"
#include "app/python/binding/source.h"
#include "core/base/parallel_for.h"
#include "core/base/text_format.h"
#include "scb/any_packed.h"

namespace scb::python {
namespace {

SharedPacked pack_mesh(const SharedMesh& mesh, const std::string& layout, const std::string& volume,
                       const std::string& split, std::int64_t leaf, std::int64_t threads) {
    const app::HierarchyOptions options = hierarchy_options(volume, split, "ritter", 0);
    const std::optional<PackedLayout> named = packed_layout_of(layout);
    if (!named)
        refuse("layout", "\"" + layout + "\" is none; give one of " +
                             name_list(all_packed_layouts(), packed_layout_name) + ".");
    if (leaf < 1 || leaf > most_leaf_triangles)
        refuse("leaf", "give 1 to " + std::to_string(most_leaf_triangles) + " triangles.");
    auto result = std::make_shared<BuiltPacked>();
    result->mesh = mesh.mesh;
    result->name = mesh.name;
    result->kind = options.kind();
    result->layout = *named;
    result->layout.leaf_triangles = static_cast<int>(leaf);
    BuildOptions build = options.build();
    build.threads = threads_of(threads);
    const py::gil_scoped_release unlocked;
    result->packed = build_packed_any(result->layout, result->kind, *mesh.mesh, build, mesh.name);
    return result;
}

/// The result of a query, for Python.
struct FoundPacked {
    py::array pairs;
    std::uint64_t n_v = 0, n_p = 0, n_exact = 0, n_after_doubles = 0;
};

/// The memory of this thread's queries. To allocate it anew takes up to half of a short query.
PackedWorkspace& workspace_of_thread() {
    thread_local PackedWorkspace workspace;
    return workspace;
}

FoundPacked collide_packed_once(const SharedPacked& a, const SharedPacked& b,
                                const py::object& pose, std::int64_t threads) {
    const Pose b_to_a = pose_of(pose, "pose");
    PackedOptions options;
    options.threads = threads_of(threads);
    PackedCollision found;
    {
        const py::gil_scoped_release unlocked;
        found = collide_packed(a->packed, *a->mesh, b->packed, *b->mesh, b_to_a, options,
                               &workspace_of_thread());
    }
    return {array_of<std::uint32_t>(std::move(found.pairs), 2), found.n_v, found.n_p, found.n_exact,
            found.n_after_doubles};
}

PackedTouch touches_once(const SharedPacked& a, const SharedPacked& b, const py::object& pose) {
    const Pose b_to_a = pose_of(pose, "pose");
    const py::gil_scoped_release unlocked;
    return touches(a->packed, *a->mesh, b->packed, *b->mesh, b_to_a, {}, &workspace_of_thread());
}

/// Calls `query(i, pose, workspace)` for each pose, in threads and without the interpreter's lock.
/// Consecutive poses share a workspace.
template <class Query>
void at_poses(const std::vector<Pose>& poses, std::int64_t thread_count, const Query& query) {
    constexpr std::size_t poses_of_share = 64;
    const int threads = threads_of(thread_count);
    const py::gil_scoped_release unlocked;
    SignalWatch watch;
    parallel_for(threads, (poses.size() + poses_of_share - 1) / poses_of_share,
                 [&](std::size_t share) {
                     PackedWorkspace workspace;
                     const std::size_t end = std::min((share + 1) * poses_of_share, poses.size());
                     for (std::size_t i = share * poses_of_share; i < end && !watch.stopped(); ++i)
                         query(i, poses[i], workspace);
                 });
    watch.rethrow();
}

/// Results of queries at several poses: a row per pose.
struct PackedAtPoses : PairsAtPoses {
    py::array n_v, n_p, n_exact, n_after_doubles;
};

PackedAtPoses collide_packed_poses(const SharedPacked& a, const SharedPacked& b,
                                   const py::object& matrices, std::int64_t threads) {
    const std::vector<Pose> poses = poses_of(matrices, "poses");
    std::vector<std::uint64_t> n_v(poses.size()), n_p(poses.size()), n_exact(poses.size()),
        n_after_doubles(poses.size());
    std::vector<std::vector<IndexPair>> pairs(poses.size());
    at_poses(poses, threads, [&](std::size_t i, const Pose& pose, PackedWorkspace& workspace) {
        PackedCollision found =
            collide_packed(a->packed, *a->mesh, b->packed, *b->mesh, pose, {}, &workspace);
        n_v[i] = found.n_v;
        n_p[i] = found.n_p;
        n_exact[i] = found.n_exact;
        n_after_doubles[i] = found.n_after_doubles;
        pairs[i] = std::move(found.pairs);
    });
    PackedAtPoses result;
    result.set(std::move(pairs));
    result.n_v = array_of<std::uint64_t>(std::move(n_v));
    result.n_p = array_of<std::uint64_t>(std::move(n_p));
    result.n_exact = array_of<std::uint64_t>(std::move(n_exact));
    result.n_after_doubles = array_of<std::uint64_t>(std::move(n_after_doubles));
    return result;
}

py::array touches_poses(const SharedPacked& a, const SharedPacked& b, const py::object& matrices,
                        std::int64_t threads) {
    const std::vector<Pose> poses = poses_of(matrices, "poses");
    std::vector<std::uint8_t> answers(poses.size());
    at_poses(poses, threads, [&](std::size_t i, const Pose& pose, PackedWorkspace& workspace) {
        answers[i] = touches(a->packed, *a->mesh, b->packed, *b->mesh, pose, {}, &workspace)
                         .pair.has_value();
    });
    return array_of<bool>(std::move(answers));
}

void add_packed_types(py::module_& module) {
    py::class_<BuiltPacked, SharedPacked>(
        module, "PackedHierarchy", py::is_final(),
        R"(A hierarchy of slab cut balls, made for quick queries: wide nodes, and rounded volumes.

Its queries find the same pairs as a Hierarchy's. It does not change, and any number of threads may
query it.)")
        .def_property_readonly(
            "mesh",
            [](const SharedPacked& h) {
                return SharedMesh{h->mesh, h->name};
            },
            "Its mesh.")
        .def_property_readonly(
            "volume", [](const SharedPacked& h) { return std::string(volume_kind_name(h->kind)); },
            "The kind of its volumes.")
        .def_property_readonly(
            "layout", [](const SharedPacked& h) { return packed_layout_name(h->layout); },
            "The name of its layout.")
        .def_property_readonly(
            "leaf", [](const SharedPacked& h) { return h->layout.leaf_triangles; },
            "The most triangles of a leaf.")
        .def_property_readonly(
            "nbytes", [](const SharedPacked& h) { return bytes_of(h->packed); },
            "Bytes of its nodes and leaves, without the mesh.")
        .def("__repr__", [](const SharedPacked& h) {
            return "<scb.PackedHierarchy of '" + h->name +
                   "': " + std::string(volume_kind_name(h->kind)) + ", " +
                   packed_layout_name(h->layout) + ", " + std::to_string(bytes_of(h->packed)) +
                   " bytes>";
        });
    py::class_<FoundPacked>(module, "PackedCollision", py::is_final(),
                            "What a query of packed hierarchies found.")
        .def_readonly(
            "pairs", &FoundPacked::pairs,
            R"(n x 2 uint32, sorted, each once: triangles of a and b that intersect, as row
numbers of mesh.triangles. Read-only, without a copy.)")
        .def_readonly("n_v", &FoundPacked::n_v, "Tests of two volumes.")
        .def_readonly("n_p", &FoundPacked::n_p, "Tests of two triangles.")
        .def_readonly("n_exact", &FoundPacked::n_exact,
                      "Tests of n_p that floats could not decide.")
        .def_readonly("n_after_doubles", &FoundPacked::n_after_doubles,
                      "Tests of n_exact that doubles could not decide either.")
        .def("__repr__", [](const FoundPacked& f) {
            return "<scb.PackedCollision: " + std::to_string(f.pairs.shape(0)) +
                   " pairs, N_v = " + std::to_string(f.n_v) + ", N_p = " + std::to_string(f.n_p) +
                   ">";
        });
    py::class_<PackedTouch>(module, "Touch", py::is_final(),
                            "Whether two bodies touch. True or false in a condition.")
        .def_property_readonly(
            "pair",
            [](const PackedTouch& t) {
                return t.pair ? std::optional(std::pair(t.pair->a, t.pair->b)) : std::nullopt;
            },
            "A triangle of a and a triangle of b that intersect; None if there are none.")
        .def_readonly("n_v", &PackedTouch::n_v, "Tests of two volumes.")
        .def_readonly("n_p", &PackedTouch::n_p, "Tests of two triangles.")
        .def_readonly("n_exact", &PackedTouch::n_exact,
                      "Tests of n_p that floats could not decide.")
        .def("__bool__", [](const PackedTouch& t) { return t.pair.has_value(); })
        .def("__repr__", [](const PackedTouch& t) {
            return std::string("<scb.Touch: ") +
                   (t.pair ? "triangles " + std::to_string(t.pair->a) + " and " +
                                 std::to_string(t.pair->b)
                           : "none") +
                   ", N_v = " + std::to_string(t.n_v) + ", N_p = " + std::to_string(t.n_p) + ">";
        });
    py::class_<PackedAtPoses>(module, "PackedCollisions", py::is_final(),
                              "What queries of packed hierarchies found at n poses.")
        .def_readonly("n_v", &PackedAtPoses::n_v, "n uint64: tests of two volumes.")
        .def_readonly("n_p", &PackedAtPoses::n_p, "n uint64: tests of two triangles.")
        .def_readonly("n_exact", &PackedAtPoses::n_exact,
                      "n uint64: tests of n_p that floats could not decide.")
        .def_readonly("n_after_doubles", &PackedAtPoses::n_after_doubles,
                      "n uint64: tests of n_exact that doubles could not decide either.")
        .def_readonly("pairs", &PackedAtPoses::pairs,
                      "m x 2 uint32: the pairs of all poses, pose after pose.")
        .def_readonly("offsets", &PackedAtPoses::offsets,
                      "n + 1 int64: the pairs of pose i are pairs[offsets[i]:offsets[i + 1]].")
        .def("pairs_of", &PackedAtPoses::pairs_of, py::arg("index"),
             "The pairs of one pose, without a copy. Raises IndexError.")
        .def("__len__", &PackedAtPoses::size)
        .def("__repr__", [](const PackedAtPoses& f) {
            return "<scb.PackedCollisions: " + std::to_string(f.size()) + " poses, " +
                   std::to_string(f.pairs.shape(0)) + " pairs>";
        });
}

}  // namespace

void add_packed(py::module_& module) {
    add_packed_types(module);
    module.def("pack", pack_mesh, py::arg("mesh"), py::arg("layout") = "quantized8", py::kw_only(),
               py::arg("volume") = "scb2", py::arg("split") = "cost",
               py::arg("leaf") = most_leaf_triangles, py::arg("threads") = 0,
               R"(Build a packed hierarchy of a mesh: the quickest way to find pairs.

layout: "float2", "float4", "float8", or so many children with "quantized" or "indexed". volume: "scb2" (two slabs) or "scb". split: "cost" or
"paper", as in build. leaf: 1 to 4, the most triangles of a leaf. threads: how many build it, 0 for one
per processor; the result is the same for any number.

Raises InputError, also if coordinates are above 1e8 or the mesh is smaller than 1e-8.)");
    module.def(
        "collide", collide_packed_once, py::arg("a"), py::arg("b"), py::arg("pose") = py::none(),
        py::kw_only(), py::arg("threads") = 1,
        R"(Find the same pairs of packed hierarchies of one layout, in a fraction of the time.

pose: 4 x 4 or 3 x 4, from b's frame to a's; None is the identity. threads: how many share the query, 0 for one
per processor; the result is the same for any number. There are no counts by stage.

Raises InputError where the pose is not rigid, or the layouts of a and b differ.)");
    module.def("touches", touches_once, py::arg("a"), py::arg("b"), py::arg("pose") = py::none(),
               R"(Whether some triangles of a and b intersect; ends at the first pair.

a, b: packed hierarchies of one layout. pose: 4 x 4 or 3 x 4, from b's frame to a's; None is the identity. The
answer is exact. Runs in one thread, without the interpreter's lock.

Raises InputError where the pose is not rigid, or the layouts differ.)");
    module.def(
        "collide_poses", collide_packed_poses, py::arg("a"), py::arg("b"), py::arg("poses"),
        py::kw_only(), py::arg("threads") = 0,
        R"(collide of packed hierarchies at n poses, in threads, without the interpreter's lock.

poses: n x 4 x 4 or n x 3 x 4, from b's frame to a's. threads: how many share the poses, 0 for one per processor; the
result is the same for any number. Ctrl-C ends it between two poses. Raises InputError as collide does.)");
    module.def("touches_poses", touches_poses, py::arg("a"), py::arg("b"), py::arg("poses"),
               py::kw_only(), py::arg("threads") = 0,
               R"(touches at n poses, in threads, without the interpreter's lock: n bool.

poses: n x 4 x 4 or n x 3 x 4, from b's frame to a's. threads: how many share the poses, 0 for one per processor.
Ctrl-C ends it between two poses. Raises InputError as touches does.)");
}

}  // namespace scb::python
