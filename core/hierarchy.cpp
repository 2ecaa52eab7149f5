#include "core/hierarchy.h"

#include <algorithm>
#include <span>
#include <sstream>

#include "core/error.h"

namespace scb {
namespace {

// What a fitted subtree leaves for its parent. Its shared point ids are at the end of a common
// stack.
struct Subtree {
    Dop26 dop;
    SurfaceMoments moments;
    std::uint32_t own_first;     // its own points: ids from here to the next subtree's
    std::uint32_t shared_count;  // its shared points: ids below own_first
};

template <Volume V>
class BottomUpFit {
  public:
    BottomUpFit(const Topology& topology, const LeafOrder& points, const FitOptions& options)
        : topology_(topology),
          points_(points),
          options_(options),
          volumes_(topology.nodes.size()) {}

    std::vector<V> run() {
        // A node is met twice: before its children, and after them.
        std::vector<std::pair<std::uint32_t, bool>> open = {{0, false}};
        while (!open.empty()) {
            const auto [index, children_done] = open.back();
            open.pop_back();
            const TopologyNode& node = topology_.nodes[index];
            if (node.is_leaf()) {
                push_leaf(node);
            } else if (!children_done) {
                open.push_back({index, true});
                open.push_back({node.left + 1, false});
                open.push_back({node.left, false});
                continue;
            } else {
                merge_top_two();
            }
            fit_top(volumes_[index]);
        }
        return std::move(volumes_);
    }

  private:
    static constexpr bool needs_dop = !std::is_same_v<V, Obb>;
    static constexpr bool needs_moments = std::is_same_v<V, Obb>;

    void push_leaf(const TopologyNode& node) {
        const auto& corners = points_.corners[node.first];
        const PointArrays& p = points_.points;
        Subtree leaf{empty_dop26(), {}, next_id_, 0};
        for (const std::uint32_t id : corners) {
            if constexpr (needs_dop) add_point(leaf.dop, p.x[id], p.y[id], p.z[id], id);
            if (id >= next_id_) {
                next_id_ = id + 1;
            } else if (id < leaf.own_first) {
                shared_.push_back(id);
                ++leaf.shared_count;
            }
        }
        const auto begin = shared_.end() - leaf.shared_count;
        std::sort(begin, shared_.end());
        shared_.erase(std::unique(begin, shared_.end()), shared_.end());
        leaf.shared_count = static_cast<std::uint32_t>(shared_.end() - begin);
        if constexpr (needs_moments) {
            const PointsView all = p.view();
            leaf.moments = triangle_moments(all[corners[0]], all[corners[1]], all[corners[2]]);
        }
        stack_.push_back(leaf);
    }

    void merge_top_two() {
        const Subtree& right = stack_.back();
        Subtree& left = stack_[stack_.size() - 2];
        if constexpr (needs_dop) left.dop = merge(left.dop, right.dop);
        if constexpr (needs_moments) left.moments = merge(left.moments, right.moments);
        // What the right child shares with the left one belongs to both, and so becomes their
        // parent's own.
        const auto right_begin = shared_.end() - right.shared_count;
        const auto left_begin = right_begin - left.shared_count;
        const auto right_end = std::lower_bound(right_begin, shared_.end(), left.own_first);
        merged_.clear();
        std::set_union(left_begin, right_begin, right_begin, right_end,
                       std::back_inserter(merged_));
        shared_.erase(std::copy(merged_.begin(), merged_.end(), left_begin), shared_.end());
        left.shared_count = static_cast<std::uint32_t>(merged_.size());
        stack_.pop_back();
    }

    void fit_top(V& volume) {
        const Subtree& top = stack_.back();
        const PointArrays& p = points_.points;
        gathered_.clear();
        for (auto id = shared_.end() - top.shared_count; id != shared_.end(); ++id)
            gathered_.push_back({p.x[*id], p.y[*id], p.z[*id]});
        PointsView own = p.view().sub(top.own_first, next_id_ - top.own_first);
        constexpr std::size_t copy_below = 64;  // one part instead of two: less to do than it costs
        if (own.size + gathered_.size() < copy_below) {
            for (std::size_t i = 0; i < own.size; ++i) gathered_.push_back(own[i]);
            own = {};
        }
        fit(volume,
            FitInput{{gathered_.view(), own},
                     p.x.data(),
                     p.y.data(),
                     p.z.data(),
                     &top.dop,
                     needs_moments ? &top.moments : nullptr},
            options_);
    }

    const Topology& topology_;
    const LeafOrder& points_;
    const FitOptions& options_;
    std::vector<V> volumes_;
    std::vector<Subtree> stack_;
    std::vector<std::uint32_t> shared_, merged_;
    PointArrays gathered_;
    std::uint32_t next_id_ = 0;
};

template <class... Parts>
std::string sentence(const Parts&... parts) {
    std::ostringstream text;
    (text << ... << parts);
    return text.str();
}

}  // namespace

template <Volume V>
std::vector<V> fit_volumes(const Topology& topology, const LeafOrder& points,
                           const FitOptions& options) {
    return BottomUpFit<V>(topology, points, options).run();
}

template <Volume V>
Hierarchy<V> build_hierarchy(const Mesh& mesh, const FitOptions& options, std::string_view name) {
    check_mesh(mesh, name);
    if (!(options.margin >= 0))
        throw InputError(std::string(name) +
                         ": the margin is below 0 or not a number; give a share of the radius.");
    auto topology = std::make_shared<const Topology>(build_topology(mesh));
    std::vector<V> volumes = fit_volumes<V>(*topology, leaf_order(mesh, *topology), options);
    return {std::move(topology), std::move(volumes)};
}

std::string validate(const Topology& topology, const Mesh& mesh) {
    const std::size_t count = mesh.triangles.size();
    if (topology.order.size() != count)
        return sentence("the topology orders ", topology.order.size(), " triangles, the mesh has ",
                        count, ".");
    if (topology.nodes.size() != 2 * count - 1 || topology.rules.size() != topology.nodes.size())
        return sentence("the topology has ", topology.nodes.size(), " nodes, ", 2 * count - 1,
                        " are needed.");
    std::vector<char> met(count, 0);
    for (const std::uint32_t t : topology.order) {
        if (t >= count || met[t]) return sentence("triangle ", t, " is not in exactly one leaf.");
        met[t] = 1;
    }
    if (topology.nodes[0].first != 0 || topology.nodes[0].count != count)
        return "node 0, the root, does not hold all triangles.";
    for (std::size_t i = 0; i < topology.nodes.size(); ++i) {
        const TopologyNode& node = topology.nodes[i];
        if (node.is_leaf()) {
            if (node.count != 1)
                return sentence("node ", i, " is a leaf of ", node.count, " triangles.");
            continue;
        }
        if (node.left <= i || std::size_t{node.left} + 1 >= topology.nodes.size())
            return sentence("node ", i, " names child ", node.left, ", which does not follow it.");
        const TopologyNode &l = topology.nodes[node.left], &r = topology.nodes[node.left + 1];
        if (l.count == 0 || r.count == 0 || l.first != node.first || r.first != l.first + l.count ||
            l.count + r.count != node.count)
            return sentence("the children of node ", i, " do not make up its range.");
    }
    return {};
}

template <Volume V>
std::string validate(const Hierarchy<V>& hierarchy, const Mesh& mesh) {
    const Topology& topology = *hierarchy.topology;
    if (std::string failure = validate(topology, mesh); !failure.empty()) return failure;
    if (hierarchy.volumes.size() != topology.nodes.size())
        return sentence(hierarchy.volumes.size(), " volumes for ", topology.nodes.size(),
                        " nodes.");
    for (std::size_t i = 0; i < topology.nodes.size(); ++i) {
        const TopologyNode& node = topology.nodes[i];
        if (!is_well_formed(hierarchy.volumes[i]))
            return sentence("the volume of node ", i, " is not well formed.");
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
            for (const std::uint32_t v : mesh.triangles[topology.order[k]])
                if (!contains(hierarchy.volumes[i], mesh.vertices[v]))
                    return sentence("vertex ", v, " of triangle ", topology.order[k],
                                    " is outside the volume of node ", i, ".");
    }
    return {};
}

template std::vector<Scb> fit_volumes(const Topology&, const LeafOrder&, const FitOptions&);
template std::vector<Ball> fit_volumes(const Topology&, const LeafOrder&, const FitOptions&);
template std::vector<Obb> fit_volumes(const Topology&, const LeafOrder&, const FitOptions&);
template Hierarchy<Scb> build_hierarchy(const Mesh&, const FitOptions&, std::string_view);
template Hierarchy<Ball> build_hierarchy(const Mesh&, const FitOptions&, std::string_view);
template Hierarchy<Obb> build_hierarchy(const Mesh&, const FitOptions&, std::string_view);
template std::string validate(const Hierarchy<Scb>&, const Mesh&);
template std::string validate(const Hierarchy<Ball>&, const Mesh&);
template std::string validate(const Hierarchy<Obb>&, const Mesh&);

}  // namespace scb
