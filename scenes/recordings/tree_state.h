#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/model/engine_nodes.h"
#include "scb/mesh.h"
#include "scenes/recordings/record.h"

namespace scb::scenes {

/// The latest record of a node.
struct NodeState {
    std::uint64_t links = 0;   ///< hash of its children and items
    std::uint64_t epoch = 0;   ///< see TreeState::take
    std::uint64_t volume = 0;  ///< hash; 0 before one was recorded
};

/// A node of the tree before a rebuild.
struct EarlierNode {
    std::uint64_t volume = 0;  ///< hash
    int recorded_at = 0;       ///< frame
    std::uint64_t links = 0;   ///< hash
    int links_at = 0;          ///< frame
};

/// The current state of a recorded tree.
struct TreeState {
    std::string name;
    std::uint32_t mesh = record_none;  ///< number
    EngineNodes tree;
    TreeShape shape;  ///< see complete
    std::vector<double> directions;
    std::vector<NodeState> node_states;
    std::map<std::uint64_t, EarlierNode> before;  ///< nodes of the tree that this one replaces
    int version = 0;              ///< counts changes of its links, items or number of triangles
    int volume_version = 0;       ///< counts changes of the tree, or of its mesh
    bool whole = false;           ///< `shape` is up to date
    bool single_objects = false;  ///< each item is alone in a leaf
    bool single = true;           ///< all numbers of its volumes are exact in 32 bits
    bool has_long = false;        ///< some of them are long, see is_long
    bool has_numbers = false;     ///< one of them is not 0

    /// Begins a tree, or a rebuild: the nodes follow.
    void begin(const RecordedTree& record);
    /// Takes a node. `epoch` counts frames and queries: a node of an earlier epoch is replaced, one
    /// of the same epoch is a duplicate.
    void take(const RecordedNode& node, int frame, std::uint64_t epoch);
    void set_volume(std::uint32_t index, const RecordedVolume& volume, int frame);
    /// The shape, or the number of triangles, has changed.
    void change();
    /// Updates `shape`. `of`: the mesh; nullptr if unknown.
    void complete(const Mesh* of);
    /// The largest length of its volumes.
    double reach() const;

  private:
    mutable double reach_ = 0;
    mutable int reach_version_ = -1;
};

}  // namespace scb::scenes
