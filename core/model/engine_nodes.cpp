#include "core/model/engine_nodes.h"

#include <algorithm>
#include <utility>

namespace scb {

void EngineNodes::add(EngineNode node, std::string node_name,
                      std::span<const std::uint32_t> children,
                      std::span<const std::uint32_t> items) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    if (!by_number_.emplace(node.number, index).second) {
        recorded_twice_.push_back(node.number);
        return;
    }
    if (!node_name.empty()) names_.emplace(index, std::move(node_name));
    nodes_.push_back(std::move(node));
    const EngineNode& added = nodes_.back();
    relink(index, added.parent, added.links_at, children, items);
}

void EngineNodes::relink(std::uint32_t index, std::uint32_t parent, int frame,
                         std::span<const std::uint32_t> children,
                         std::span<const std::uint32_t> items) {
    EngineNode& node = nodes_[index];
    node.parent = parent;
    node.links_at = frame;
    node.first_child = static_cast<std::uint32_t>(children_.size());
    node.child_count = static_cast<std::uint32_t>(children.size());
    node.first_item = static_cast<std::uint32_t>(items_.size());
    node.item_count = static_cast<std::uint32_t>(items.size());
    children_.insert(children_.end(), children.begin(), children.end());
    items_.insert(items_.end(), items.begin(), items.end());
    has_parents_ |= parent != nodes_.front().parent;
}

std::uint32_t EngineNodes::index_of(std::uint32_t number) const {
    const auto found = by_number_.find(number);
    return found == by_number_.end() ? no_index : found->second;
}

std::span<const std::uint32_t> EngineNodes::children(std::size_t index) const {
    return std::span(children_).subspan(nodes_[index].first_child, nodes_[index].child_count);
}

std::span<const std::uint32_t> EngineNodes::items(std::size_t index) const {
    return std::span(items_).subspan(nodes_[index].first_item, nodes_[index].item_count);
}

std::string EngineNodes::name_of(std::size_t index) const {
    const auto found = names_.find(static_cast<std::uint32_t>(index));
    return found == names_.end() ? std::string() : found->second;
}

std::string EngineNodes::words(std::size_t index) const {
    const std::string number = "node " + std::to_string(nodes_[index].number), own = name_of(index);
    return own.empty() ? number : number + " \"" + own + "\"";
}

std::uint32_t EngineNodes::parent(std::size_t index) const {
    return has_parents_ ? nodes_[index].parent : no_index;
}

void EngineNodes::set_volume(std::uint32_t index, NodeVolume volume, int frame, std::string fault,
                             double reach) {
    nodes_[index].volume = std::move(volume);
    nodes_[index].reach = reach;
    nodes_[index].recorded_at = frame;
    if (fault.empty())
        volume_faults_.erase(index);
    else
        volume_faults_[index] = std::move(fault);
}

std::string EngineNodes::volume_fault(std::uint32_t index) const {
    const auto found = volume_faults_.find(index);
    return found == volume_faults_.end() ? std::string() : found->second;
}

void EngineNodes::set_object_volume(std::uint32_t object, NodeVolume volume) {
    object_volumes_[object] = std::move(volume);
}

const NodeVolume* EngineNodes::object_volume(std::uint32_t object) const {
    const auto found = object_volumes_.find(object);
    return found == object_volumes_.end() ? nullptr : &found->second;
}

void EngineNodes::change_volumes(const std::function<NodeVolume(const NodeVolume&)>& change) {
    for (EngineNode& node : nodes_) node.volume = change(node.volume);
    for (auto& [object, volume] : object_volumes_) volume = change(volume);
}

TreeShape tree_shape(const EngineNodes& tree, std::size_t items) {
    const auto size = static_cast<std::uint32_t>(tree.size());
    TreeShape shape;
    shape.parents.assign(size, no_index);
    shape.depths.assign(size, no_index);
    shape.first_child.assign(size, no_index);
    shape.next_sibling.assign(size, no_index);
    shape.holder.assign(items, no_index);
    std::vector<bool> listed(size, false);
    for (std::uint32_t i = 0; i < size; ++i)
        for (const std::uint32_t child : tree.children(i))
            if (const std::uint32_t c = tree.index_of(child); c != no_index) listed[c] = true;
    for (std::uint32_t i = 0; i < size; ++i)
        if (!listed[i] && tree.parent(i) == no_index) shape.roots.push_back(i);
    // A tree that is only a cycle is entered at an arbitrary node.
    if (shape.roots.empty() && size > 0) shape.roots.push_back(0);

    std::vector<std::uint32_t> left(shape.roots.rbegin(), shape.roots.rend());
    for (const std::uint32_t root : left) shape.depths[root] = 0;
    while (!left.empty()) {
        const std::uint32_t i = left.back();
        left.pop_back();
        shape.order.push_back(i);
        for (const std::uint32_t item : tree.items(i))
            if (item < items && shape.holder[item] == no_index)
                shape.holder[item] = i;
            else if (item < items)
                shape.more_holders.emplace_back(item, i);
        const auto children = tree.children(i);
        for (auto child = children.rbegin(); child != children.rend(); ++child) {
            const std::uint32_t c = tree.index_of(*child);
            if (c == no_index || shape.depths[c] != no_index) continue;
            shape.depths[c] = shape.depths[i] + 1;
            shape.parents[c] = i;
            shape.next_sibling[c] = shape.first_child[i];
            shape.first_child[i] = c;
            left.push_back(c);
        }
    }
    // Nodes of one item stay in the order of `order`.
    std::stable_sort(shape.more_holders.begin(), shape.more_holders.end(),
                     [](const auto& x, const auto& y) { return x.first < y.first; });
    return shape;
}

}  // namespace scb
