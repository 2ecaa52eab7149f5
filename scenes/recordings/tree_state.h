#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/model/engine_nodes.h"
#include "scb/mesh.h"
#include "scenes/recordings/record.h"

namespace scb::scenes {

/// What was recorded last of a node.
struct NodeState {
    std::uint64_t links = 0;   ///< hash of its children and items
    std::uint64_t epoch = 0;   ///< see TreeState::take
    std::uint64_t volume = 0;  ///< hash; 0 before one was recorded
};

/// A node of a tree that was built anew.
struct EarlierNode {
    std::uint64_t volume = 0;  ///< hash
    int told_at = 0;           ///< frame
    std::uint64_t links = 0;   ///< hash
    int links_at = 0;          ///< frame
};

/// A tree of a recording, as it is from some frame on.
struct TreeState {
    std::string name;
    std::uint32_t mesh = record_none;  ///< number
    EngineNodes tree;
    TreeShape shape;  ///< see complete
    std::vector<double> directions;
    std::vector<NodeState> node_states;
    std::map<std::uint64_t, EarlierNode> before;  ///< of the tree that this one replaces
    int version = 0;              ///< counts changes of its shape, or of how many triangles it has
    int volume_version = 0;       ///< counts changes of the tree, or of its mesh
    bool whole = false;           ///< `shape` is that of `tree`
    bool single_objects = false;  ///< its items are alone in leaves
    bool single = true;           ///< all numbers of its volumes are such of 32 bits
    bool has_long = false;        ///< and some take most of these bits
    bool has_numbers = false;     ///< one of them is not 0

    /// The tree is built anew: its nodes follow.
    void begin(const RecordedTree& record);
    /// A node. `epoch` counts frames and queries: a node that was recorded in an earlier one is
    /// replaced, one of the same epoch is described twice.
    void take(const RecordedNode& node, int frame, std::uint64_t epoch);
    void set_volume(std::uint32_t index, const RecordedVolume& volume, int frame);
    /// The shape, or the number of triangles, has changed.
    void change();
    /// Makes `shape`. `of`: the mesh, nullptr where it is not known.
    void complete(const Mesh* of);
    /// The largest length of its volumes.
    double reach() const;

  private:
    mutable double reach_ = 0;
    mutable int reach_version_ = -1;
};

}  // namespace scb::scenes
