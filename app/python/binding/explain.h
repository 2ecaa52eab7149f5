#pragma once

#include "app/python/binding/errors.h"

namespace scb::python {

void add_explain(py::module_& module);

}  // namespace scb::python
