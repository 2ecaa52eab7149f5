#include "app/python/binding/instances.h"

namespace scb::python {
namespace {

// Calls of a class come here. Python's own __new__ is inherited from pybind11's base class, and
// refuses a class with another tp_new.
PyObject* new_instance(PyTypeObject* type, PyObject*, PyObject*) {
    return py::detail::make_new_instance(type);
}

}  // namespace

void refuse_bare_instances(const py::module_& module) {
    for (const auto& [name, value] : module.attr("__dict__").cast<py::dict>()) {
        if (!PyType_Check(value.ptr())) continue;
        auto* type = reinterpret_cast<PyTypeObject*>(value.ptr());
        type->tp_new = new_instance;
        PyType_Modified(type);
    }
}

}  // namespace scb::python
