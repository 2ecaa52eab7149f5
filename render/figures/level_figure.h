#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/level_statistics.h"
#include "render/figures/volume_colors.h"
#include "render/overlay/figure_layout.h"
#include "render/plots/length_histogram.h"
#include "render/view/fit_camera.h"
#include "render/view/picture.h"
#include "scb/level_cover.h"

namespace scb::render {

/// A body for pictures of levels, at one frame. Does not own the objects that it points to.
struct LevelBody {
    std::string name;
    const Mesh* mesh = nullptr;
    MeshHandle handle;  ///< of the mesh, if the style or the figure shows it
    Pose pose;
    const Tree* tree = nullptr;
    std::uint32_t first_id = 1;  ///< node i has the id first_id + i
};

/// The style of volumes and meshes.
struct LevelStyle {
    ColorScale colors;
    double opacity = 1;       ///< of the volumes; translucent below 1, none at 0
    bool mesh = false;        ///< draw the bodies' meshes too
    bool mesh_edges = false;  ///< with their edges
    const Theme* theme = &light_theme;
};

/// Statistics of a cover, per body and in all.
struct LevelNumbers {
    std::vector<VolumeStatistics> bodies;
    VolumeStatistics all;
};
LevelNumbers level_numbers(const std::vector<LevelBody>& bodies, int level);

/// The definitions of d and τ for such volumes: "d = 2r, τ = e − f".
std::string_view lengths_words(VolumeFamily family);

/// Mean thickness and summed volume for a reader: 0 if they are only rounding noise.
std::string thickness_text(const VolumeStatistics& statistics);
std::string volume_text(const VolumeStatistics& statistics);

/// The support of everything in pictures of these levels: the volumes of their covers, which
/// contain the meshes. The bodies must outlive the result.
Support support_of_levels(const std::vector<LevelBody>& bodies, const std::vector<int>& levels);

/// The lengths of the volumes of all bodies, on the style's scale.
LengthHistogram level_lengths(const std::vector<LevelBody>& bodies, int level,
                              const LevelStyle& style);

/// The view of a level: its volumes (see level_cover; of consecutive equal volumes, only the first)
/// and, depending on the style, the meshes.
Pane level_pane(const PixelRect& viewport, const Camera& camera,
                const std::vector<LevelBody>& bodies, int level, const LevelStyle& style);

/// The content of one picture of a level.
struct LevelFigure {
    std::string title;
    std::string subtitle;
    std::vector<LevelBody> bodies;
    int level = 0;
    LevelStyle style;
    Camera camera;               ///< for the view of figure_layout
    Vec3 center = Vec3::Zero();  ///< of the scene, for the scale bar
    std::optional<Detail> detail;
    /// Without a detail: places the camera of a small view of the meshes alone, by its aspect. So a
    /// reader knows the bodies that the volumes bound.
    std::function<Camera(double aspect)> camera_of_meshes;
    bool with_panel = true;  ///< else the view alone
};

/// Composes the picture and its overlay: view, numbers, legend, magnified detail.
Picture compose(const LevelFigure& figure, int width, int height, int samples, Overlay& overlay);

}  // namespace scb::render
