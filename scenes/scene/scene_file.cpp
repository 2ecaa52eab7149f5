#include "scenes/scene/scene_file.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/text_format.h"
#include "core/platform/input_files.h"
#include "scb/error.h"
#include "scenes/scene/camera_view.h"
#include "scenes/scene/model_json.h"
#include "scenes/scene/named_file.h"
#include "scenes/scene/pose_log.h"

namespace scb::scenes {
namespace {

/// The limit for meshes that are made by formula, since each takes only a line of a file.
constexpr std::size_t most_procedural_bytes = std::size_t{1} << 30;

/// The index of each name in its list.
using Names = std::map<std::string, std::size_t>;

LinearPath read_position(const JsonPlace& place) {
    LinearPath path;
    if (!place.value->is_object()) {
        if (!place.value->is_array())
            refuse_value(place, "three numbers, or an object with from, to, frames");
        path.from = path.to = read_vec3(place);
        return path;
    }
    check_fields(place, {"from", "to", "frames"});
    path.from = read_vec3(field(place, "from"));
    path.to = read_vec3(field(place, "to"));
    path.frames = read_number(field(place, "frames"), 1e-6, 1e9);
    return path;
}

std::vector<Turn> read_rotation(const JsonPlace& place) {
    std::vector<Turn> turns;
    const std::size_t count = array_size(place, "a list of {axis, degrees, per_frame}");
    for (std::size_t i = 0; i < count; ++i) {
        const JsonPlace entry = element(place, i);
        check_fields(entry, {"axis", "degrees", "per_frame"});
        Turn turn;
        turn.axis = read_direction(field(entry, "axis"));
        if (has(entry, "degrees")) turn.degrees = read_number(field(entry, "degrees"), -1e6, 1e6);
        if (has(entry, "per_frame"))
            turn.degrees_per_frame = read_number(field(entry, "per_frame"), -1e6, 1e6);
        turns.push_back(turn);
    }
    return turns;
}

Motion read_pose(const JsonPlace& place, bool exact) {
    if (!place.value->is_array() || place.value->size() != 12)
        refuse_value(place, "twelve numbers, [R|t] row by row");
    Pose pose;
    for (std::size_t k = 0; k < 12; ++k) {
        const auto row = static_cast<Eigen::Index>(k / 4),
                   column = static_cast<Eigen::Index>(k % 4);
        const double number = read_number(element(place, k));
        if (column < 3)
            pose.rotation(row, column) = number;
        else
            pose.translation[row] = number;
    }
    return resting_at(pose, exact, place.file + ": " + place.path);
}

std::size_t find_model(const JsonPlace& place, const Names& models) {
    const std::string name = read_plain_text(place);
    if (const auto found = models.find(name); found != models.end()) return found->second;
    refuse(place, "there is no model \"" + name + "\"; the models are " +
                      name_list(models, &Names::value_type::first) + ".");
}

Motion read_poses(const JsonPlace& place, const SceneContext& context, PoseLogs& logs) {
    const std::filesystem::path file = named_file(place, context, "log of poses");
    try {
        return logs.read(file);
    } catch (const InputError& error) {
        refuse(place, error.what());
    }
}

/// Refuses a body with two fields that say where it is.
void check_placement(const JsonPlace& place) {
    const bool moves = has(place, "position") || has(place, "rotation");
    if (has(place, "pose") && moves)
        refuse(place, "pose stands for both position and rotation; leave it or those two out.");
    if (has(place, "poses") && (moves || has(place, "pose")))
        refuse(place, "poses stands for position, rotation and pose; leave it or those out.");
}

Body read_body(const JsonPlace& place, const Names& models, const SceneContext& context,
               PoseLogs& logs) {
    check_fields(place, {"name", "model", "position", "rotation", "pose", "poses"});
    check_placement(place);
    Body body;
    body.name = read_plain_text(field(place, "name"));
    body.mesh = find_model(field(place, "model"), models);
    if (has(place, "pose")) body.motion = read_pose(field(place, "pose"), context.exact_poses);
    if (has(place, "poses")) body.motion = read_poses(field(place, "poses"), context, logs);
    if (has(place, "position")) body.motion.path = read_position(field(place, "position"));
    if (has(place, "rotation")) body.motion.turns = read_rotation(field(place, "rotation"));
    return body;
}

void add_name(const JsonPlace& place, Names& names, const std::string& name) {
    if (!names.emplace(name, names.size()).second)
        refuse(field(place, "name"), "the name \"" + name + "\" is taken; give another.");
}

Names read_models(const JsonPlace& place, const SceneContext& context, Scene& scene) {
    const std::size_t count = array_size(place, "a list of models");
    if (count == 0) refuse_value(place, "at least one model");
    Names names;
    std::size_t procedural_bytes = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const JsonPlace model = element(place, i);
        NamedMesh mesh = read_model(model, context);
        add_name(model, names, mesh.name);
        if (!has(model, "file"))
            procedural_bytes += mesh.mesh.vertices.size() * sizeof(Vec3) +
                                mesh.mesh.triangles.size() * sizeof(Triangle);
        if (procedural_bytes > most_procedural_bytes)
            refuse(model, "the models that are made by formula take more than " +
                              std::to_string(most_procedural_bytes >> 20) +
                              " MiB together; make them coarser.");
        scene.meshes.push_back(std::move(mesh));
    }
    return names;
}

void read_bodies(const JsonPlace& place, const Names& models, const SceneContext& context,
                 PoseLogs& logs, Scene& scene) {
    const std::size_t count = array_size(place, "a list of bodies");
    if (count == 0) refuse_value(place, "at least one body");
    Names names;
    for (std::size_t i = 0; i < count; ++i) {
        Body body = read_body(element(place, i), models, context, logs);
        add_name(element(place, i), names, body.name);
        scene.bodies.push_back(std::move(body));
    }
}

/// The number of frames. If there are logs, it is the number of their rows.
int read_frames(const JsonPlace& root, const PoseLogs& logs) {
    if (!has(root, "frames")) return std::max(logs.frames(), 1);
    const auto frames = static_cast<int>(read_integer(field(root, "frames"), 1, most_frames));
    if (logs.frames() != 0 && frames != logs.frames())
        refuse(field(root, "frames"),
               sentence("there are ", frames, ", and ", logs.first().string(), " has ",
                        counted(static_cast<std::uint64_t>(logs.frames()), "pose", "poses"),
                        "; leave frames out."));
    return frames;
}

}  // namespace

Scene parse_scene(std::string_view json_text, const SceneContext& context) {
    const nlohmann::json document = parse_json(json_text, context.file);
    const JsonPlace root{&document, context.file, ""};
    check_fields(root, {"scb_scene", "name", "description", "frames", "default_frame", "camera",
                        "models", "bodies"});
    read_integer(field(root, "scb_scene"), 1, 1);

    Scene scene;
    scene.name = read_text(field(root, "name"));
    if (scene.name != file_name_of(scene.name) || scene.name.size() > 100)
        refuse_value(field(root, "name"),
                     "at most 100 letters, digits, '.', '_' and '-' as a name");
    if (has(root, "description")) scene.description = read_text(field(root, "description"));
    if (has(root, "camera")) scene.camera = read_camera(field(root, "camera"));
    const Names models = read_models(field(root, "models"), context, scene);
    PoseLogs logs(context.exact_poses);
    read_bodies(field(root, "bodies"), models, context, logs, scene);
    scene.frames = read_frames(root, logs);
    if (has(root, "default_frame"))
        scene.default_frame =
            static_cast<int>(read_integer(field(root, "default_frame"), 0, scene.frames - 1));
    return scene;
}

Scene load_scene_file(const std::filesystem::path& path, const std::filesystem::path& models_dir,
                      bool exact_poses) {
    std::filesystem::path folder = path.parent_path();
    if (folder.empty()) folder = ".";
    note_input(path);
    Scene scene = parse_scene(read_text_file(path.string()),
                              {path.string(), folder, models_dir, exact_poses});
    scene.file = path;
    return scene;
}

}  // namespace scb::scenes
