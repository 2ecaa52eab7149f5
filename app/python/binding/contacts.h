#pragma once

#include "app/python/binding/errors.h"

namespace scb::python {

/// How pairs of triangles meet.
void add_contacts(py::module_& module);

}  // namespace scb::python
