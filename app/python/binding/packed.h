#pragma once

#include <memory>
#include <string>

#include "app/python/binding/errors.h"
#include "scb/any_packed.h"

namespace scb::python {

/// A packed hierarchy with its mesh and layout. Does not change.
struct BuiltPacked {
    std::shared_ptr<const Mesh> mesh;
    std::string name;  ///< of the mesh
    VolumeKind kind = VolumeKind::scb2;
    PackedLayout layout;
    AnyPacked packed;
};
using SharedPacked = std::shared_ptr<BuiltPacked>;

/// Packed hierarchies, and queries of them. After add_collide and add_collide_poses, whose
/// functions get overloads.
void add_packed(py::module_& module);

}  // namespace scb::python
