#include "app/pictures/scene_camera.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/portable_math.h"
#include "core/base/text_format.h"
#include "core/platform/number_list.h"
#include "scb/error.h"

namespace scb::app {
namespace {

// The default angle, from the side on which the first mesh is longer: shows a horse's flank.
double azimuth_for(const scenes::Scene& scene, const Vec3& up) {
    const double azimuth = scenes::CameraView{}.azimuth;
    const Box box = bounding_box(scene.meshes[0].mesh);
    const Vec3 sides = box.upper - box.lower;
    // The directions of x and y after orbit_axes.
    const Mat3 front = render::orbit_axes(0, 0, up);
    const double along_x = std::abs(dot(Vec3(front.col(0)), sides)),
                 along_y = std::abs(dot(Vec3(front.col(2)), sides));
    return along_x >= along_y ? azimuth : 90 - azimuth;
}

/// Whether all meshes come from files whose format has y up: glTF 2.0, Section 3.4.
bool has_y_up(const scenes::Scene& scene) {
    return std::all_of(scene.meshes.begin(), scene.meshes.end(), [](const auto& mesh) {
        std::string ending = mesh.file.extension().string();
        for (char& c : ending)
            if (c >= 'A' && c <= 'Z') c += 'a' - 'A';
        return ending == ".gltf" || ending == ".glb";
    });
}

bool guesses_up(const CameraOptions& options, const scenes::Scene& scene) {
    const bool is_left_open = (options.camera.empty() || options.follows_contact()) &&
                              options.up.empty() && !scene.camera;
    return is_left_open && has_y_up(scene);
}

/// The same half space.
FacePlane with_unit_normal(const FacePlane& plane) {
    // First divide by the largest coordinate, so that no square overflows or vanishes.
    const double scale = plane.normal.cwiseAbs().maxCoeff();
    const Vec3 normal = plane.normal / scale;
    const double length = std::sqrt(squared_norm(normal));
    return {normal / length, plane.offset / scale / length};
}

}  // namespace

void CameraOptions::check() const {
    if (!camera.empty() && !follows_contact()) scenes::parse_camera(camera);
    up_vector();
    clip_plane();
}

Vec3 CameraOptions::up_vector() const {
    if (up.empty() || up == "z") return Vec3::UnitZ();
    if (up == "x") return Vec3::UnitX();
    if (up == "y") return Vec3::UnitY();
    throw InputError("--up " + up + ": give x, y or z.");
}

std::optional<FacePlane> CameraOptions::clip_plane() const {
    if (clip.empty()) return std::nullopt;
    const auto fail = [this](const std::string& reason) {
        throw InputError(
            "--clip " + clip + ": " + reason +
            "; give X,Y,Z,D, such as 0,0,1,0.5, for the points p with (X,Y,Z).p <= D.");
    };
    const std::vector<std::string> parts = split_list(clip);
    std::vector<double> values;
    for (const std::string& part : parts) {
        const std::string which = "number " + std::to_string(values.size() + 1);
        double value = 0;
        const char* const end = part.data() + part.size();
        const auto parsed = std::from_chars(part.data(), end, value);
        if (parsed.ec != std::errc{} || parsed.ptr != end) fail(which + " cannot be read");
        if (!(std::abs(value) <= max_coordinate))
            fail(which + " must be from -" + exact_number(max_coordinate) + " to " +
                 exact_number(max_coordinate));
        values.push_back(value + 0.0);  // -0 is 0
    }
    if (values.size() != 4) fail("four numbers are expected");
    const Vec3 normal(values[0], values[1], values[2]);
    if (normal == Vec3::Zero()) fail("the normal X,Y,Z must not be zero");
    return FacePlane{normal, values[3]};
}

scenes::CameraView camera_view_for(const CameraOptions& options, const scenes::Scene& scene) {
    scenes::CameraView wish;
    const bool is_asked = !options.camera.empty() && !options.follows_contact(),
               is_usual = !is_asked && !scene.camera;
    if (is_asked)
        wish = scenes::parse_camera(options.camera);
    else if (scene.camera)
        wish = *scene.camera;
    if (!options.up.empty()) wish.up = options.up_vector();
    if (guesses_up(options, scene)) wish.up = Vec3::UnitY();
    if (is_usual) wish.azimuth = azimuth_for(scene, wish.up.value_or(Vec3::UnitZ()));
    if (!wish.inset && scene.camera) wish.inset = scene.camera->inset;
    if (options.orthographic) wish.orthographic = true;
    if (!options.clip.empty()) wish.clip = options.clip_plane();
    return wish;
}

scenes::CameraView direction_of(scenes::CameraView wish) {
    wish.target.reset();
    wish.distance.reset();
    wish.view_height.reset();
    return wish;
}

std::string up_words(const CameraOptions& options, const scenes::Scene& scene) {
    return guesses_up(options, scene) ? "y up as in glTF (--up z turns it)" : "";
}

render::Camera camera_for(const scenes::CameraView& wish, const render::Support& support,
                          double aspect) {
    render::CameraFit fit;
    fit.aspect = aspect;
    fit.orthographic = wish.orthographic.value_or(false);
    fit.vertical_fov = wish.field_of_view;
    const Vec3 up = wish.up.value_or(Vec3::UnitZ());
    render::Camera camera =
        render::fit_camera(render::orbit_axes(wish.azimuth, wish.elevation, up), support, fit);
    if (wish.clip) camera.clip = with_unit_normal(*wish.clip);
    if (wish.view_height) camera.view_height = *wish.view_height;
    if (!wish.target && !wish.distance) return camera;
    const Vec3 back = camera.axes.col(2);
    const Vec3 target = wish.target.value_or(render::center_of(support));
    const double distance = wish.distance.value_or(dot(back, Vec3(camera.position - target)));
    camera.position = target + distance * back;
    // The height that a perspective camera sees at this distance, in the target's plane.
    if (wish.distance && !wish.view_height) {
        const SinCos half = sin_cos_degrees(wish.field_of_view / 2);
        camera.view_height = 2 * distance * half.sin / half.cos;
    }
    render::set_depth_range(camera, support);
    return camera;
}

render::Camera detail_camera(const scenes::CameraView& wish, const scenes::Inset& inset,
                             const render::Support& support, double aspect) {
    scenes::CameraView detail = wish;
    detail.orthographic = true;
    detail.target = inset.center;
    detail.distance.reset();
    detail.view_height = 2 * inset.radius;
    return camera_for(detail, support, aspect);
}

scenes::CameraView exact_camera_view(const scenes::CameraView& wish, const render::Camera& camera,
                                     const Vec3& center) {
    scenes::CameraView exact = wish;
    exact.orthographic = camera.orthographic;
    if (camera.orthographic) exact.view_height = camera.view_height;
    if (wish.target && wish.distance) return exact;
    exact.distance = dot(Vec3(camera.axes.col(2)), Vec3(camera.position - center));
    exact.target = camera.position - *exact.distance * camera.axes.col(2);
    return exact;
}

}  // namespace scb::app
