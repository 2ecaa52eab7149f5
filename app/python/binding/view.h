#pragma once

#include "app/python/binding/errors.h"

namespace scb::python {

/// The page of `scb view`.
void add_view(py::module_& module);

}  // namespace scb::python
