#include "core/model/packed_tree.h"

#include <algorithm>
#include <map>
#include <utility>

namespace scb {
namespace {

/// A range of Topology::order.
using Range = std::pair<std::uint32_t, std::uint32_t>;

/// Finds the binary nodes by their ranges, which no two nodes share.
template <class Codec>
class Links {
  public:
    Links(const PackedHierarchy<Codec>& packed, const Topology& topology)
        : packed_(packed), places_(topology.order.size()) {
        for (std::uint32_t i = 0; i < topology.nodes.size(); ++i)
            nodes_[{topology.nodes[i].first, topology.nodes[i].count}] = i;
        for (std::uint32_t place = 0; place < topology.order.size(); ++place)
            places_[topology.order[place]] = place;
    }

    PackedTree run() {
        find_ranges();
        add(packed_.root, no_index);
        return std::move(tree_);
    }

  private:
    Range leaf_range(PackedRef ref) const {
        const PackedLeaf leaf = packed_.leaf(ref);
        std::uint32_t first = UINT32_MAX;
        for (std::uint32_t k = 0; k < leaf.count(); ++k)
            first = std::min(first, places_[leaf.triangle(k)]);
        return {first, leaf.count()};
    }

    Range range(PackedRef ref) const {
        return ref.is_leaf() ? leaf_range(ref) : ranges_[ref.index()];
    }

    /// Children come after their parents.
    void find_ranges() {
        ranges_.resize(packed_.nodes.size());
        for (std::size_t i = ranges_.size(); i-- > 0;) {
            Range all = {UINT32_MAX, 0};
            for (std::size_t k = 0; k < packed_.nodes[i].count; ++k) {
                const Range child = range(child_of(packed_.nodes[i], k));
                all = {std::min(all.first, child.first), all.second + child.second};
            }
            ranges_[i] = all;
        }
    }

    static PackedRef child_of(const PackedNode<Codec>& node, std::size_t k) {
        return {node.child[k]};
    }

    std::uint32_t add(PackedRef ref, std::uint32_t parent) {
        const std::uint32_t binary = nodes_.at(range(ref));
        tree_.binary[ref.bits] = binary;
        const std::size_t at = tree_.nodes.size();
        tree_.nodes.push_back({binary, parent, {}, {}});
        if (ref.is_leaf()) {
            const PackedLeaf leaf = packed_.leaf(ref);
            for (std::uint32_t k = 0; k < leaf.count(); ++k)
                tree_.nodes[at].items.push_back(leaf.triangle(k));
            return binary;
        }
        const PackedNode<Codec>& node = packed_.nodes[ref.index()];
        for (std::size_t k = 0; k < node.count; ++k) {
            const std::uint32_t child = add(child_of(node, k), binary);
            tree_.nodes[at].children.push_back(child);
        }
        return binary;
    }

    const PackedHierarchy<Codec>& packed_;
    std::map<Range, std::uint32_t> nodes_;
    std::vector<std::uint32_t> places_;  ///< by triangle
    std::vector<Range> ranges_;          ///< by wide node
    PackedTree tree_;
};

}  // namespace

PackedTree packed_tree(const AnyPacked& packed, const Topology& topology) {
    return std::visit(
        [&]<class Codec>(const PackedHierarchy<Codec>& some) {
            return Links<Codec>(some, topology).run();
        },
        packed);
}

}  // namespace scb
