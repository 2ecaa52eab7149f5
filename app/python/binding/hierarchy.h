#pragma once

#include <memory>
#include <string>

#include "app/python/binding/errors.h"
#include "scb/any_hierarchy.h"

namespace scb::python {

/// A hierarchy with its mesh and build options. Does not change.
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
