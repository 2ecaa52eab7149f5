#include "core/judge/tree_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace scb {
namespace {

/// The most steps of the search; finding candidates may take four times as many.
constexpr std::size_t most_candidates = 4'000'000;

struct Leaf {
    Vec3 lower, upper;  ///< the box about its volume
    std::size_t places = 0;
    std::vector<std::uint32_t> items, triangles;  ///< `triangles`: those assigned to it
};

class Order {
  public:
    Order(const EngineNodes& tree, const TreeShape& shape, const Mesh& mesh, double tolerance)
        : tolerance_(tolerance) {
        for (const std::uint32_t node : shape.order) {
            if (tree.items(node).empty()) continue;
            if (!has_volume(tree[node].volume)) return;
            const Box box = box_about(convex_shape(tree[node].volume));
            Leaf leaf{box.lower, box.upper, tree.items(node).size(), {}, {}};
            leaf.items.assign(tree.items(node).begin(), tree.items(node).end());
            leaves_.push_back(std::move(leaf));
        }
        const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
        lower_.resize(count);
        upper_.resize(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            const Triangle& t = mesh.triangles[i];
            lower_[i] =
                mesh.vertices[t[0]].cwiseMin(mesh.vertices[t[1]]).cwiseMin(mesh.vertices[t[2]]);
            upper_[i] =
                mesh.vertices[t[0]].cwiseMax(mesh.vertices[t[1]]).cwiseMax(mesh.vertices[t[2]]);
        }
    }

    std::optional<std::vector<std::uint32_t>> found() {
        const std::size_t count = lower_.size();
        std::size_t places = 0;
        for (const Leaf& leaf : leaves_) places += leaf.places;
        if (places != count || !find_candidates()) return std::nullopt;
        leaf_of_.assign(count, leaves_.size());
        // Triangles with the fewest candidates first.
        std::vector<std::uint32_t> order(count);
        std::iota(order.begin(), order.end(), 0u);
        std::stable_sort(order.begin(), order.end(), [this](std::uint32_t a, std::uint32_t b) {
            return candidates_[a].size() < candidates_[b].size();
        });
        visited_.assign(leaves_.size(), 0);
        for (const std::uint32_t triangle : order) {
            ++round_;
            if (steps_ > most_candidates || !place(triangle)) return std::nullopt;
        }
        if (!are_tight()) return std::nullopt;
        std::vector<std::uint32_t> result(count, no_index);
        for (Leaf& leaf : leaves_) {
            std::sort(leaf.triangles.begin(), leaf.triangles.end());
            for (std::size_t i = 0; i < leaf.items.size(); ++i) {
                if (leaf.items[i] >= count || result[leaf.items[i]] != no_index)
                    return std::nullopt;
                result[leaf.items[i]] = leaf.triangles[i];
            }
        }
        return result;
    }

  private:
    /// Finds the leaves that contain the box of each triangle; false if that takes too long.
    bool find_candidates() {
        std::vector<std::uint32_t> by_x(lower_.size());
        std::iota(by_x.begin(), by_x.end(), 0u);
        std::stable_sort(by_x.begin(), by_x.end(), [this](std::uint32_t a, std::uint32_t b) {
            return lower_[a][0] < lower_[b][0];
        });
        candidates_.resize(lower_.size());
        std::size_t looked = 0;
        for (std::size_t k = 0; k < leaves_.size(); ++k) {
            const Leaf& leaf = leaves_[k];
            auto at =
                std::lower_bound(by_x.begin(), by_x.end(), leaf.lower[0] - tolerance_,
                                 [this](std::uint32_t i, double x) { return lower_[i][0] < x; });
            for (; at != by_x.end() && lower_[*at][0] <= leaf.upper[0] + tolerance_; ++at) {
                if (++looked > 4 * most_candidates) return false;
                if (((lower_[*at] - leaf.lower).array() >= -tolerance_).all() &&
                    ((upper_[*at] - leaf.upper).array() <= tolerance_).all())
                    candidates_[*at].push_back(static_cast<std::uint32_t>(k));
            }
        }
        return true;
    }

    /// Assigns the triangle to a leaf, perhaps by moving another triangle to another leaf (Kuhn,
    /// "The Hungarian Method for the Assignment Problem", 1955).
    bool place(std::uint32_t triangle) {
        for (const bool moves_others : {false, true})
            for (const std::uint32_t k : candidates_[triangle]) {
                Leaf& leaf = leaves_[k];
                if (++steps_ > most_candidates) return false;
                if (leaf.triangles.size() < leaf.places) {
                    leaf.triangles.push_back(triangle);
                    leaf_of_[triangle] = k;
                    return true;
                }
                if (!moves_others || visited_[k] == round_) continue;
                visited_[k] = round_;
                for (std::uint32_t& other : leaf.triangles) {
                    if (depth_ >= 200) return false;
                    ++depth_;
                    const bool moved = place(other);
                    --depth_;
                    if (!moved) continue;
                    other = triangle;
                    leaf_of_[triangle] = k;
                    return true;
                }
            }
        return false;
    }

    /// Whether most leaves fit their triangles tightly.
    bool are_tight() const {
        std::size_t tight = 0;
        for (const Leaf& leaf : leaves_) {
            Vec3 lower = Vec3::Constant(HUGE_VAL), upper = -lower;
            for (const std::uint32_t triangle : leaf.triangles) {
                lower = lower.cwiseMin(lower_[triangle]);
                upper = upper.cwiseMax(upper_[triangle]);
            }
            const double slack = tolerance_ + 1e-3 * (leaf.upper - leaf.lower).maxCoeff();
            tight += (lower - leaf.lower).cwiseAbs().maxCoeff() <= slack &&
                     (upper - leaf.upper).cwiseAbs().maxCoeff() <= slack;
        }
        return 2 * tight > leaves_.size();
    }

    double tolerance_;
    std::vector<Leaf> leaves_;
    std::vector<Vec3> lower_, upper_;                     ///< per triangle
    std::vector<std::vector<std::uint32_t>> candidates_;  ///< per triangle: leaves
    std::vector<std::size_t> leaf_of_, visited_;
    std::size_t round_ = 0, steps_ = 0, depth_ = 0;
};

}  // namespace

std::optional<std::vector<std::uint32_t>> find_triangle_order(const EngineNodes& tree,
                                                              const TreeShape& shape,
                                                              const Mesh& mesh, double tolerance) {
    return Order(tree, shape, mesh, tolerance).found();
}

}  // namespace scb
