#pragma once

#include "scenes/scene/scene_file.h"
#include "scenes/text/json_reader.h"

namespace scb::scenes {

/// The fields of a model that say what its mesh file is; they need the field `file`.
inline constexpr const char* model_file_fields[] = {"vertices", "triangles", "published"};

/// Loads, without a name, the mesh file that the field `file` of a model names: beside the scene
/// file, or else in the folder of models. Where the model has the fields `vertices` and
/// `triangles`, the mesh as read must have so many: another mesh under the right name would
/// silently give other results.
///
/// Throws InputError, naming file and place: there is no such file, with what the model says of it;
/// the counts differ, with both; whatever load_mesh refuses. Throws MeshReaderError as load_mesh
/// does.
NamedMesh read_model_file(const JsonPlace& model, const SceneContext& context);

}  // namespace scb::scenes
