#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

#include "render/draw/renderer.h"
#include "render/gl/context.h"
#include "render/view/fit_camera.h"

namespace scb::render {

inline GlBackend any_backend() {
    return is_compiled_in(GlBackend::osmesa) ? GlBackend::osmesa : GlBackend::egl;
}

struct Drawing {
    Context context{any_backend()};
    Renderer renderer{context};
};

/// Two triangles in the plane y = 0: the lower right and the upper left half, seen from -y.
inline Mesh quad() {
    Mesh mesh;
    mesh.vertices = {Vec3(-1, 0, -1), Vec3(1, 0, -1), Vec3(1, 0, 1), Vec3(-1, 0, 1)};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

/// A picture of one pane that shows the volumes, with ids 1, 2, ... and the colors of categories.
inline Picture picture_of(const std::vector<AnyVolume>& volumes, int width, int height,
                          int samples) {
    Picture picture;
    picture.width = width;
    picture.height = height;
    picture.samples = samples;
    Pane pane;
    pane.viewport = {0, 0, width, height};
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        const auto shade = static_cast<std::uint8_t>(60 + 50 * (i % 4));
        pane.volumes.push_back({volumes[i], {shade, 120, 200}, static_cast<std::uint32_t>(i + 1)});
    }
    CameraFit options;
    options.aspect = static_cast<double>(width) / height;
    pane.camera = fit_camera(orbit_axes(35, 25), support_of(volumes), options);
    picture.panes.push_back(pane);
    return picture;
}

/// Two slabs with the axes of a frame as their normals.
inline Scb2 two_slabs(const Vec3& c, double r, const Mat3& axes, double e, double f, double e2,
                      double f2) {
    return {c, r, {Slab{axes.col(2), e, f}, Slab{axes.col(0), e2, f2}}};
}

/// Slabs at many tilts, one that leaves the center out, discs (e == f), a ball and boxes, some of
/// them overlapping; balls with two slabs, one flat, one without its second cut.
inline std::vector<AnyVolume> assorted_volumes() {
    std::vector<AnyVolume> volumes;
    for (int i = 0; i < 12; ++i) {
        const Mat3 axes = orbit_axes(i * 37.0, i * 29.0 - 80);
        const Vec3 c(2.1 * (i % 4), 1.9 * (i / 4), 0.4 * (i % 3));
        volumes.push_back(Scb{c, 0.7 + 0.05 * i, axes.col(2), 0.1 + 0.03 * i, -0.25 + 0.02 * i});
    }
    volumes.push_back(Scb{Vec3(1, -1.8, 0.5), 0.9, orbit_axes(10, 40).col(2), 0.8, 0.45});
    volumes.push_back(Scb{Vec3(3, -1.8, 0.5), 0.9, orbit_axes(60, 20).col(2), 0.2, 0.2});
    volumes.push_back(Scb{Vec3(5, -1.8, 0.5), 0.9, orbit_axes(-50, 65).col(2), 0, 0});
    volumes.push_back(Ball{Vec3(7, -1.8, 0.2), 0.8});
    for (int i = 0; i < 3; ++i)
        volumes.push_back(Obb{Vec3(8.4, 1.9 * i, 0.3), orbit_axes(i * 50.0 + 5, i * 30.0 + 15),
                              Vec3(0.8, 0.5, i == 2 ? 0.0 : 0.2)});
    for (int i = 0; i < 6; ++i)
        volumes.push_back(two_slabs(Vec3(1.6 * i - 1, -4, 0.2 * i), 1.1,
                                    orbit_axes(i * 41.0, i * 27.0 - 70), 0.1 + 0.08 * i, -0.2,
                                    i == 2 ? 0 : 0.5, i == 2 ? 0 : 0.04 * i - 0.6));
    volumes.push_back(two_slabs(Vec3(9.2, -4, 0), 0.9, orbit_axes(30, 20), 0.3, 0, 0.9, -0.9));
    return volumes;
}

}  // namespace scb::render
