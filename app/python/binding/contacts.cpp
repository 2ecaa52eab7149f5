#include "app/python/binding/contacts.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "app/python/binding/arrays.h"
#include "app/python/binding/mesh.h"
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

}  // namespace

void add_contacts(py::module_& module) {
    module.def("crossing", crossing, py::arg("a"), py::arg("b"), py::arg("pairs"),
               py::arg("pose") = py::none(),
               R"(Say which pairs of triangles of two meshes cross: n bool.

The triangles of a pair cross if their interiors have a common point and they are in different planes.
Other pairs that intersect only touch: with a corner, with an edge, or in one plane. Exact.

pairs: n x 2 whole numbers, triangles of a and b, such as collide(a, b, pose).pairs. pose: 4 x 4 or 3 x 4, from
b's frame to a's; None is the identity. Raises InputError.)");
}

}  // namespace scb::python
