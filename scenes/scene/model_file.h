#pragma once

#include "core/platform/json_reader.h"
#include "scenes/scene/scene_file.h"

namespace scb::scenes {

/// The fields of a model that describe its mesh file; they need the field `file`.
inline constexpr const char* model_file_fields[] = {"vertices", "triangles", "published"};

/// Loads, without a name, the mesh file that the field `file` of a model names: beside the scene
/// file, or else in the folder of models. If the model has the fields `vertices` and `triangles`,
/// the mesh as read must have these numbers: another mesh under the right name would silently give
/// other results.
///
/// Throws InputError, naming file and place: there is no such file, with its expected properties;
/// the counts differ, with both; everything that load_mesh refuses. Throws MeshReaderError as
/// load_mesh does.
NamedMesh read_model_file(const JsonPlace& model, const SceneContext& context);

}  // namespace scb::scenes
