#pragma once

#include <memory>
#include <string>

#include "app/python/binding/errors.h"
#include "scb/mesh.h"

namespace scb::python {

/// A mesh shared by any number of Python objects, and its name in errors.
struct SharedMesh {
    std::shared_ptr<const Mesh> mesh;
    std::string name;
};

void add_mesh(py::module_& module);

}  // namespace scb::python
