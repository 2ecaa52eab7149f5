#include "render/draw/volume_painter.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace scb::render {

namespace {

/// A rectangle in normalised device coordinates; starts as the whole view.
struct Rectangle {
    double left = -1, bottom = -1, right = 1, top = 1;

    void clip(const Rectangle& other) {
        left = std::max(left, other.left);
        bottom = std::max(bottom, other.bottom);
        right = std::min(right, other.right);
        top = std::min(top, other.top);
    }
};

struct Extent {
    double lower, upper;
};

/// The slopes x / depth of the two lines from the eye that touch a disc; all of the disc must be in
/// front of the eye.
Extent touching_slopes(double x, double depth, double r) {
    const double root = r * std::sqrt(std::max(0.0, x * x + depth * depth - r * r));
    const double denominator = depth * depth - r * r;
    return {(x * depth - root) / denominator, (x * depth + root) / denominator};
}

Rectangle around_ball(const Vec3& c, double r, const EyeView& view) {
    Extent x{c[0] - r, c[0] + r}, y{c[1] - r, c[1] + r};
    if (!view.camera.orthographic) {
        // A ball that reaches the eye plane has no bounded image.
        if (-c[2] - r <= 1e-3 * r) return {};
        x = touching_slopes(c[0], -c[2], r);
        y = touching_slopes(c[1], -c[2], r);
    }
    return {x.lower / view.half_width, y.lower / view.half_height, x.upper / view.half_width,
            y.upper / view.half_height};
}

/// `axes` are the box's half axes, in eye space.
Rectangle around_box(const Vec3& center, const std::array<Vec3, 3>& axes, const EyeView& view) {
    Rectangle result{1e30, 1e30, -1e30, -1e30};
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 p = center;
        for (int i = 0; i < 3; ++i)
            p += (corner >> i & 1 ? 1.0 : -1.0) * axes[static_cast<std::size_t>(i)];
        const double depth = view.camera.orthographic ? 1 : -p[2];
        if (depth < view.near_plane * 0.5) return {};
        const double x = p[0] / depth / view.half_width, y = p[1] / depth / view.half_height;
        result.left = std::min(result.left, x);
        result.right = std::max(result.right, x);
        result.bottom = std::min(result.bottom, y);
        result.top = std::max(result.top, y);
    }
    return result;
}

/// The box around the part of the ball that the slab keeps.
Rectangle around_slab(const Vec3& c, const Vec3& n, double r, double e, double f,
                      const EyeView& view) {
    const double off_center = f > 0 ? f : (e < 0 ? e : 0);
    const double rim = std::sqrt(std::max(0.0, r * r - off_center * off_center));
    const Vec3 other = std::abs(n[0]) < 0.6 ? Vec3::UnitX() : Vec3::UnitY();
    Vec3 u = n.cross(other);
    u /= std::sqrt(squared_norm(u));
    const Vec3 v = n.cross(u);
    return around_box(c + (e + f) / 2 * n, {Vec3(rim * u), Vec3(rim * v), Vec3((e - f) / 2 * n)},
                      view);
}

/// The radius of the circle in which a plane at signed distance k from the center cuts the sphere;
/// 0 if it is a point or empty.
double rim_radius(double r, double k) {
    const double rim = std::sqrt(std::max(0.0, r * r - k * k));
    return rim > 1e-3 * r ? rim : 0;
}

constexpr std::uint32_t hatched_bit = 0x80000000;

struct Words {
    std::array<std::uint32_t, 20>& words;

    void set(std::size_t texel, double x, double y, double z, double w) {
        const std::array<double, 4> values{x, y, z, w};
        for (std::size_t i = 0; i < 4; ++i)
            words[4 * texel + i] = std::bit_cast<std::uint32_t>(static_cast<float>(values[i]));
    }
    void set(std::size_t texel, const Vec3& v, double w) { set(texel, v[0], v[1], v[2], w); }
};

struct Pack {
    const EyeView& view;
    Words words;
    Rectangle rectangle;
    PackedVolume::Shape shape = PackedVolume::Shape::scb;

    bool behind(const Vec3& c, double r) const { return -c[2] + r < view.near_plane; }

    bool operator()(const Scb& volume) {
        const Vec3 c = to_eye_units(view, volume.c);
        const Vec3 n = rotate_to_eye(view, volume.n);
        const double r = volume.r / view.unit, e = volume.e / view.unit, f = volume.f / view.unit;
        if (!(r > 0) || behind(c, r)) return false;
        rectangle.clip(around_ball(c, r, view));
        // For a nearly whole ball, the ball's own rectangle is smaller.
        if (e - f < 1.8 * r) rectangle.clip(around_slab(c, n, r, e, f, view));
        words.set(1, c, r);
        words.set(2, n, e);
        words.set(3, f, rim_radius(r, e), rim_radius(r, f), 1 / r);
        return true;
    }
    bool operator()(const Scb2& volume) {
        const Vec3 c = to_eye_units(view, volume.c);
        const double r = volume.r / view.unit;
        if (!(r > 0) || behind(c, r)) return false;
        rectangle.clip(around_ball(c, r, view));
        Vec3 middle = c;
        std::array<Vec3, 3> halves;
        for (std::size_t i = 0; i < 2; ++i) {
            const Slab& slab = volume.slabs[i];
            const Vec3 n = rotate_to_eye(view, slab.n);
            const double e = slab.e / view.unit, f = slab.f / view.unit;
            middle += (e + f) / 2 * n;
            halves[i] = (e - f) / 2 * n;
            words.set(2 + i, n, e);
            words.words[18 + i] = std::bit_cast<std::uint32_t>(static_cast<float>(f));
        }
        halves[2] = r * rotate_to_eye(view, long_axis(volume));
        rectangle.clip(around_box(middle, halves, view));
        words.set(1, c, r);
        shape = PackedVolume::Shape::scb2;
        return true;
    }
    bool operator()(const Ball& ball) {
        return (*this)(Scb{ball.center, ball.radius, Vec3::UnitZ(), ball.radius, -ball.radius});
    }
    bool operator()(const Obb& box) {
        const Vec3 c = to_eye_units(view, box.center);
        const Vec3 h = box.half / view.unit;
        if (behind(c, std::sqrt(squared_norm(h)))) return false;
        std::array<Vec3, 3> axes;
        for (int i = 0; i < 3; ++i)
            axes[static_cast<std::size_t>(i)] = rotate_to_eye(view, box.axes.col(i));
        rectangle.clip(around_box(
            c, {Vec3(h[0] * axes[0]), Vec3(h[1] * axes[1]), Vec3(h[2] * axes[2])}, view));
        words.set(1, c, h[0]);
        words.set(2, axes[0], h[1]);
        words.set(3, axes[1], h[2]);
        shape = PackedVolume::Shape::obb;
        return true;
    }
    bool operator()(const ConvexShape& volume) {
        Vec3 middle = to_eye_units(view, volume.center);
        std::array<Vec3, 3> halves;
        double squared = 0;
        for (int i = 0; i < 3; ++i) {
            const Vec3 axis = volume.axes.col(i), in_eye = rotate_to_eye(view, axis);
            const double up = support(volume, axis) / view.unit,
                         down = support(volume, Vec3(-axis)) / view.unit;
            middle += 0.5 * (up - down) * in_eye;
            halves[static_cast<std::size_t>(i)] = 0.5 * (up + down) * in_eye;
            squared += 0.25 * (up + down) * (up + down);
            words.set(1 + static_cast<std::size_t>(i), in_eye, 0);
        }
        if (behind(middle, std::sqrt(squared))) return false;
        rectangle.clip(around_box(middle, halves, view));
        shape = PackedVolume::Shape::convex;
        if (volume.rounding > 0) return true;
        shape = PackedVolume::Shape::polytope;
        words.set(1, to_eye_units(view, volume.center), std::sqrt(squared));
        return true;
    }
};

}  // namespace

std::optional<PackedVolume> pack(const VolumeInstance& instance, const EyeView& view) {
    PackedVolume packed{};
    Pack visitor{view, {packed.words}, {}};
    if (!std::visit(visitor, instance.volume)) return std::nullopt;
    Rectangle& r = visitor.rectangle;
    if (!(r.left < r.right && r.bottom < r.top)) return std::nullopt;

    packed.shape = visitor.shape;
    // Grows by a hundredth of a pixel, so that rounding to float loses nothing.
    const double x = 0.02 / view.target.width, y = 0.02 / view.target.height;
    visitor.words.set(0, r.left - x, r.bottom - y, r.right + x, r.top + y);
    const Rgba8 color = instance.color;
    packed.words[16] = color.r | static_cast<std::uint32_t>(color.g) << 8 |
                       static_cast<std::uint32_t>(color.b) << 16 |
                       static_cast<std::uint32_t>(color.a) << 24;
    assert(instance.id < hatched_bit && "the highest bit is the hatching's");
    packed.words[17] = instance.id | (instance.hatched ? hatched_bit : 0);
    return packed;
}

}  // namespace scb::render
