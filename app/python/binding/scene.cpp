#include "app/python/binding/scene.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <map>

#include "app/python/binding/arrays.h"
#include "app/python/binding/mesh.h"
#include "app/python/binding/source.h"
#include "core/base/text_format.h"
#include "scenes/scene/builtin.h"
#include "scenes/scene/pose_rows.h"

namespace scb::python {
namespace {

SharedScene load_scene(const py::args& names, const py::object& pose,
                       const std::optional<std::string>& models_dir, bool exact_pose) {
    SharedScene result;
    app::SceneOptions& options = result.options;
    options = source_of(names);
    if (models_dir) options.models_dir = *models_dir;
    options.exact_pose = exact_pose;
    if (!pose.is_none()) {
        const scenes::PoseRows rows = scenes::rows_of(pose_of(pose, "pose"));
        options.pose.assign(rows.begin(), rows.end());
    }
    {
        const py::gil_scoped_release unlocked;
        result.scene = std::make_shared<scenes::Scene>(options.load());
    }
    for (const scenes::Body& body : result.scene->bodies)
        warn_of_correction(body.motion.correction, "the pose of " + body.name);
    return result;
}

/// A body's poses: one, or one per frame.
std::vector<scenes::PoseKey> given_poses(const py::handle& matrices, const std::string& name) {
    const py::array array = py::array::ensure(matrices);
    const bool is_one = matrices.is_none() || !array || array.ndim() != 3;
    std::vector<Pose> poses;
    if (is_one)
        poses.push_back(pose_of(matrices, name));
    else
        poses = poses_of(matrices, name);
    if (poses.empty() || poses.size() > static_cast<std::size_t>(scenes::most_frames))
        refuse(name, "give 1 to 1,000,000 poses; there are " + std::to_string(poses.size()) + ".");
    std::vector<scenes::PoseKey> told;
    for (std::size_t frame = 0; frame < poses.size(); ++frame)
        told.push_back({static_cast<int>(frame), poses[frame]});
    return told;
}

SharedScene scene_of(const py::dict& bodies, const py::dict& poses, const std::string& name) {
    if (bodies.empty()) refuse("bodies", "give one body or more.");
    for (const auto& [body, pose] : poses)
        if (!bodies.contains(body))
            refuse("poses[" + std::string(py::repr(body)) + "]", "there is no such body.");
    auto scene = std::make_shared<scenes::Scene>();
    scene->name = scenes::file_name_of(name);
    std::map<const Mesh*, std::size_t> places;  // of shared meshes; lookups only
    for (const auto& [key, value] : bodies) {
        if (!py::isinstance<py::str>(key) || !py::isinstance<SharedMesh>(value))
            throw py::type_error("bodies: give meshes (scb.Mesh) by names (str).");
        const auto body = key.cast<std::string>();
        const auto& mesh = value.cast<const SharedMesh&>();
        const auto [place, is_new] = places.try_emplace(mesh.mesh.get(), scene->meshes.size());
        if (is_new) scene->meshes.push_back({mesh.name, *mesh.mesh});
        scenes::Motion motion;
        motion.told = given_poses(poses.contains(key) ? py::object(poses[key]) : py::none(),
                                  "poses['" + body + "']");
        const auto frames = static_cast<int>(motion.told.size());
        if (frames > 1 && scene->frames > 1 && frames != scene->frames)
            refuse("poses['" + body + "']",
                   "there are " + std::to_string(frames) + " poses, and another body has " +
                       std::to_string(scene->frames) + "; give all bodies as many, or one.");
        scene->frames = std::max(scene->frames, frames);
        scene->bodies.push_back({body, place->second, std::move(motion)});
    }
    SharedScene result;
    result.options.names = {scene->name};
    result.options.given = scene;
    result.scene = std::move(scene);
    return result;
}

std::size_t body_of(const SharedScene& s, const std::string& name) {
    const std::vector<scenes::Body>& bodies = s.scene->bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (bodies[i].name == name) return i;
    refuse("'" + name + "'", "is not a body of the scene '" + s.scene->name + "'; it has " +
                                 name_list(bodies, &scenes::Body::name) + ".");
}

int frame_of(const SharedScene& s, std::int64_t frame) {
    if (frame < 0 || frame >= s.scene->frames)
        refuse("frame " + std::to_string(frame), "the scene '" + s.scene->name +
                                                     "' has the frames 0 to " +
                                                     std::to_string(s.scene->frames - 1) + ".");
    return static_cast<int>(frame);
}

/// None means all frames.
std::vector<int> frames_of(const SharedScene& s, const py::object& frames) {
    std::vector<int> result;
    if (frames.is_none()) {
        for (int frame = 0; frame < s.scene->frames; ++frame) result.push_back(frame);
        return result;
    }
    const IndexArray given = indices_of(frames, "frames", 1, 0, "n");
    for (py::ssize_t i = 0; i < given.size(); ++i) result.push_back(frame_of(s, *given.data(i)));
    return result;
}

py::array body_poses(const SharedScene& s, const std::string& body, const py::object& frames) {
    const scenes::Motion& motion = s.scene->bodies[body_of(s, body)].motion;
    std::vector<Pose> poses;
    for (const int frame : frames_of(s, frames)) poses.push_back(scenes::pose_at(motion, frame));
    return matrices_of(poses);
}

py::array relative_poses(const SharedScene& s, const std::string& a, const std::string& b,
                         const py::object& frames) {
    const std::vector<scenes::Body>& bodies = s.scene->bodies;
    const scenes::Motion &of_a = bodies[body_of(s, a)].motion, &of_b = bodies[body_of(s, b)].motion;
    std::vector<Pose> poses;
    for (const int frame : frames_of(s, frames))
        poses.push_back(relative_pose(scenes::pose_at(of_a, frame), scenes::pose_at(of_b, frame)));
    return matrices_of(poses);
}

SharedMesh body_mesh(const SharedScene& s, const std::string& body) {
    const scenes::NamedMesh& mesh = s.scene->meshes[s.scene->bodies[body_of(s, body)].mesh];
    if (mesh.mesh.triangles.empty())
        refuse("'" + body + "'", "its objects have no triangles; ask for what was recorded.");
    return {{s.scene, &mesh.mesh}, mesh.name};
}

std::vector<std::string> body_names(const SharedScene& s) {
    std::vector<std::string> names;
    for (const scenes::Body& body : s.scene->bodies) names.push_back(body.name);
    return names;
}

}  // namespace

void add_scene(py::module_& module) {
    py::class_<SharedScene>(module, "Scene", py::is_final(),
                            R"(Bodies and how they move, frame by frame. A scene does not change.)")
        .def(py::init(&scene_of), py::arg("bodies"), py::arg("poses") = py::dict(),
             py::arg("name") = "scene",
             R"(Make a scene of meshes, which are copied.

bodies: meshes by the names of bodies. poses: by the names of bodies, body frame to world, one
4 x 4 or 3 x 4 matrix, or n of these for n frames; bodies that are left out stay at the identity.

Raises InputError where a pose is not rigid, or bodies have different numbers of frames.)")
        .def_property_readonly(
            "name", [](const SharedScene& s) { return s.scene->name; }, "Its name.")
        .def_property_readonly("bodies", body_names, "The names of its bodies, in order.")
        .def_property_readonly(
            "frames", [](const SharedScene& s) { return s.scene->frames; },
            "How many frames there are: 0 to frames - 1.")
        .def_property_readonly(
            "default_frame", [](const SharedScene& s) { return s.scene->default_frame; },
            "The frame that pictures show where none is asked for.")
        .def("mesh", body_mesh, py::arg("body"), "The mesh of a body, without a copy.")
        .def("poses", body_poses, py::arg("body"), py::arg("frames") = py::none(),
             R"(n x 4 x 4 float64, body frame to world, of these frames or all.)")
        .def(
            "relative_poses", relative_poses, py::arg("a"), py::arg("b"),
            py::arg("frames") = py::none(),
            R"(n x 4 x 4 float64, from b's frame to a's, of these frames or all: what collide takes.)")
        .def("__repr__", [](const SharedScene& s) {
            return "<scb.Scene '" + s.scene->name + "': " + name_list(body_names(s)) + "; " +
                   std::to_string(s.scene->frames) + " frames>";
        });
    module.def("load_scene", load_scene, py::kw_only(), py::arg("pose") = py::none(),
               py::arg("models_dir") = py::none(), py::arg("exact_pose") = false,
               R"(Load what the command line names as SCENE.

One built-in name, scene file, mesh file or recording; or two mesh files, of which `pose` places the
second in the frame of the first. models_dir, or else the environment variable SCB_MODELS, says where
meshes are that are not where a scene names them. exact_pose: refuse a pose in a file whose R^T R
differs from the identity by more than 1e-9. Otherwise, up to 1e-3, the nearest rotation is taken.

Raises InputError.)");
    module.def(
        "scene_names",
        [] {
            std::vector<std::string> names;
            for (const scenes::BuiltinScene& scene : scenes::builtin_scenes())
                names.push_back(scene.name);
            return names;
        },
        "The names of the built-in scenes.");
    module.def(
        "relative_pose",
        [](const py::object& a, const py::object& b) {
            return matrix_of(relative_pose(pose_of(a, "a"), pose_of(b, "b")));
        },
        py::arg("a"), py::arg("b"),
        R"(inverse(a) b, 4 x 4: where b is as seen from a, of two poses from body to world.

Raises InputError where one is not rigid.)");
}

}  // namespace scb::python
