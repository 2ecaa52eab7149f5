#pragma once

#include <optional>
#include <string>

#include "render/view/fit_camera.h"
#include "scenes/scene/camera_view.h"
#include "scenes/scene/scene.h"

namespace scb::app {

/// How to look at the scene.
struct CameraOptions {
    std::string camera;  ///< as parse_camera reads it; empty: the scene's own wish
    bool orthographic = false;
    std::string up;                ///< x, y or z; empty: the camera's own, or z
    std::string clip;              ///< X,Y,Z,D; empty: the camera's own, or none
    bool usual_direction = false;  ///< no direction is sought, see QueryView::seek

    /// Whether the camera is to follow the contact: `--camera contact`.
    bool follows_contact() const { return camera == "contact"; }

    /// Whether neither the user nor the scene has chosen a direction of view.
    bool leaves_direction_open(const scenes::Scene& scene) const {
        return (camera.empty() || follows_contact()) && !scene.camera && !usual_direction;
    }

    /// Whether neither the user nor the scene has chosen more than a direction.
    bool leaves_distance_open(const scenes::Scene& scene) const {
        const auto& own = scene.camera;
        return camera.empty() && !usual_direction &&
               !(own && (own->target || own->distance || own->view_height));
    }

    void check() const;      ///< throws InputError if an option is invalid
    Vec3 up_vector() const;  ///< throws InputError
    /// The plane of the world with its normal as given; none if not given. Throws InputError.
    std::optional<FacePlane> clip_plane() const;
};

/// The wish in effect: the command line's, else the scene's, else the default angles with z up, or
/// y up if all meshes are glTF files.
scenes::CameraView camera_view_for(const CameraOptions& options, const scenes::Scene& scene);

/// The wish for a direction alone, so that camera_for fits the rest.
scenes::CameraView direction_of(scenes::CameraView wish);

/// A text about the axis that points up, if it was guessed; else empty.
std::string up_words(const CameraOptions& options, const scenes::Scene& scene);

/// The camera of a wish, for a view of this aspect (width / height). Values missing in the wish are
/// fitted to `support`.
render::Camera camera_for(const scenes::CameraView& wish, const render::Support& support,
                          double aspect);

/// A camera with the same axes for a detail: a ball of `radius` about `center` fills the view.
/// Orthographic, so that lengths in the view can be compared.
render::Camera detail_camera(const scenes::CameraView& wish, const scenes::Inset& inset,
                             const render::Support& support, double aspect);

/// The camera as a wish with all values: `--camera` reads it back as the same view. `center`: of
/// the scene; the distance is measured from it.
scenes::CameraView exact_camera_view(const scenes::CameraView& wish, const render::Camera& camera,
                                     const Vec3& center);

}  // namespace scb::app
