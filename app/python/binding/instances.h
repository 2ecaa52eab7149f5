#pragma once

#include "app/python/binding/errors.h"

namespace scb::python {

/// Lets objects of the module's classes come from nothing but their constructors and functions. By
/// pybind11 alone, `Mesh.__new__(Mesh)` gives an object whose memory nobody has written.
void refuse_bare_instances(const py::module_& module);

}  // namespace scb::python
