#include "app/python/binding/volumes.h"

#include <pybind11/stl.h>

#include <numeric>

#include "core/base/text_format.h"

namespace scb::python {
namespace {

/// Collects arrays on the numbers of volumes, one row per volume.
struct Fields {
    std::shared_ptr<BuiltHierarchy> owner;
    py::ssize_t count, stride;
    VolumeArrays& result;

    /// `first`: the field of the first volume. Shape and strides are within a row.
    void add(const char* name, const double* first, const Sizes& shape = {},
             const Sizes& strides = {}) const {
        Sizes all_shape = {count}, all_strides = {stride};
        all_shape.insert(all_shape.end(), shape.begin(), shape.end());
        all_strides.insert(all_strides.end(), strides.begin(), strides.end());
        result.fields.emplace_back(
            name, view_of(py::dtype::of<double>(), first, all_shape, all_strides, owner));
    }
    void add(const char* name, const Vec3& first) const { add(name, first.data(), {3}, {8}); }
};

void add_fields(const Fields& to, const Scb& v) {
    to.add("centers", v.c);
    to.add("radii", &v.r);
    to.add("normals", v.n);
    to.add("e", &v.e);
    to.add("f", &v.f);
}
void add_fields(const Fields& to, const Scb2& v) {
    constexpr auto slab = static_cast<py::ssize_t>(sizeof(Slab));
    to.add("centers", v.c);
    to.add("radii", &v.r);
    to.add("normals", v.slabs[0].n.data(), {2, 3}, {slab, 8});
    to.add("e", &v.slabs[0].e, {2}, {slab});
    to.add("f", &v.slabs[0].f, {2}, {slab});
}
void add_fields(const Fields& to, const Ball& v) {
    to.add("centers", v.center);
    to.add("radii", &v.radius);
}
void add_fields(const Fields& to, const Obb& v) {
    to.add("centers", v.center);
    to.add("axes", v.axes.data(), {3, 3}, {8, 24});  // Eigen stores columns
    to.add("half_lengths", v.half);
}
template <bool exact>
void add_fields(const Fields& to, const BasicAabb<exact>& v) {
    to.add("centers", v.center);
    to.add("half_lengths", v.half);
}
void add_fields(const Fields& to, const Rss& v) {
    to.add("centers", v.center);
    to.add("half_sides", v.half_sides[0].data(), {2, 3}, {24, 8});
    to.add("radii", &v.radius);
}
void add_fields(const Fields& to, const Capsule& v) {
    to.add("centers", v.center);
    to.add("half_axes", v.half_axis);
    to.add("radii", &v.radius);
}
template <int k>
void add_fields(const Fields& to, const KDop<k>& v) {
    to.add("lower", v.lower.data(), {KDop<k>::slabs}, {8});
    to.add("upper", v.upper.data(), {KDop<k>::slabs}, {8});
}

}  // namespace

VolumeArrays all_volumes(const std::shared_ptr<BuiltHierarchy>& h) {
    std::vector<std::uint32_t> nodes(h->topology().nodes.size());
    std::iota(nodes.begin(), nodes.end(), 0u);
    VolumeArrays result{
        std::string(volume_kind_name(h->kind)), array_of<std::uint32_t>(std::move(nodes)), {}};
    std::visit(
        [&]<class V>(const Hierarchy<V>& of) {
            add_fields({h, static_cast<py::ssize_t>(of.volumes.size()),
                        static_cast<py::ssize_t>(sizeof(V)), result},
                       of.volumes[0]);
        },
        h->hierarchy);
    return result;
}

VolumeArrays VolumeArrays::take(const py::array& rows) const {
    const auto taken = [&rows](const py::array& from) {
        return from.attr("take")(rows, py::arg("axis") = 0).cast<py::array>();
    };
    VolumeArrays result{kind, taken(nodes), {}};
    for (const auto& [name, array] : fields) result.fields.emplace_back(name, taken(array));
    return result;
}

py::array VolumeArrays::field(const std::string& name) const {
    for (const auto& [known, array] : fields)
        if (known == name) return array;
    const std::string sentence = "volumes of the kind " + kind + " have no " + name +
                                 "; they have " +
                                 name_list(fields, &std::pair<std::string, py::array>::first) + ".";
    throw py::attribute_error(sentence);
}

void add_volumes(py::module_& module) {
    py::class_<VolumeArrays> type(
        module, "Volumes", py::is_final(),
        R"(Volumes of nodes as arrays with a row per node, in the frame of the mesh.

Which arrays there are depends on the kind: fields has them all. A slab cut ball is the ball with
center c and radius r between two planes: f <= n.(x - c) <= e.)");
    type.def_property_readonly(
            "kind", [](const VolumeArrays& v) { return v.kind; }, "As build calls it.")
        .def_property_readonly(
            "nodes", [](const VolumeArrays& v) { return v.nodes; },
            "uint32: whose volumes they are.")
        .def_property_readonly(
            "fields",
            [](const VolumeArrays& v) {
                py::dict all;
                for (const auto& [name, array] : v.fields) all[py::str(name)] = array;
                return all;
            },
            R"(All arrays by name, float64. scb: centers, radii, normals, e, f. scb2: the same, with two
normals, e and f a node. ball, ritter: centers, radii. obb: centers, axes (unit axes in the columns),
half_lengths. aabb, aabb-exact: centers, half_lengths. dop14, dop18, dop26: lower, upper. rss: centers,
half_sides, radii. capsule: centers, half_axes, radii.)")
        .def("__len__", [](const VolumeArrays& v) { return v.nodes.shape(0); })
        .def("__repr__", [](const VolumeArrays& v) {
            return "<scb.Volumes: " + std::to_string(v.nodes.shape(0)) + " of " + v.kind + ">";
        });
    const std::pair<const char*, const char*> documented[] = {
        {"centers", "k x 3 float64: of the ball or the box."},
        {"radii", "k float64."},
        {"normals", "k x 3 float64, unit vectors; of scb2 k x 2 x 3."},
        {"e", "k float64: the upper plane's signed distance from the center; of scb2 k x 2."},
        {"f", "k float64: the lower plane's; of scb2 k x 2."},
    };
    for (const auto& [name, words] : documented)
        type.def_property_readonly(
            name, [field = std::string(name)](const VolumeArrays& v) { return v.field(field); },
            words);
}

}  // namespace scb::python
