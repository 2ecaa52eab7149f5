#pragma once

#include "app/python/binding/errors.h"

namespace scb::python {

/// Queries with all their tests, of scenes, traces and recordings.
void add_queries(py::module_& module);

}  // namespace scb::python
