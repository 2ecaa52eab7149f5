#include "app/python/binding/mesh.h"

#include <cstring>
#include <limits>

#include "app/python/binding/arrays.h"
#include "app/python/binding/source.h"
#include "core/platform/utf8.h"
#include "scenes/meshes/mesh_file.h"

namespace scb::python {
namespace {

static_assert(sizeof(Vec3) == 24 && sizeof(Triangle) == 12);

SharedMesh mesh_of(const py::object& vertices, const py::object& triangles,
                   const std::string& name) {
    const DoubleArray points = doubles_of(vertices, name + ": vertices", 2, 3, "n x 3");
    const IndexArray corners = indices_of(triangles, name + ": triangles", 2, 3, "m x 3");
    auto mesh = std::make_shared<Mesh>();
    mesh->vertices.resize(static_cast<std::size_t>(points.shape(0)));
    if (points.size() > 0)
        std::memcpy(mesh->vertices[0].data(), points.data(),
                    static_cast<std::size_t>(points.size()) * sizeof(double));
    mesh->triangles.resize(static_cast<std::size_t>(corners.shape(0)));
    for (py::ssize_t t = 0; t < corners.shape(0); ++t)
        for (py::ssize_t k = 0; k < 3; ++k) {
            const std::int64_t corner = *corners.data(t, k);
            if (corner < 0 || corner > std::numeric_limits<std::uint32_t>::max())
                refuse(name, "triangle " + std::to_string(t) + " names vertex " +
                                 std::to_string(corner) + ", but the mesh has " +
                                 std::to_string(points.shape(0)) + " vertices; repair the index.");
            mesh->triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)] =
                static_cast<std::uint32_t>(corner);
        }
    {
        const py::gil_scoped_release unlocked;
        check_mesh(*mesh, name);
    }
    return {std::move(mesh), name};
}

SharedMesh read_mesh(const py::object& path) {
    const std::filesystem::path file = file_of(path);
    const py::gil_scoped_release unlocked;
    return {std::make_shared<Mesh>(scenes::load_mesh(file)), as_utf8(file.stem().string())};
}

py::array vertices_of(const SharedMesh& m) {
    const auto count = static_cast<py::ssize_t>(m.mesh->vertices.size());
    return view_of(py::dtype::of<double>(), m.mesh->vertices.data(), {count, 3}, {24, 8}, m.mesh);
}

py::array triangles_of(const SharedMesh& m) {
    const auto count = static_cast<py::ssize_t>(m.mesh->triangles.size());
    return view_of(py::dtype::of<std::uint32_t>(), m.mesh->triangles.data(), {count, 3}, {12, 4},
                   m.mesh);
}

}  // namespace

void add_mesh(py::module_& module) {
    py::class_<SharedMesh>(
        module, "Mesh", py::is_final(),
        R"(A triangle mesh or triangle soup in its body frame, in any unit of length.

No connectivity is assumed. Degenerate and duplicate triangles are legal. A mesh does not change.)")
        .def(py::init(&mesh_of), py::arg("vertices"), py::arg("triangles"),
             py::arg("name") = "mesh", R"(Copy arrays into a mesh.

vertices: n x 3 floats. triangles: m x 3 whole numbers, corners as row numbers of vertices.
name: what errors and pictures call the mesh.

Raises InputError where there is no triangle, an index is out of range, or a vertex that a triangle
uses is not finite or beyond 1e70.)")
        .def_property_readonly("vertices", vertices_of, "n x 3 float64, read-only, without a copy.")
        .def_property_readonly("triangles", triangles_of,
                               "m x 3 uint32, read-only, without a copy.")
        .def_property_readonly(
            "name", [](const SharedMesh& m) { return m.name; }, "What errors and pictures call it.")
        .def("__repr__", [](const SharedMesh& m) {
            return "<scb.Mesh '" + m.name + "': " + std::to_string(m.mesh->vertices.size()) +
                   " vertices, " + std::to_string(m.mesh->triangles.size()) + " triangles>";
        });
    module.def("read_mesh", &read_mesh, py::arg("path"),
               R"(Read a mesh file: PLY, OBJ, or what assimp reads (STL, OFF, glTF, DAE, 3DS, ...).

Formats that assimp reads are read in another process, which a broken file cannot take down.

Raises InputError where the file is missing or broken, MeshReaderError where that process fails.)");
}

}  // namespace scb::python
