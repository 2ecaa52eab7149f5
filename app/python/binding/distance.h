#pragma once

#include "app/python/binding/errors.h"

namespace scb::python {

/// Distances of bodies on hierarchies: at one pose, and at n poses.
void add_distance(py::module_& module);

}  // namespace scb::python
