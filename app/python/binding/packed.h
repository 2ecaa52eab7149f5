#pragma once

#include "app/python/binding/errors.h"

namespace scb::python {

/// Packed hierarchies, and queries of them. After add_collide and add_collide_poses, whose
/// functions get overloads.
void add_packed(py::module_& module);

}  // namespace scb::python
