#pragma once

#include "app/python/binding/errors.h"

namespace scb::python {

void add_collide_poses(py::module_& module);

}  // namespace scb::python
