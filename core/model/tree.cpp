#include "core/model/tree.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

#include "core/base/word_hash.h"
#include "core/volumes/measured_shape.h"

namespace scb {
namespace {

using SharedPolytope = std::shared_ptr<const Polytope>;

template <class V>
constexpr VolumeFamily family_of() {
    return std::is_same_v<V, Scb>                                 ? VolumeFamily::slab_cut
           : std::is_same_v<V, Scb2>                              ? VolumeFamily::two_slabs
           : std::is_same_v<V, Ball>                              ? VolumeFamily::ball
           : std::is_same_v<V, Obb> || std::is_same_v<V, OpenBox> ? VolumeFamily::box
                                                                  : VolumeFamily::convex;
}

/// A picture shows a box without an end as far as the other volumes reach, and a bit farther.
void cut_open_boxes(EngineNodes& nodes) {
    Box all;
    bool any = false;
    for (std::uint32_t node = 0; node < nodes.size(); ++node) {
        const NodeVolume& volume = nodes[node].volume;
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
    for (std::uint32_t node = 0; node < nodes.size(); ++node)
        if (const auto* open = std::get_if<OpenBox>(&nodes[node].volume))
            nodes[node].volume = cut_box(*open, all.lower.array() - more, all.upper.array() + more);
}

VolumeFamily family_of(const EngineNodes& nodes) {
    std::optional<VolumeFamily> family;
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        if (!has_volume(nodes[node].volume)) continue;
        const VolumeFamily of_node =
            std::visit([]<class V>(const V&) { return family_of<V>(); }, nodes[node].volume);
        if (family && *family != of_node) return VolumeFamily::convex;
        family = of_node;
    }
    return family.value_or(VolumeFamily::convex);
}

}  // namespace

Tree::Tree(const AnyHierarchy& hierarchy)
    : shape_(std::visit([](const auto& h) { return tree_shape(*h.topology); }, hierarchy)),
      nodes_(&hierarchy) {}

Tree::Tree(EngineNodes nodes, TreeShape shape) : shape_(std::move(shape)) {
    cut_open_boxes(nodes);
    nodes_ = std::move(nodes);
}

/// `measure` of the volume of a node: of its own type, or of its convex shape where the type has no
/// measures. Result() if there is no volume.
template <class Result, class Measure>
Result Tree::measured(std::uint32_t node, const Measure& measure) const {
    if (const auto* const* own = std::get_if<const AnyHierarchy*>(&nodes_))
        return std::visit([&](const auto& h) -> Result { return measure(h.volumes[node]); }, **own);
    const NodeVolume& volume = std::get<EngineNodes>(nodes_)[node].volume;
    return std::visit(
        [&]<class V>(const V& v) -> Result {
            if constexpr (std::is_same_v<V, std::monostate>)
                return {};
            else if constexpr (std::is_same_v<V, OpenBox> || std::is_same_v<V, SharedPolytope>)
                return measure(convex_shape(volume));
            else
                return measure(v);
        },
        volume);
}

bool Tree::has_volume(std::uint32_t node) const {
    const auto* nodes = std::get_if<EngineNodes>(&nodes_);
    return nodes == nullptr || scb::has_volume((*nodes)[node].volume);
}

AnyVolume Tree::volume(std::uint32_t node) const {
    return measured<AnyVolume>(node, []<class V>(const V& v) -> AnyVolume {
        if constexpr (std::is_same_v<V, ConvexShape>)
            return v;
        else
            return shape_of(v);
    });
}

VolumeLengths Tree::lengths(std::uint32_t node) const {
    return measured<VolumeLengths>(node, [](const auto& v) { return lengths_of(v); });
}

VolumeSize Tree::volume_size(std::uint32_t node) const {
    return measured<VolumeSize>(node, [](const auto& v) { return size_of(v); });
}

bool Tree::contains(std::uint32_t node, const Vec3& point, double slack) const {
    if (const auto* nodes = std::get_if<EngineNodes>(&nodes_))
        return excess((*nodes)[node].volume, point) <= slack;
    return std::visit(
        [&](const auto& h) { return scb::contains(enlarged(h.volumes[node], slack), point); },
        *std::get<const AnyHierarchy*>(nodes_));
}

VolumeFamily Tree::family() const {
    if (const auto* nodes = std::get_if<EngineNodes>(&nodes_)) return family_of(*nodes);
    return std::visit(
        []<class V>(const Hierarchy<V>&) {
            return family_of<std::decay_t<decltype(shape_of(std::declval<V>()))>>();
        },
        *std::get<const AnyHierarchy*>(nodes_));
}

std::span<const std::uint32_t> Tree::items(std::uint32_t node) const {
    if (const auto* nodes = std::get_if<EngineNodes>(&nodes_)) return nodes->items(node);
    return std::visit(
        [&](const auto& h) -> std::span<const std::uint32_t> {
            const TopologyNode& place = h.topology->nodes[node];
            if (!place.is_leaf()) return {};
            return std::span(h.topology->order).subspan(place.first, place.count);
        },
        *std::get<const AnyHierarchy*>(nodes_));
}

std::uint32_t Tree::number(std::uint32_t node) const {
    const auto* nodes = std::get_if<EngineNodes>(&nodes_);
    return nodes ? (*nodes)[node].number : node;
}

std::uint32_t Tree::node_of(std::uint32_t number) const {
    if (const auto* nodes = std::get_if<EngineNodes>(&nodes_)) return nodes->index_of(number);
    return number < size() ? number : no_index;
}

std::string Tree::name(std::uint32_t node) const {
    const auto* nodes = std::get_if<EngineNodes>(&nodes_);
    return nodes ? nodes->name_of(node) : std::string();
}

std::string Tree::node_words(std::uint32_t node) const {
    const auto* nodes = std::get_if<EngineNodes>(&nodes_);
    return nodes ? nodes->words(node) : "node " + std::to_string(node);
}

bool Tree::has_own_numbers() const {
    for (std::uint32_t node = 0; node < size(); ++node)
        if (number(node) != node) return true;
    return false;
}

std::uint64_t Tree::hash() const {
    WordHash hash;
    for (std::uint32_t node = 0; node < size(); ++node) {
        hash.add(shape_.parents[node]);
        for (const std::uint32_t item : items(node)) hash.add(item);
    }
    return hash.value;
}

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

std::vector<std::string> volumes_titles(const EngineNodes& nodes) {
    std::vector<std::string> titles;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const std::string title = volume_title(nodes[i].volume);
        if (!title.empty() && std::find(titles.begin(), titles.end(), title) == titles.end())
            titles.push_back(title);
    }
    // An oriented box may happen to lie along the body's axes.
    if (std::find(titles.begin(), titles.end(), "OBB") != titles.end()) std::erase(titles, "AABB");
    return titles;
}

}  // namespace scb
