#include "core/judge/similarity_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/portable_math.h"
#include "core/base/text_format.h"

namespace scb {
namespace {

using Vec4 = Eigen::Matrix<double, 4, 1>;
using Mat4 = Eigen::Matrix<double, 4, 4>;
using Vec7 = Eigen::Matrix<double, 7, 1>;
using Mat7 = Eigen::Matrix<double, 7, 7>;

/// A face of a leaf's volume, and the vertices of the leaf's triangles.
struct Face {
    Vec3 normal;
    double offset = 0;
    const std::vector<std::uint32_t>* vertices = nullptr;
};

/// If there are more leaves, a sample of them is enough.
constexpr std::size_t most_leaves = 4'000;

Mat3 rotation_of(const Vec4& q) {
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    Mat3 m;
    m << 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 2 * (x * y + w * z),
        1 - 2 * (x * x + z * z), 2 * (y * z - w * x), 2 * (x * z - w * y), 2 * (y * z + w * x),
        1 - 2 * (x * x + y * y);
    return m;
}

/// The rotation about v by about |v| radians, for small v.
Mat3 rotation_near(const Vec3& v) {
    const Vec4 q(1, v[0] / 2, v[1] / 2, v[2] / 2);
    return rotation_of(q / q.norm());
}

/// The similarity that takes the points `from` nearest to the points `to`, by least squares.
Similarity nearest_map(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
    Vec3 middle_from = Vec3::Zero(), middle_to = Vec3::Zero();
    for (std::size_t i = 0; i < from.size(); ++i) {
        middle_from += from[i] / static_cast<double>(from.size());
        middle_to += to[i] / static_cast<double>(from.size());
    }
    Mat3 b = Mat3::Zero();
    double size_from = 0, size_to = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const Vec3 p = from[i] - middle_from, q = to[i] - middle_to;
        b += q * p.transpose();
        size_from += squared_norm(p);
        size_to += squared_norm(q);
    }
    const double trace = b(0, 0) + b(1, 1) + b(2, 2);
    const Vec3 z(b(2, 1) - b(1, 2), b(0, 2) - b(2, 0), b(1, 0) - b(0, 1));
    Mat4 k;
    k(0, 0) = trace;
    k.block<1, 3>(0, 1) = z.transpose();
    k.block<3, 1>(1, 0) = z;
    k.block<3, 3>(1, 1) = b + b.transpose() - trace * Mat3::Identity();
    // The shift gives the largest eigenvalue the largest magnitude, for the power iteration.
    const double shift = k.cwiseAbs().sum();
    for (int i = 0; i < 4; ++i) k(i, i) += shift;
    Vec4 best(1, 0.1, 0.01, 0.001);
    for (int step = 0; step < 500; ++step) {
        best = k * best;
        best /= best.norm();
    }
    Similarity map;
    map.rotation = rotation_of(best);
    if (size_from > 0) map.scale = std::sqrt(size_to / size_from);
    map.shift = middle_to - map.scale * rotate(map.rotation, middle_from);
    return map;
}

class Fit {
  public:
    Fit(const EngineNodes& tree, const TreeShape& shape, const Mesh& mesh) : mesh_(mesh) {
        std::vector<std::uint32_t> leaves;
        for (const std::uint32_t node : shape.order)
            if (!tree.items(node).empty()) leaves.push_back(node);
        const std::size_t every = leaves.size() / most_leaves + 1;
        vertices_.resize(leaves.size());
        for (std::size_t i = 0; i < leaves.size(); i += every) take_leaf(tree, leaves[i], i);
    }

    std::optional<Similarity> found() {
        if (faces_.size() < 12 || from_.size() < 4) return std::nullopt;
        Similarity map = nearest_map(from_, to_);
        for (int step = 0; step < 40; ++step)
            if (!improve(map)) break;
        return map;
    }

  private:
    void take_leaf(const EngineNodes& tree, std::uint32_t leaf, std::size_t place) {
        if (!has_volume(tree[leaf].volume)) return;
        const ConvexShape shape = convex_shape(tree[leaf].volume);
        if (shape.faces.empty()) return;
        Vec3 lower = Vec3::Constant(HUGE_VAL), upper = -lower;
        for (const std::uint32_t item : tree.items(leaf)) {
            if (item >= mesh_.triangles.size()) return;
            for (const std::uint32_t vertex : mesh_.triangles[item]) {
                vertices_[place].push_back(vertex);
                lower = lower.cwiseMin(mesh_.vertices[vertex]);
                upper = upper.cwiseMax(mesh_.vertices[vertex]);
            }
        }
        from_.push_back(lower + (upper - lower) / 2);
        to_.push_back(shape.center);
        for (const FacePlane& face : shape.faces)
            faces_.push_back(
                {face.normal, face.offset + dot(face.normal, shape.center), &vertices_[place]});
    }

    /// One Gauss-Newton step; false once it changes nothing.
    bool improve(Similarity& map) const {
        Mat7 normal = Mat7::Zero();
        Vec7 right = Vec7::Zero();
        for (const Face& face : faces_) {
            double most = -HUGE_VAL;
            Vec3 turned = Vec3::Zero();
            for (const std::uint32_t vertex : *face.vertices) {
                const Vec3 at = map.scale * rotate(map.rotation, mesh_.vertices[vertex]);
                const double along = dot(face.normal, at);
                if (!(along > most)) continue;
                most = along;
                turned = at;
            }
            const double residual = most + dot(face.normal, map.shift) - face.offset;
            Vec7 row;
            row << cross(turned, face.normal), most, face.normal;
            normal += row * row.transpose();
            right -= residual * row;
        }
        for (int i = 0; i < 7; ++i) normal(i, i) *= 1 + 1e-12;
        const Vec7 step = normal.ldlt().solve(right);
        if (!step.allFinite()) return false;
        map.rotation = rotation_near(step.head<3>()) * map.rotation;
        map.scale *= 1 + std::clamp(step[3], -0.5, 0.5);
        map.shift += step.tail<3>();
        return step.head<4>().cwiseAbs().maxCoeff() > 1e-15;
    }

    const Mesh& mesh_;
    std::vector<std::vector<std::uint32_t>> vertices_;  ///< per leaf
    std::vector<Face> faces_;
    std::vector<Vec3> from_, to_;  ///< middles of leaves: of their triangles, of their volumes
};

std::string axis_words(const Vec3& axis) {
    for (int i = 0; i < 3; ++i)
        if (std::abs(axis[i]) > 1 - 1e-9) return std::string(1, "xyz"[i]);
    return format("(%.6g, %.6g, %.6g)", axis[0], axis[1], axis[2]);
}

}  // namespace

std::optional<Similarity> fit_similarity(const EngineNodes& tree, const TreeShape& shape,
                                         const Mesh& mesh) {
    return Fit(tree, shape, mesh).found();
}

std::string words_of(const Similarity& map, double reach, double tolerance) {
    std::vector<std::string> parts;
    const Mat3& m = map.rotation;
    Vec3 axis(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1));
    const double sine = std::sqrt(squared_norm(axis)) / 2,
                 cosine = (m(0, 0) + m(1, 1) + m(2, 2) - 1) / 2,
                 acute = arc_tangent(sine, std::abs(cosine)),
                 angle = cosine < 0 ? std::numbers::pi - acute : acute;
    if (angle * reach > tolerance) {
        if (sine > 1e-9) axis /= 2 * sine;
        // For half a turn, the axis is the longest column of R + I.
        if (!(sine > 1e-9))
            for (int i = 0; i < 3; ++i) {
                const Vec3 column = m.col(i) + Vec3::Unit(i);
                if (i == 0 || squared_norm(column) > squared_norm(axis)) axis = column;
            }
        axis /= std::sqrt(squared_norm(axis));
        int largest = 0;
        axis.cwiseAbs().maxCoeff(&largest);
        const double sign = axis[largest] < 0 ? -1 : 1;
        parts.push_back("a rotation by " + format("%.6g", sign * angle * 180 / std::numbers::pi) +
                        " degrees about " + axis_words(sign * axis));
    }
    if (std::abs(map.scale - 1) * reach > tolerance)
        parts.push_back("a scale by " + format("%.6g", map.scale));
    if (map.shift.cwiseAbs().maxCoeff() > tolerance) {
        Vec3 shift = map.shift;
        for (int i = 0; i < 3; ++i)
            if (std::abs(shift[i]) <= tolerance) shift[i] = 0;
        parts.push_back(format("a shift by (%.6g, %.6g, %.6g)", shift[0], shift[1], shift[2]));
    }
    std::string words;
    for (std::size_t i = 0; i < parts.size(); ++i)
        words += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
    return words;
}

}  // namespace scb
