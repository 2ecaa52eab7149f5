#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/python/binding/errors.h"
#include "scb/pose.h"

namespace scb::python {

using Sizes = std::vector<py::ssize_t>;

/// A read-only array on memory of `owner`, which lives as long as the array: no copy. Strides are
/// in bytes.
py::array view_of(const py::dtype& type, const void* data, Sizes shape, Sizes strides,
                  std::shared_ptr<const void> owner);

/// The same for one member of every element of a vector that belongs to `owner`.
template <class Element, class Member>
py::array member_view(const std::vector<Element>& elements, Member Element::*member,
                      std::shared_ptr<const void> owner) {
    const auto count = static_cast<py::ssize_t>(elements.size());
    return view_of(py::dtype::of<Member>(), elements.empty() ? nullptr : &(elements[0].*member),
                   {count}, {static_cast<py::ssize_t>(sizeof(Element))}, std::move(owner));
}

/// An array that takes over these numbers: no copy. `columns`: if an element has several numbers,
/// the numbers per row; else 1.
template <class Number, class Element>
py::array array_of(std::vector<Element>&& elements, py::ssize_t columns = 1) {
    const auto owner = std::make_shared<std::vector<Element>>(std::move(elements));
    const auto rows =
        static_cast<py::ssize_t>(owner->size() * sizeof(Element) / sizeof(Number)) / columns;
    const auto size = static_cast<py::ssize_t>(sizeof(Number));
    const Sizes shape = columns == 1 ? Sizes{rows} : Sizes{rows, columns},
                strides = columns == 1 ? Sizes{size} : Sizes{columns * size, size};
    return view_of(py::dtype::of<Number>(), owner->data(), shape, strides, owner);
}

/// Contiguous rows, at aligned addresses.
inline constexpr int plain_layout =
    py::array::c_style | py::array::forcecast | py::detail::npy_api::NPY_ARRAY_ALIGNED_;
using DoubleArray = py::array_t<double, plain_layout>;
using IndexArray = py::array_t<std::int64_t, plain_layout>;

/// Converts an object to an array of numbers with `dimensions` dimensions, the last of size `last`
/// if `last` is above 0. Copies only if the object is not such an array. Throws InputError; `shape`
/// names the required shape: "n x 3".
DoubleArray doubles_of(const py::handle& object, const std::string& name, py::ssize_t dimensions,
                       py::ssize_t last, const std::string& shape);
/// The same for integers; floats are refused.
IndexArray indices_of(const py::handle& object, const std::string& name, py::ssize_t dimensions,
                      py::ssize_t last, const std::string& shape);

/// Warns if a matrix was replaced by the nearest rotation, see nearest_rigid. Needs the
/// interpreter's lock.
void warn_of_correction(double correction, const std::string& name);

/// One rigid pose, a 4 x 4 matrix with the last row 0 0 0 1; None is the identity. Throws
/// InputError.
Pose pose_of(const py::handle& object, const std::string& name);
/// Several poses, n x 4 x 4.
std::vector<Pose> poses_of(const py::handle& object, const std::string& name);
/// The poses as 4 x 4 matrices.
py::array matrices_of(std::span<const Pose> poses);
py::array matrix_of(const Pose& pose);

}  // namespace scb::python
