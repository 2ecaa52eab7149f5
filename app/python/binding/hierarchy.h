#pragma once

#include <memory>
#include <string>

#include "app/python/binding/errors.h"
#include "scb/any_hierarchy.h"

namespace scb::python {

/// A hierarchy with the mesh that it is of, and how it was built. Does not change.
struct BuiltHierarchy {
    std::shared_ptr<const Mesh> mesh;
    std::string name;  ///< of the mesh
    VolumeKind kind = VolumeKind::scb;
    BuildOptions build;
    AnyHierarchy hierarchy;

    const Topology& topology() const { return topology_of(hierarchy); }
    int depth() const;
};

void add_hierarchy(py::module_& module);

}  // namespace scb::python
