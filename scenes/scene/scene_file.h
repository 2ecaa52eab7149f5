#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "scenes/scene/scene.h"

namespace scb::scenes {

/// The source of a scene file.
struct SceneContext {
    std::string file;                  ///< its path or name, for messages
    std::filesystem::path folder;      ///< relative mesh paths start here; empty: nowhere
    std::filesystem::path models_dir;  ///< or else here; empty: nowhere
    bool exact_poses = false;          ///< see LoadOptions
};

/// Reads a scene from JSON text. The schema (`scenes/README.md` has examples); [] marks what may be
/// left out:
///
///     scb_scene        1, the version of the schema
///     name             letters, digits, '.', '_', '-'; names output files
///     [description]    one sentence
///     [frames]         1 to 1,000,000; default 1, or the number of poses in logs
///     [default_frame]  0 to frames - 1; default 0
///     [camera]         see CameraView: [azimuth], [elevation], [distance], [target], [up],
///                      [field_of_view], [orthographic], [view_height], [inset {center, radius}]
///     models           a list, at least one, of
///       name           by which bodies refer to it
///       and one of
///         file         a path of a mesh file
///         icosphere    {subdivisions, [radius]}
///         torus_knot   {[p], [q], [major_radius], [minor_radius], [tube_radius], [sides],
///                      [rings], [offset], [offset_turns]}, see TorusKnot
///         box          {[size: x, y, z], [subdivisions]}
///         plane        {[size: x, y], [cells: x, y]}
///         cone         {[radius], [height], [sides], [segments], [capped]}
///         cylinder     the same
///         soup         {[count], [size], [triangle_size], [seed]}
///       [vertices]     with file: how many the mesh must have as it is read, 1 to 2^28; another
///                      mesh under the name of the file is refused
///       [triangles]    the same
///       [published]    with file: where such a mesh is published, for the message where there is
///                      none
///       [normalize]    "unit-box": the mesh's box is centered and its longest side made 1
///       [scale]        a factor above 0, after that
///       [stored_rotation]  {axis, degrees}: after that, vertices are written in a frame turned by
///                      this rotation R, that is multiplied by the inverse of R; a body that turns
///                      by R first looks as before
///     bodies           a list, at least one, of
///       name
///       model          the name of a model
///       [position]     [x, y, z], or {from, to, frames}, see LinearPath; default the origin
///       [rotation]     a list of {axis, [degrees], [per_frame]}, applied in order, see Turn
///       [pose]         instead of these two: twelve numbers, the 3x4 matrix [R|t] row by row; see
///                      nearest_rigid
///       [poses]        instead of these three: a file with the pose at each frame, see PoseLogs
///
/// Throws InputError, one sentence that names the file and the place: broken JSON (line and
/// column); nesting more than max_json_depth deep; a field that is missing, unknown, repeated, of
/// the wrong type or out of range; a name or path that is empty or has control characters; an
/// unknown model; a mesh that cannot be made or loaded; a pose that is not rigid; a log of poses
/// that PoseLogs refuses, or that has not `frames` poses; more than 2^25 procedural triangles
/// altogether.
Scene parse_scene(std::string_view json_text, const SceneContext& context);

/// Reads a scene file; `models_dir` and `exact_poses` as in SceneContext. Throws InputError.
Scene load_scene_file(const std::filesystem::path& path, const std::filesystem::path& models_dir,
                      bool exact_poses = false);

}  // namespace scb::scenes
