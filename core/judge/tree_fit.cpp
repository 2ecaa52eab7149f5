#include "core/judge/tree_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text_format.h"
#include "core/judge/similarity_fit.h"
#include "core/judge/tree_check.h"
#include "scb/triangle_overlap.h"

namespace scb {
namespace {

class Search {
  public:
    Search(const EngineNodes& tree, const TreeShape& shape, const Mesh& mesh, double tolerance,
           std::uint64_t outside)
        : tree_(tree), shape_(shape), mesh_(mesh), tolerance_(tolerance), outside_(outside) {
        for (const std::uint32_t node : shape.order) volumes_ += has_volume(tree[node].volume);
        for (const Vec3& vertex : mesh.vertices)
            reach_ = std::max(reach_, vertex.cwiseAbs().maxCoeff());
    }

    std::optional<TreeFit> found(std::span<const OtherMesh> others) {
        for (const OtherMesh& other : others)
            if (fits(other.what, other.mesh())) return result_;
        if (outside_ < 8 || 4 * outside_ < volumes_) return std::nullopt;
        if (try_axes() || try_bounds() || try_order() || try_similarity()) return result_;
        return std::nullopt;
    }

  private:
    bool fits(const std::string& what, const Mesh& mesh, double more = 0) {
        if (mesh.triangles.size() != mesh_.triangles.size() || !may_fit(mesh, more)) return false;
        std::uint64_t left = 0;
        for (const TreeProblem& problem :
             check_volumes(tree_, shape_, &mesh, std::max(tolerance_, more)))
            left += problem.fault == TreeFault::outside;
        if (10 * left > outside_) return false;
        result_ = TreeFit{what, volumes_ - left, volumes_};
        return true;
    }

    /// A sample soon rules out most meshes, whereas a check of all nodes takes seconds.
    bool may_fit(const Mesh& mesh, double more) const {
        constexpr std::size_t most_looked = 400;
        const std::size_t every = shape_.order.size() / most_looked + 1;
        std::size_t looked = 0, outside = 0;
        for (std::size_t i = 0; i < shape_.order.size(); i += every) {
            const std::uint32_t node = shape_.order[i];
            for (const std::uint32_t item : tree_.items(node)) {
                if (item >= mesh.triangles.size() || !has_volume(tree_[node].volume)) continue;
                double most = 0;
                for (const Vec3& corner : corners(mesh, item))
                    most = std::max(most, excess(tree_[node].volume, corner));
                ++looked;
                outside += most > std::max(tolerance_, more);
            }
        }
        return 4 * outside <= looked;
    }

    template <class Map>
    Mesh moved(Map&& map) const {
        Mesh mesh = mesh_;
        for (Vec3& vertex : mesh.vertices) vertex = map(vertex);
        return mesh;
    }

    bool try_axes() {
        for (int i = 0; i < 3; ++i)
            if (fits(std::string("a mirror of ") + "xyz"[i], moved([i](Vec3 p) {
                         p[i] = -p[i];
                         return p;
                     })))
                return true;
        constexpr std::array<std::array<int, 3>, 5> orders = {
            {{0, 2, 1}, {1, 0, 2}, {2, 1, 0}, {1, 2, 0}, {2, 0, 1}}};
        for (const auto& order : orders) {
            const std::string words = std::string("the axes in the order ") + "xyz"[order[0]] +
                                      ", " + "xyz"[order[1]] + ", " + "xyz"[order[2]];
            if (fits(words, moved([&order](const Vec3& p) {
                         return Vec3(p[order[0]], p[order[1]], p[order[2]]);
                     })))
                return true;
        }
        return false;
    }

    /// Tries common bounds: all volumes end at one box, and vertices lie beyond it.
    bool try_bounds() {
        Box all;
        for (const std::uint32_t node : shape_.order)
            if (has_volume(tree_[node].volume))
                all.add(box_about(convex_shape(tree_[node].volume)));
        const Vec3 &lower = all.lower, &upper = all.upper;
        const Box box = bounding_box(mesh_);
        std::string sides;
        for (int i = 0; i < 3; ++i) {
            const auto add = [&](const char* sign, double at) {
                sides += (sides.empty() ? "" : ", ") + std::string(1, "xyz"[i]) + sign +
                         format("%.6g", at);
            };
            if (box.lower[i] < lower[i] - tolerance_) add(" >= ", lower[i]);
            if (box.upper[i] > upper[i] + tolerance_) add(" <= ", upper[i]);
        }
        return !sides.empty() && fits("coordinates cut off at " + sides, moved([&](const Vec3& p) {
                                          return Vec3(p.cwiseMax(lower).cwiseMin(upper));
                                      }));
    }

    bool try_order() {
        const auto order = find_triangle_order(tree_, shape_, mesh_, tolerance_);
        if (!order) return false;
        Mesh mesh = mesh_;
        std::string first;
        for (std::size_t item = 0; item < order->size(); ++item) {
            const std::uint32_t triangle = (*order)[item];
            mesh.triangles[item] = mesh_.triangles[triangle];
            if (first.empty() && triangle != item)
                first = "; item " + std::to_string(item) + " would be triangle " +
                        std::to_string(triangle);
        }
        return fits("the triangles in another order" + first, mesh);
    }

    bool try_similarity() {
        const std::optional<Similarity> map = fit_similarity(tree_, shape_, mesh_);
        if (!map) return false;
        // The fit is as exact as the volumes' numbers.
        const double more = 1e-9 * reach_ * std::max(1.0, map->scale);
        const double negligible = 100 * std::max(tolerance_, more);
        // First without the parts that move nothing.
        Similarity simple = *map;
        if (std::abs(map->scale - 1) * reach_ <= negligible) simple.scale = 1;
        if ((map->rotation - Mat3::Identity()).cwiseAbs().maxCoeff() * reach_ <= negligible)
            simple.rotation = Mat3::Identity();
        if (map->shift.cwiseAbs().maxCoeff() <= negligible) simple.shift = Vec3::Zero();
        for (const Similarity& tried : {simple, *map}) {
            const std::string words = words_of(tried, reach_, negligible);
            if (!words.empty() && fits(words, moved(tried), more)) return true;
        }
        return false;
    }

    const EngineNodes& tree_;
    const TreeShape& shape_;
    const Mesh& mesh_;
    double tolerance_, reach_ = 0;
    std::uint64_t outside_, volumes_ = 0;
    std::optional<TreeFit> result_;
};

}  // namespace

std::optional<TreeFit> find_tree_fit(const EngineNodes& tree, const TreeShape& shape,
                                     const Mesh& mesh, double tolerance, std::uint64_t outside,
                                     std::span<const OtherMesh> others) {
    return Search(tree, shape, mesh, tolerance, outside).found(others);
}

}  // namespace scb
