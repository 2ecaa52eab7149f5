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

/// A read-only array on memory that `owner` owns, and that lives as long as the array: no copy.
/// Strides are in bytes.
py::array view_of(const py::dtype& type, const void* data, Sizes shape, Sizes strides,
                  std::shared_ptr<const void> owner);

/// The same of one member of every element of a vector that `owner` owns.
template <class Element, class Member>
py::array member_view(const std::vector<Element>& elements, Member Element::*member,
                      std::shared_ptr<const void> owner) {
    const auto count = static_cast<py::ssize_t>(elements.size());
    return view_of(py::dtype::of<Member>(), elements.empty() ? nullptr : &(elements[0].*member),
                   {count}, {static_cast<py::ssize_t>(sizeof(Element))}, std::move(owner));
}

/// An array that owns these numbers from now on: no copy. `columns`: 1, or how many elements a row
/// has that consist of so many numbers.
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

/// Rows that follow each other, at addresses that numbers may have.
inline constexpr int plain_layout =
    py::array::c_style | py::array::forcecast | py::detail::npy_api::NPY_ARRAY_ALIGNED_;
using DoubleArray = py::array_t<double, plain_layout>;
using IndexArray = py::array_t<std::int64_t, plain_layout>;

/// What numpy makes of the object: of numbers, with that many dimensions, the last of that size
/// where it is above 0. Copies only where the object is no such array. Throws InputError; `shape`
/// says what is wanted: "n x 3".
DoubleArray doubles_of(const py::handle& object, const std::string& name, py::ssize_t dimensions,
                       py::ssize_t last, const std::string& shape);
/// The same of whole numbers, which must not be floats.
IndexArray indices_of(const py::handle& object, const std::string& name, py::ssize_t dimensions,
                      py::ssize_t last, const std::string& shape);

/// One rigid pose, a 4 x 4 matrix whose last row is 0 0 0 1; of None the identity. Throws
/// InputError.
Pose pose_of(const py::handle& object, const std::string& name);
/// Several, n x 4 x 4.
std::vector<Pose> poses_of(const py::handle& object, const std::string& name);
/// The matrices of poses.
py::array matrices_of(std::span<const Pose> poses);
py::array matrix_of(const Pose& pose);

}  // namespace scb::python
