#include "core/judge/engine_tree.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include "core/base/word_hash.h"

namespace scb {
namespace {

using SharedPolytope = std::shared_ptr<const Polytope>;

class EngineTree final : public VolumeTree {
  public:
    EngineTree(const NodeTree& tree, const TreeShape& shape) : VolumeTree(shape), tree_(tree) {
        cut_open_boxes();
    }

    bool has_volume(std::uint32_t node) const override {
        return scb::has_volume(tree_[node].volume);
    }

    AnyVolume volume(std::uint32_t node) const override {
        const NodeVolume& told = tree_[node].volume;
        return std::visit(
            [&]<class V>(const V& v) -> AnyVolume {
                if constexpr (std::is_same_v<V, std::monostate> || std::is_same_v<V, OpenBox> ||
                              std::is_same_v<V, SharedPolytope>)
                    return convex_shape(told);
                else
                    return shape_of(v);
            },
            told);
    }

    VolumeLengths lengths(std::uint32_t node) const override {
        return measured<VolumeLengths>(node, [](const auto& v) { return lengths_of(v); });
    }
    VolumeSize volume_size(std::uint32_t node) const override {
        return measured<VolumeSize>(node, [](const auto& v) { return size_of(v); });
    }
    bool contains(std::uint32_t node, const Vec3& point, double slack) const override {
        return excess(tree_[node].volume, point) <= slack;
    }

    VolumeFamily family() const override {
        std::optional<VolumeFamily> family;
        for (std::uint32_t node = 0; node < tree_.size(); ++node) {
            if (!has_volume(node)) continue;
            const VolumeFamily of_node = family_of(tree_[node].volume);
            if (family && *family != of_node) return VolumeFamily::convex;
            family = of_node;
        }
        return family.value_or(VolumeFamily::convex);
    }

    std::span<const std::uint32_t> items(std::uint32_t node) const override {
        return tree_.items(node);
    }
    std::uint32_t number(std::uint32_t node) const override { return tree_[node].number; }
    std::uint32_t node_of(std::uint32_t number) const override { return tree_.index_of(number); }
    std::string name(std::uint32_t node) const override { return tree_.name_of(node); }

  private:
    /// A picture shows a box without an end as far as the other volumes reach, and a bit farther.
    void cut_open_boxes() {
        Box all;
        bool any = false;
        for (std::uint32_t node = 0; node < tree_.size(); ++node) {
            const NodeVolume& volume = tree_[node].volume;
            if (const auto* open = std::get_if<OpenBox>(&volume)) {
                any = true;
                for (const Vec3& corner : {open->lower, open->upper})
                    for (int i = 0; i < 3; ++i)
                        if (std::isfinite(corner[i])) {
                            all.lower[i] = std::min(all.lower[i], corner[i]);
                            all.upper[i] = std::max(all.upper[i], corner[i]);
                        }
            } else if (scb::has_volume(volume)) {
                all.add(box_about(convex_shape(volume)));
            }
        }
        if (!any) return;
        for (int i = 0; i < 3; ++i)
            if (!(all.lower[i] <= all.upper[i])) all.lower[i] = all.upper[i] = 0;
        const double size = (all.upper - all.lower).maxCoeff(), more = size > 0 ? size / 4 : 1;
        for (std::uint32_t node = 0; node < tree_.size(); ++node)
            if (const auto* open = std::get_if<OpenBox>(&tree_[node].volume))
                tree_[node].volume =
                    cut_box(*open, all.lower.array() - more, all.upper.array() + more);
    }

    template <class Measures, class Measure>
    Measures measured(std::uint32_t node, Measure&& measure) const {
        const NodeVolume& told = tree_[node].volume;
        return std::visit(
            [&]<class V>(const V& v) -> Measures {
                if constexpr (std::is_same_v<V, std::monostate>)
                    return {};
                else if constexpr (std::is_same_v<V, OpenBox> || std::is_same_v<V, SharedPolytope>)
                    return measure(convex_shape(told));
                else
                    return measure(v);
            },
            told);
    }

    static VolumeFamily family_of(const NodeVolume& volume) {
        return std::holds_alternative<Scb>(volume)       ? VolumeFamily::slab_cut
               : std::holds_alternative<Scb2>(volume)    ? VolumeFamily::two_slabs
               : std::holds_alternative<Ball>(volume)    ? VolumeFamily::ball
               : std::holds_alternative<Obb>(volume)     ? VolumeFamily::box
               : std::holds_alternative<OpenBox>(volume) ? VolumeFamily::box
                                                         : VolumeFamily::convex;
    }

    NodeTree tree_;
};

}  // namespace

std::string volume_title(const NodeVolume& volume) {
    struct Title {
        std::string operator()(const std::monostate&) const { return ""; }
        std::string operator()(const Obb& box) const {
            return box.axes == Mat3::Identity() ? "AABB" : "OBB";
        }
        std::string operator()(const OpenBox&) const { return "AABB"; }
        std::string operator()(const Ball&) const { return "ball"; }
        std::string operator()(const Capsule&) const { return "capsule"; }
        std::string operator()(const Rss&) const { return "RSS"; }
        std::string operator()(const Scb&) const { return "SCB"; }
        std::string operator()(const Scb2&) const { return "SCB2"; }
        std::string operator()(const SharedPolytope& p) const {
            return p->faces.empty() ? "hull" : "k-DOP";
        }
    };
    return std::visit(Title{}, volume);
}

std::unique_ptr<VolumeTree> volume_tree(const NodeTree& tree, const TreeShape& shape) {
    return std::make_unique<EngineTree>(tree, shape);
}

std::uint64_t tree_hash(const VolumeTree& tree) {
    WordHash hash;
    for (std::uint32_t node = 0; node < tree.size(); ++node) {
        hash.add(tree.shape().parents[node]);
        for (const std::uint32_t item : tree.items(node)) hash.add(item);
    }
    return hash.value;
}

std::vector<std::string> volumes_titles(const NodeTree& tree) {
    std::vector<std::string> titles;
    for (std::size_t i = 0; i < tree.size(); ++i) {
        const std::string title = volume_title(tree[i].volume);
        if (!title.empty() && std::find(titles.begin(), titles.end(), title) == titles.end())
            titles.push_back(title);
    }
    // An oriented box may have the axes of its body.
    if (std::find(titles.begin(), titles.end(), "OBB") != titles.end()) std::erase(titles, "AABB");
    return titles;
}

}  // namespace scb
