#pragma once

#include <memory>
#include <string>

#include "scb/mesh.h"
#include "scenes/recordings/record.h"

namespace scb::scenes {

/// The current state of a recorded mesh.
struct MeshState {
    std::string name;
    std::shared_ptr<const Mesh> mesh;  ///< as recorded; vertices may be non-finite
    /// `mesh` if all its vertices are finite. Else a copy, in which each triangle with a non-finite
    /// vertex is a single point at another vertex.
    std::shared_ptr<const Mesh> finite;
    int coordinate_bytes = 8;
    /// The first finite state with these triangles, which decides which vertices are joined.
    std::shared_ptr<const Mesh> rest;
    double reach = 0;     ///< the largest |coordinate|
    int recorded_at = 0;  ///< the frame of the latest change
    int version = 0;      ///< counts the changes

    /// Takes a record. Returns whether the mesh has changed. Throws InputError, a sentence that
    /// begins with `what`, if the record is no mesh.
    bool take(const RecordedMesh& record, int frame, const std::string& what);
};

}  // namespace scb::scenes
