#include "app/python/binding/contacts.h"

#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/python/binding/arrays.h"
#include "app/python/binding/hierarchy.h"
#include "app/python/binding/mesh.h"
#include "core/distance/deepest_vertices.h"
#include "scb/triangle_overlap.h"

namespace scb::python {
namespace {

py::array crossing(const SharedMesh& a, const SharedMesh& b, const py::object& pairs,
                   const py::object& pose) {
    const Pose b_to_a = pose_of(pose, "pose");
    const IndexArray rows = indices_of(pairs, "pairs", 2, 2, "n x 2");
    const auto check = [](std::int64_t triangle, const SharedMesh& side) {
        if (triangle >= 0 && triangle < static_cast<std::int64_t>(side.mesh->triangles.size()))
            return;
        refuse("pairs", "there is no triangle " + std::to_string(triangle) + " in " + side.name +
                            "; give row numbers of mesh.triangles.");
    };
    const std::int64_t* const data = rows.data();
    const auto count = static_cast<std::size_t>(rows.shape(0));
    for (std::size_t i = 0; i < count; ++i) {
        check(data[2 * i], a);
        check(data[2 * i + 1], b);
    }
    std::vector<std::uint8_t> answers(count);
    {
        const py::gil_scoped_release unlocked;
        for (std::size_t i = 0; i < count; ++i)
            answers[i] =
                triangle_contact(
                    corners(*a.mesh, static_cast<std::uint32_t>(data[2 * i])),
                    transform_corners(
                        b_to_a, corners(*b.mesh, static_cast<std::uint32_t>(data[2 * i + 1])))) ==
                TriangleContact::crossing;
    }
    return array_of<std::uint8_t>(std::move(answers)).view("bool");
}

/// A patch of a query, for Python.
struct FoundPatch {
    py::array pairs, box;
    std::array<std::optional<DeepVertex>, 2> deepest;
    std::array<bool, 2> is_judged{};
};

std::vector<FoundPatch> patches(const BuiltHierarchy& a, const BuiltHierarchy& b,
                                const py::object& pose) {
    const Pose b_to_a = pose_of(pose, "pose");
    if (a.kind != b.kind)
        refuse("a and b", "they have different volumes; build both with the same.");
    std::vector<IndexPair> pairs;
    std::vector<ContactPatch> found;
    std::array<std::vector<std::optional<DeepVertex>>, 2> deepest;
    std::array<bool, 2> is_judged{};
    {
        const py::gil_scoped_release unlocked;
        pairs = collide(a.hierarchy, *a.mesh, b.hierarchy, *b.mesh, b_to_a).pairs;
        const JoinedMesh joined_a(*a.mesh), joined_b(*b.mesh);
        found = contact_patches({*a.mesh, joined_a.triangles}, {*b.mesh, joined_b.triangles},
                                b_to_a, pairs);
        const std::array bodies = {PatchBody{*a.mesh, joined_a, a.hierarchy, Pose{}},
                                   PatchBody{*b.mesh, joined_b, b.hierarchy, b_to_a}};
        for (std::size_t side = 0; side < 2; ++side) {
            const PatchBody& outer = bodies[1 - side];
            is_judged[side] = outer.joined.is_closed;
            if (is_judged[side])
                deepest[side] = deepest_vertices(bodies[side], outer, side, pairs, found);
        }
    }
    std::vector<FoundPatch> result(found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        std::vector<IndexPair> of_patch;
        for (const std::uint32_t pair : found[i].pairs) of_patch.push_back(pairs[pair]);
        result[i].pairs = array_of<std::uint32_t>(std::move(of_patch), 2);
        const auto& [lower, upper] = found[i].box;
        result[i].box = array_of<double>(
            std::vector<double>{lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]}, 3);
        result[i].is_judged = is_judged;
        for (std::size_t side = 0; side < 2; ++side)
            if (is_judged[side]) result[i].deepest[side] = deepest[side][i];
    }
    return result;
}

void add_patches(py::module_& module) {
    py::class_<DeepVertex>(module, "DeepVertex", py::is_final(), "A vertex inside another body.")
        .def_readonly("vertex", &DeepVertex::vertex, "Its row number in mesh.vertices.")
        .def_property_readonly(
            "at",
            [](const DeepVertex& v) {
                return array_of<double>(std::vector<double>{v.at[0], v.at[1], v.at[2]});
            },
            "3 float64: where it is, in a's frame.")
        .def_property_readonly(
            "signed_distance", [](const DeepVertex& v) { return -v.depth; },
            "Below 0: minus its distance to the nearest triangle of the other body.")
        .def_readonly("triangle", &DeepVertex::nearest, "This triangle; of several, the lowest.");
    py::class_<FoundPatch>(module, "ContactPatch", py::is_final(),
                           "A connected set of the pairs of triangles that intersect.")
        .def_readonly("pairs", &FoundPatch::pairs, "n x 2 uint32, sorted: triangles of a and b.")
        .def_readonly("box", &FoundPatch::box,
                      "2 x 3 float64: the lower and the upper corner of a box that holds the "
                      "points in which the triangles meet, in a's frame.")
        .def_property_readonly(
            "deepest_a", [](const FoundPatch& p) { return p.deepest[0]; },
            "The deepest vertex of a inside b that belongs to the patch; None if there is none, or "
            "it is not judged.")
        .def_property_readonly(
            "deepest_b", [](const FoundPatch& p) { return p.deepest[1]; },
            "The deepest vertex of b inside a.")
        .def_property_readonly(
            "is_judged_a", [](const FoundPatch& p) { return p.is_judged[0]; },
            "Whether b is closed, so that a vertex of a can be inside.")
        .def_property_readonly(
            "is_judged_b", [](const FoundPatch& p) { return p.is_judged[1]; },
            "Whether a is closed.");
    module.def("patches", patches, py::arg("a"), py::arg("b"), py::arg("pose") = py::none(),
               R"(Find the contact patches of two bodies, and how deep vertices are inside.

Two pairs of triangles that intersect are neighbors if their triangles share a corner in both bodies; a
patch is a connected set of pairs. The patch with the most pairs is first. pose: 4 x 4 or 3 x 4, from
b's frame to a's; None is the identity. Runs in one thread, without the interpreter's lock.

Raises InputError where the pose is not rigid, or the volumes of a and b are not of one kind.)");
}

}  // namespace

void add_contacts(py::module_& module) {
    add_patches(module);
    module.def("crossing", crossing, py::arg("a"), py::arg("b"), py::arg("pairs"),
               py::arg("pose") = py::none(),
               R"(Say which pairs of triangles of two meshes cross: n bool.

The triangles of a pair cross if their interiors have a common point and they are in different planes.
Other pairs that intersect only touch: with a corner, with an edge, or in one plane. Exact.

pairs: n x 2 whole numbers, triangles of a and b, such as collide(a, b, pose).pairs. pose: 4 x 4 or 3 x 4, from
b's frame to a's; None is the identity. Raises InputError.)");
}

}  // namespace scb::python
