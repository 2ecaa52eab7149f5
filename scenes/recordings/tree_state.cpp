#include "scenes/recordings/tree_state.h"

#include <algorithm>
#include <bit>
#include <span>
#include <utility>

#include "core/base/word_hash.h"
#include "scenes/recordings/number_bits.h"
#include "scenes/recordings/recorded_volume.h"
#include "scenes/recordings/recording_summary.h"

namespace scb::scenes {
namespace {

/// Above the numbers of a tree's objects; 0 where these are so large that they are no numbers.
std::size_t objects_of(const EngineNodes& tree) {
    constexpr std::size_t most = 1'000'000;
    std::size_t end = 0;
    for (std::size_t node = 0; node < tree.size(); ++node)
        for (const std::uint32_t item : tree.items(node))
            end = std::max(end, std::size_t{item} + 1);
    return end <= most ? end : 0;
}

/// Whether items are alone in leaves.
bool has_single_objects(const EngineNodes& tree, const TreeShape& shape) {
    for (std::uint32_t node = 0; node < shape.size(); ++node)
        if (tree.items(node).size() > (shape.is_leaf(node) ? 1 : 0)) return false;
    return !shape.holder.empty();
}

/// The key of a node when its tree is rebuilt: its items for a leaf, else its number.
std::uint64_t node_key(std::uint32_t number, std::span<const std::uint32_t> items) {
    WordHash hash;
    if (items.empty()) hash.add(number);
    for (const std::uint32_t item : items) hash.add((std::uint64_t{item} + 1) << 32);
    return hash.value;
}

/// A hash of the children and items of a node.
std::uint64_t links_hash(const RecordedNode& node) {
    WordHash hash;
    hash.add(node.children.size());
    for (const std::uint32_t child : node.children) hash.add(child);
    for (const std::uint32_t item : node.items) hash.add(item);
    return hash.value;
}

}  // namespace

void TreeState::begin(const RecordedTree& record) {
    TreeState made;
    for (std::uint32_t i = 0; i < tree.size(); ++i) {
        const EngineNode& node = tree[i];
        const NodeState& of_node = node_states[i];
        made.before[node_key(node.number, tree.items(i))] = {of_node.volume, node.recorded_at,
                                                             of_node.links, node.links_at};
    }
    made.name = shown(record.name);
    made.mesh = record.mesh;
    made.tree.has_objects = record.mesh == record_none;
    made.directions = record.directions;
    made.version = version + 1;
    made.volume_version = volume_version + 1;
    *this = std::move(made);
}

void TreeState::take(const RecordedNode& node, int frame, std::uint64_t epoch) {
    EngineNode made;
    made.number = node.node;
    made.parent = node.parent;
    made.id = node.id;
    const std::uint64_t links = links_hash(node);
    const std::uint32_t known_at = tree.index_of(node.node);
    change();
    // A child that was recorded earlier may have had another parent then.
    for (const std::uint32_t child : node.children)
        if (const std::uint32_t known = tree.index_of(child);
            known != no_index && node_states[known].epoch != epoch)
            tree[known].parent = node.node;
    // A node that is recorded again in a later frame or query replaces the earlier one.
    if (known_at != no_index && node_states[known_at].epoch != epoch) {
        NodeState& of_node = node_states[known_at];
        of_node.epoch = epoch;
        tree[known_at].parent = node.parent;
        if (std::exchange(of_node.links, links) != links)
            tree.relink(known_at, node.parent, frame, node.children, node.items);
        return set_volume(known_at, node.volume, frame);
    }
    const auto old = before.find(node_key(node.node, node.items));
    made.links_at =
        old != before.end() && old->second.links == links ? old->second.links_at : frame;
    const std::size_t size = tree.size();
    tree.add(std::move(made), shown(node.name), node.children, node.items);
    if (tree.size() == size) return;
    node_states.push_back({links, epoch, 0});
    set_volume(static_cast<std::uint32_t>(size), node.volume, frame);
}

void TreeState::set_volume(std::uint32_t index, const RecordedVolume& volume, int frame) {
    WordHash told;
    told.add(static_cast<std::uint64_t>(volume.kind));
    for (const double value : volume.values) told.add(std::bit_cast<std::uint64_t>(value));
    int recorded_at = frame;
    const std::uint64_t last = std::exchange(node_states[index].volume, told.value);
    // An engine may record all volumes again, also those that it forgot to change.
    if (last == told.value) return;
    if (last == 0) {
        // In a rebuilt tree, the node may have its earlier volume.
        const auto old = before.find(node_key(tree[index].number, tree.items(index)));
        if (old != before.end() && old->second.volume == told.value)
            recorded_at = old->second.recorded_at;
    }
    std::string fault;
    NodeVolume made = node_volume(volume, directions, fault);
    has_numbers = has_numbers || std::any_of(volume.values.begin(), volume.values.end(),
                                             [](double value) { return value != 0; });
    has_long = has_long || std::any_of(volume.values.begin(), volume.values.end(), is_long);
    single = single && std::all_of(volume.values.begin(), volume.values.end(), is_of_32_bits);
    tree.set_volume(index, std::move(made), recorded_at, std::move(fault),
                    scenes::reach_of(volume, directions));
}

void TreeState::change() {
    whole = false;
    ++version;
    ++volume_version;
}

void TreeState::complete(const Mesh* of) {
    if (whole) return;
    shape = tree_shape(tree, of ? of->triangles.size() : objects_of(tree));
    single_objects = has_single_objects(tree, shape);
    whole = true;
}

double TreeState::reach() const {
    if (reach_version_ == volume_version) return reach_;
    reach_ = 0;
    for (std::size_t i = 0; i < tree.size(); ++i) reach_ = std::max(reach_, tree[i].reach);
    reach_version_ = volume_version;
    return reach_;
}

}  // namespace scb::scenes
