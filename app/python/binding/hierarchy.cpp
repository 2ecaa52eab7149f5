#include "app/python/binding/hierarchy.h"

#include <pybind11/stl.h>

#include "app/python/binding/arrays.h"
#include "app/python/binding/mesh.h"
#include "app/python/binding/source.h"
#include "app/python/binding/volumes.h"
#include "app/study/scene_setup.h"
#include "scb/level_cover.h"

namespace scb::python {
namespace {

using Shared = std::shared_ptr<BuiltHierarchy>;

Shared build(const SharedMesh& mesh, const std::string& volume, const std::string& split,
             const std::string& growth, double margin, std::int64_t threads) {
    const app::HierarchyOptions options = hierarchy_options(volume, split, growth, margin);
    auto result = std::make_shared<BuiltHierarchy>();
    result->mesh = mesh.mesh;
    result->name = mesh.name;
    result->kind = options.kind();
    result->build = options.build();
    result->build.threads = threads_of(threads);
    const py::gil_scoped_release unlocked;
    result->hierarchy =
        std::move(build_hierarchies(*mesh.mesh, {&result->kind, 1}, result->build, mesh.name)[0]);
    return result;
}

template <class Member>
py::array nodes_of(const Shared& h, Member TopologyNode::*member) {
    return member_view(h->topology().nodes, member, h);
}

/// The number of the level in a hierarchy of that depth, or -1 for "leaves".
int level_of(const py::object& level, int depth) {
    if (py::isinstance<py::str>(level))
        return app::parse_level(level.cast<std::string>(), depth, "level");
    if (PyIndex_Check(level.ptr()) == 0) refuse("level", "give a whole number, or \"leaves\".");
    const long long number = PyLong_AsLongLong(level.ptr());
    if (number == -1 && PyErr_Occurred() != nullptr) throw py::error_already_set();
    return app::parse_level(std::to_string(number), depth, "level");
}

void add_build(py::module_& module) {
    module.def("build", build, py::arg("mesh"), py::arg("volume") = "scb", py::kw_only(),
               py::arg("split") = "paper", py::arg("growth") = "ritter", py::arg("margin") = 0.0,
               py::arg("threads") = 0, R"(Build the hierarchy of a mesh.

volume: one of volume_kinds(). split: "paper" (Section 3) or "cost" (a surface area heuristic).
growth: "ritter" or "radius", how a minimum ball grows over the points outside. margin: by which share
of the radius, 0 to 1, slabs are widened. threads: how many build it, 0 for one per processor; the
result is the same for any number.

Raises InputError.)");
    module.def(
        "volume_kinds",
        [] {
            std::vector<std::string> names;
            for (const VolumeKind kind : all_volume_kinds())
                names.emplace_back(volume_kind_name(kind));
            return names;
        },
        "The kinds of volumes that build knows.");
}

}  // namespace

int BuiltHierarchy::depth() const { return scb::depth(topology()); }

void add_hierarchy(py::module_& module) {
    py::class_<BuiltHierarchy, Shared>(
        module, "Hierarchy", py::is_final(),
        R"(A bounding volume hierarchy of a mesh: a binary tree with one triangle per leaf.

Node 0 is the root; the children of a node follow each other. Arrays of a hierarchy are read-only and
no copies. A hierarchy does not change, and any number of threads may ask it.)")
        .def_property_readonly(
            "mesh",
            [](const Shared& h) {
                return SharedMesh{h->mesh, h->name};
            },
            "Its mesh.")
        .def_property_readonly(
            "volume", [](const Shared& h) { return std::string(volume_kind_name(h->kind)); },
            "The kind of its volumes, as build calls it.")
        .def_property_readonly(
            "depth", [](const Shared& h) { return h->depth(); },
            "Of the deepest node; the root has 0.")
        .def("__len__", [](const Shared& h) { return h->topology().nodes.size(); })
        .def_property_readonly(
            "first", [](const Shared& h) { return nodes_of(h, &TopologyNode::first); },
            "Per node, uint32: where its triangles begin in order.")
        .def_property_readonly(
            "count", [](const Shared& h) { return nodes_of(h, &TopologyNode::count); },
            "Per node, uint32: how many triangles it has.")
        .def_property_readonly(
            "left", [](const Shared& h) { return nodes_of(h, &TopologyNode::left); },
            "Per node, uint32: its left child, the right one is left + 1; 0 for a leaf.")
        .def_property_readonly(
            "order",
            [](const Shared& h) {
                const std::vector<std::uint32_t>& order = h->topology().order;
                return view_of(py::dtype::of<std::uint32_t>(), order.data(),
                               {static_cast<py::ssize_t>(order.size())}, {4}, h);
            },
            "Row numbers of mesh.triangles, uint32, such that each node has a range of them.")
        .def_property_readonly(
            "depths",
            [](const Shared& h) { return array_of<std::uint16_t>(node_depths(h->topology())); },
            "Per node, uint16: its depth.")
        .def_property_readonly(
            "volumes", [](const Shared& h) { return all_volumes(h); },
            "The volumes of all nodes, in the frame of the mesh.")
        .def(
            "level",
            [](const Shared& h, const py::object& level) {
                return all_volumes(h).take(array_of<std::uint32_t>(
                    level_cover(h->topology(), level_of(level, h->depth()))));
            },
            py::arg("level"), R"(The volumes that cover the mesh at a level, copied.

level: 0 to depth, or "leaves". The nodes are those at that depth and the leaves above it.

Raises InputError where there is no such level.)")
        .def(
            "validate",
            [](const Shared& h, const SharedMesh* mesh) {
                const Mesh& of = mesh != nullptr ? *mesh->mesh : *h->mesh;
                const py::gil_scoped_release unlocked;
                return validate(h->hierarchy, of);
            },
            py::arg("mesh") = py::none(),
            R"(Check that this is a hierarchy of its mesh, or of another one.

Every triangle must be in exactly one leaf, the triangles of two children must be their parent's, and
each volume must contain all vertices below it. Returns "" where all holds, or a sentence that names
the first node at which it does not. Takes n log n time.)")
        .def("__repr__", [](const Shared& h) {
            return "<scb.Hierarchy of '" + h->name +
                   "': " + std::string(volume_kind_name(h->kind)) + ", " +
                   std::to_string(h->topology().nodes.size()) + " nodes>";
        });
    add_build(module);
}

}  // namespace scb::python
