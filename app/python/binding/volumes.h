#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/python/binding/arrays.h"
#include "app/python/binding/hierarchy.h"

namespace scb::python {

/// Volumes of some nodes, as arrays with a row per node.
struct VolumeArrays {
    std::string kind;
    py::array nodes;
    /// By name: "centers", "radii", ...
    std::vector<std::pair<std::string, py::array>> fields;

    /// A copy of these rows.
    VolumeArrays take(const py::array& rows) const;
    /// Throws Python's AttributeError if these volumes have no such field.
    py::array field(const std::string& name) const;
};

/// The volumes of all nodes, without a copy.
VolumeArrays all_volumes(const std::shared_ptr<BuiltHierarchy>& hierarchy);

void add_volumes(py::module_& module);

}  // namespace scb::python
