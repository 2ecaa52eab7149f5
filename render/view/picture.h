#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/volumes/any_volume.h"
#include "render/files/image.h"
#include "render/view/camera.h"
#include "scb/pose.h"

namespace scb::render {

/// A mesh that a Renderer has uploaded to the GPU; valid for that renderer, until it is released.
struct MeshHandle {
    std::uint32_t index = 0;
};

/// A volume in the world frame. It is opaque if the color's alpha is 255 and translucent below
/// that; with alpha 0 it is not drawn. A volume with the eye inside shows its inner side. A ball or
/// SCB of radius 0 is not drawn; a disc (e == f) or a flat box is drawn flat.
///
/// The rounding of depths must not decide which of two coplanar surfaces is in front. So each
/// surface is drawn nearer by (id mod 32) millionths of its distance from the eye (along the view
/// axis). This suffices unless it is seen within a few degrees of its edge. The surface with the
/// larger id mod 32 wins, also from up to 31 millionths of the distance behind. If ids are equal
/// mod 32, rounding decides, pixel by pixel. If even the rounded depths are equal, the surface that
/// is earlier in the list wins (SCBs and balls before boxes).
struct VolumeInstance {
    AnyVolume volume;
    Rgba8 color;
    std::uint32_t id = 0;  ///< goes into the id buffer, below 2^31; also decides between coplanar
                           ///< surfaces
    bool hatched = false;  ///< striped in its color: a second kind of things in the same colors
};

/// A mesh in its place: flat shaded, both sides alike, opaque. If a volume's surface coincides with
/// the mesh, the volume wins, since it is drawn nearer by at least 11 millionths of its distance.
struct MeshDraw {
    MeshHandle mesh;
    Pose pose;
    Rgba8 color{176, 180, 186};
    std::vector<Rgba8> triangle_colors;  ///< one for each triangle; empty: `color` for all
    bool edges = false;                  ///< draw the triangles' edges, about one pixel wide
    std::uint32_t first_id = 0;  ///< triangle t has the id first_id + t; 0: the mesh has no ids (0)
    double dim = 0;              ///< 0 to 1: how far the colors fade into the background
    bool hatched = false;        ///< see VolumeInstance::hatched
    /// The triangles to draw, if not all: each index once, ascending.
    std::optional<std::vector<std::uint32_t>> chosen = std::nullopt;
    bool backdrop = false;  ///< drawn before everything else, hides nothing; without ids
    /// The strength of light and shade, 0 to 1. At 0 each triangle has exactly its color, so that
    /// readers find the colors of a legend.
    double shading = 1;
    /// The opacity, 0 to 1, with which the parts behind something else are drawn over it. So the
    /// things in front look translucent.
    double shine_through = 0;
};

/// A flat convex polygon in the world, in exactly its color, drawn nearer by 35 millionths of its
/// distance: in front of the surfaces that it lies in, and behind segments that lie in it.
struct Area {
    std::vector<Vec3> corners;  ///< in order
    Rgba8 color;
    std::uint32_t id = 0;
    double shine_through = 0;  ///< see MeshDraw::shine_through
};

/// A straight line in the world, of constant width in the picture. It faces the viewer at the depth
/// of its middle, drawn nearer by 70 millionths of its distance. So it is in front of the surface
/// that it lies in, except for half its width if that surface is tilted.
struct Segment {
    Vec3 from;
    Vec3 to;
    Rgba8 color;
    std::uint32_t id = 0;
    double width = 2;     ///< pixels
    bool on_top = false;  ///< drawn over everything else of the pane, never hidden
    /// For a line in which surfaces meet. It is drawn over translucent things. Where something
    /// opaque is more than three pixels in front of it, it is dashed in this color and at most 1.5
    /// pixels wide. The surfaces that meet there are usually less far in front.
    std::optional<Rgba8> hidden_color = std::nullopt;
};

/// A rectangle of pixels of a picture; (x, y) is the top left pixel.
struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// Things of a pane to outline, all together, in front of everything except the overlay.
struct Outline {
    std::vector<std::uint32_t> ids;  ///< ascending; without a pixel of these ids there is no
                                     ///< outline
    Rgba8 color;
    Rgba8 halo;     ///< a thinner ring about it
    int width = 2;  ///< pixels
};

/// A view within a picture: one camera, clipped to its rectangle. The order of drawing: meshes that
/// are a backdrop; opaque meshes, volumes, areas and segments by depth, at equal depth the first in
/// this order; then what shines through; then translucent volumes from far to near (by the distance
/// of their centers along the view axis, ties by id, then by position in the list), their back
/// sides before their fronts; then the segments that have a color where they are hidden; then those
/// that are on top; then the outline.
struct Pane {
    PixelRect viewport;
    Camera camera;
    std::optional<Rgba8> background;  ///< if it differs from the picture's
    std::vector<MeshDraw> meshes;
    std::vector<VolumeInstance> volumes;
    std::vector<Area> areas;
    std::vector<Segment> segments;
    Outline outline;
    /// If set, makes the meshes, volumes and segments of the pane when it is drawn. So the panes of
    /// a sheet do not need memory all at once. An outline must be in the pane before.
    std::function<void(Pane&)> add_contents = nullptr;
};

/// The input of a Renderer. Panes are drawn in order; where two overlap, the later one covers the
/// earlier one completely.
///
/// The id of a pixel is the id of the nearest surface at the pixel's center (with 4 samples: at the
/// center of its top left quarter), no matter how translucent.
struct Picture {
    int width = 1280;
    int height = 720;
    int samples = 4;  ///< 1, or 4: twice the resolution in both directions, averaged
    Rgba8 background{255, 255, 255};
    std::vector<Pane> panes;
};

}  // namespace scb::render
