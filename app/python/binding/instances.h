#pragma once

#include "app/python/binding/errors.h"

namespace scb::python {

/// Ensures that objects of the module's classes come only from their constructors and functions.
/// With pybind11 alone, `Mesh.__new__(Mesh)` gives an object with uninitialized memory.
void refuse_bare_instances(const py::module_& module);

}  // namespace scb::python
