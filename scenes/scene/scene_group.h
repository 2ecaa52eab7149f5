#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scb::scenes {

/// Built-in scenes that are measured together, under one name in commands that measure scenes.
struct SceneGroup {
    std::string_view name;
    std::span<const std::string_view> scenes;
};

/// The seven scenes of Table 3 of the paper, in its order.
inline constexpr std::string_view table_3_scenes[] = {
    "spheres-l1", "spheres-l2", "knots-l1", "knots-l2", "knots-l3", "horses", "hands"};

/// Each has two bodies of a CAD model, which overlap, turn, and separate. Most have long thin
/// triangles, a weakness of slab cut balls according to the paper (Section 6).
inline constexpr std::string_view cad_scenes[] = {"aatbase", "tray_bottom", "boeing",    "cheese",
                                                  "tr12j",   "anchor",      "cycloidal", "tube"};

/// Two bodies with faces in common planes and edges that touch, as in assemblies. In all but the
/// last, B moves along an axis without a turn. The last four have shapes by formula.
inline constexpr std::string_view aligned_scenes[] = {"aatbase-aligned",     "tray_bottom-aligned",
                                                      "plate_holes-aligned", "anchor-aligned",
                                                      "boeing-aligned",      "cheese-aligned",
                                                      "tube-aligned",        "stack",
                                                      "shaft-in-bore",       "box-grid",
                                                      "mesh-on-itself"};

inline constexpr SceneGroup scene_groups[] = {
    {"table-3", table_3_scenes}, {"cad", cad_scenes}, {"cad-aligned", aligned_scenes}};

/// The group of this name, or null.
const SceneGroup* find_scene_group(std::string_view name);

/// Whether the group has a scene of this name.
bool has_scene(const SceneGroup& group, std::string_view name);

/// The scenes to measure.
struct MeasuredScenes {
    std::vector<std::string> names;     ///< for load_scene, one scene each; no groups
    std::vector<std::string> left_out;  ///< a sentence for each scene whose mesh is missing
};

/// The named scenes, with groups replaced by their scenes; `defaults` if none is named. A scene of
/// a group or of `defaults` is left out if the folder of models lacks its mesh. A scene that is
/// named itself is never left out: loading it reports the missing mesh. Throws InputError if all
/// are left out.
MeasuredScenes measured_scenes(const std::vector<std::string>& names,
                               const std::vector<std::string>& defaults,
                               const std::filesystem::path& models_dir);

}  // namespace scb::scenes
