#include "app/python/binding/arrays.h"

#include <algorithm>
#include <array>

#include "core/base/text_format.h"
#include "scb/mesh.h"

namespace scb::python {
namespace {

std::string shape_text(const py::array& array) {
    std::string text;
    for (py::ssize_t i = 0; i < array.ndim(); ++i)
        text += (i == 0 ? "" : " x ") + std::to_string(array.shape(i));
    return text.empty() ? "one number" : text;
}

/// Converts to an array of numbers of any type; checks the kind of numbers, and the shape.
py::array numbers_of(const py::handle& object, const std::string& name, py::ssize_t dimensions,
                     py::ssize_t last, const std::string& shape, const std::string& kinds) {
    const std::string wanted =
        "give an array of " + shape + " " + (kinds == "iu" ? "whole numbers" : "numbers") + ".";
    const py::array array = py::array::ensure(object);
    if (!array) refuse(name, "numpy makes no array of this; " + wanted);
    if (kinds.find(array.dtype().kind()) == std::string::npos)
        refuse(name, "its elements are " + std::string(py::str(array.dtype())) + "; " + wanted);
    if (array.ndim() != dimensions || (last > 0 && array.shape(dimensions - 1) != last))
        refuse(name, "it is " + shape_text(array) + "; " + wanted);
    return array;
}

/// `rows`: 3 or 4, of four numbers.
NearestPose checked_pose(const double* m, py::ssize_t rows, const std::string& name) {
    if (rows == 4 && !(m[12] == 0 && m[13] == 0 && m[14] == 0 && m[15] == 1))
        refuse(name, "the last row of the matrix is not 0 0 0 1; give [R t; 0 0 0 1], row by row.");
    Pose pose;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) pose.rotation(i, j) = m[4 * i + j];
        pose.translation[i] = m[4 * i + 3];
    }
    const NearestPose nearest = nearest_rigid(pose, name);
    if (!(pose.translation.cwiseAbs().maxCoeff() <= max_coordinate))
        refuse(name, "its translation is beyond 1e70; move the bodies nearer to the origin.");
    return nearest;
}

}  // namespace

void warn_of_correction(double correction, const std::string& name) {
    if (correction == 0) return;
    const std::string words = name +
                              ": not quite a rotation; the nearest one is used. Its numbers "
                              "change by " +
                              format("%.2g at most.", correction);
    if (PyErr_WarnEx(PyExc_UserWarning, words.c_str(), 1) != 0) throw py::error_already_set();
}

py::array view_of(const py::dtype& type, const void* data, Sizes shape, Sizes strides,
                  std::shared_ptr<const void> owner) {
    using Owner = std::shared_ptr<const void>;
    const py::capsule base(new Owner(std::move(owner)),
                           [](void* pointer) { delete static_cast<Owner*>(pointer); });
    // Given a null pointer, numpy would allocate; this address is never read.
    static const double nothing = 0;
    py::array array(type, std::move(shape), std::move(strides), data != nullptr ? data : &nothing,
                    base);
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

DoubleArray doubles_of(const py::handle& object, const std::string& name, py::ssize_t dimensions,
                       py::ssize_t last, const std::string& shape) {
    const py::array array = numbers_of(object, name, dimensions, last, shape, "fiu");
    DoubleArray doubles = DoubleArray::ensure(array);
    if (!doubles) throw py::error_already_set();
    return doubles;
}

IndexArray indices_of(const py::handle& object, const std::string& name, py::ssize_t dimensions,
                      py::ssize_t last, const std::string& shape) {
    const py::array array = numbers_of(object, name, dimensions, last, shape, "iu");
    IndexArray indices = IndexArray::ensure(array);
    if (!indices) throw py::error_already_set();
    return indices;
}

Pose pose_of(const py::handle& object, const std::string& name) {
    if (object.is_none()) return {};
    const DoubleArray matrix = doubles_of(object, name, 2, 4, "4 x 4 or 3 x 4");
    if (matrix.shape(0) != 4 && matrix.shape(0) != 3)
        refuse(name, "it has " + shape_text(matrix) + "; give 4 x 4 or 3 x 4.");
    const NearestPose nearest = checked_pose(matrix.data(), matrix.shape(0), name);
    warn_of_correction(nearest.correction, name);
    return nearest.pose;
}

std::vector<Pose> poses_of(const py::handle& object, const std::string& name) {
    const DoubleArray matrices = doubles_of(object, name, 3, 4, "n x 4 x 4 or n x 3 x 4");
    const py::ssize_t rows = matrices.shape(1);
    if (rows != 4 && rows != 3)
        refuse(name, "it is " + shape_text(matrices) + "; give n x 4 x 4 or n x 3 x 4.");
    std::vector<Pose> poses;
    poses.reserve(static_cast<std::size_t>(matrices.shape(0)));
    double correction = 0;
    for (py::ssize_t i = 0; i < matrices.shape(0); ++i) {
        const NearestPose nearest =
            checked_pose(matrices.data(i), rows, name + "[" + std::to_string(i) + "]");
        correction = std::max(correction, nearest.correction);
        poses.push_back(nearest.pose);
    }
    warn_of_correction(correction, name);
    return poses;
}

py::array matrices_of(std::span<const Pose> poses) {
    using Matrix = std::array<double, 16>;
    std::vector<Matrix> matrices;
    matrices.reserve(poses.size());
    for (const Pose& p : poses) {
        const Mat3& r = p.rotation;
        const Vec3& t = p.translation;
        matrices.push_back({r(0, 0), r(0, 1), r(0, 2), t[0], r(1, 0), r(1, 1), r(1, 2), t[1],
                            r(2, 0), r(2, 1), r(2, 2), t[2], 0, 0, 0, 1});
    }
    const auto owner = std::make_shared<std::vector<Matrix>>(std::move(matrices));
    return view_of(py::dtype::of<double>(), owner->data(),
                   {static_cast<py::ssize_t>(owner->size()), 4, 4}, {128, 32, 8}, owner);
}

py::array matrix_of(const Pose& pose) {
    return matrices_of({&pose, 1})[py::int_(0)].cast<py::array>();
}

}  // namespace scb::python
