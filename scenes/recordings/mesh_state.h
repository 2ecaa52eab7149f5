#pragma once

#include <memory>
#include <string>

#include "scb/mesh.h"
#include "scenes/recordings/record.h"

namespace scb::scenes {

/// A mesh of a recording, as it is from some frame on.
struct MeshState {
    std::string name;
    std::shared_ptr<const Mesh> mesh;  ///< as it was recorded: vertices need not be finite
    /// The same where all are. Else each triangle that has one that is not is a single point, at
    /// some other vertex.
    std::shared_ptr<const Mesh> finite;
    int coordinate_bytes = 8;
    /// All of it finite, as it was recorded first with these triangles: which vertices are one.
    std::shared_ptr<const Mesh> rest;
    double reach = 0;  ///< the largest |coordinate|
    int told_at = 0;   ///< the frame at which it was recorded last
    int version = 0;   ///< counts the changes

    /// Returns whether the mesh has changed. Throws InputError, a sentence that begins with `what`,
    /// where the record is no mesh.
    bool take(const RecordedMesh& record, int frame, const std::string& what);
};

}  // namespace scb::scenes
