#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/hierarchy/volume_tree.h"
#include "core/judge/node_tree.h"

namespace scb {

/// What an engine told of a tree, as pictures, files and reports read it: a copy. `shape` is
/// tree_shape of it.
std::unique_ptr<VolumeTree> volume_tree(const NodeTree& tree, const TreeShape& shape);

/// Tells trees from each other by what hangs where and holds which items; not by their volumes.
std::uint64_t tree_hash(const VolumeTree& tree);

/// What a volume is called in titles: "OBB", "AABB", "hull"; a box with the axes of its body is an
/// AABB. Empty where there is none.
std::string volume_title(const NodeVolume& volume);

/// What its volumes are called in titles: "OBB", "AABB", "hull". Empty where it has none.
std::vector<std::string> volumes_titles(const NodeTree& tree);

}  // namespace scb
