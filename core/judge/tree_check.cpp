#include "core/judge/tree_check.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text_format.h"
#include "core/judge/engine_query.h"
#include "core/judge/triangle_cover.h"

namespace scb {
namespace {

Box box_of(const Mesh& mesh, std::uint32_t triangle) {
    Box box;
    for (const std::uint32_t vertex : mesh.triangles[triangle]) box.add(mesh.vertices[vertex]);
    return box;
}

/// How far the farthest corner of the box is outside of the volume.
double excess(const NodeVolume& volume, const Box& box) {
    double most = -HUGE_VAL;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 p;
        for (int i = 0; i < 3; ++i) p[i] = (corner >> i & 1) ? box.upper[i] : box.lower[i];
        most = std::max(most, scb::excess(volume, p));
    }
    return most;
}

double excess(const NodeVolume& volume, const Mesh& mesh, std::uint32_t triangle) {
    double most = -HUGE_VAL;
    for (const std::uint32_t vertex : mesh.triangles[triangle])
        most = std::max(most, scb::excess(volume, mesh.vertices[vertex]));
    return most;
}

}  // namespace

double reach_beyond(const ConvexShape& parent, const ConvexShape& child) {
    double most = -HUGE_VAL;
    const Vec3 moved = child.center - parent.center;
    const auto try_direction = [&](const Vec3& d) {
        most = std::max(most, dot(moved, d) + support(child, d) - support(parent, d));
    };
    for (const FacePlane& face : parent.faces)
        most = std::max(most, dot(moved, face.normal) + support(child, face.normal) - face.offset);
    if (!parent.faces.empty()) return most;
    for (const Vec3& d : touching_directions()) {
        try_direction(d);
        // If the parent is a ball, the direction of a far point of the child shows more.
        const Vec3 farthest = moved + child.support_point(d);
        if (const double length = std::sqrt(squared_norm(farthest)); length > 0)
            try_direction(farthest / length);
    }
    return most;
}

namespace {

/// The worst problem of each node.
struct Worst {
    const EngineNodes& tree;
    std::vector<TreeProblem> problems;
    std::vector<bool> found;

    explicit Worst(const EngineNodes& of)
        : tree(of), problems(of.size()), found(of.size(), false) {}

    void note(std::uint32_t node, TreeFault fault, std::uint32_t item, std::uint32_t other,
              double amount, bool inherited = false) {
        TreeProblem& worst = problems[node];
        inherited = inherited && (!found[node] || worst.inherited);
        if (!found[node] || amount > worst.amount)
            worst = {fault, tree[node].number, other, item, amount};
        worst.inherited = inherited;
        found[node] = true;
    }
};

/// Of a triangle in several leaves.
void check_split(const EngineNodes& tree, const TreeShape& shape, const Mesh& mesh,
                 std::uint32_t item, NodeTolerance allowed, Worst& worst,
                 UnjudgedVolumes& unjudged) {
    double tolerance = 0;
    std::vector<LeafWay> ways;
    std::vector<std::vector<std::uint32_t>> nodes;
    for (const std::uint32_t holder : shape.holders_of(item)) {
        LeafWay& way = ways.emplace_back();
        std::vector<std::uint32_t>& of_way = nodes.emplace_back();
        for (std::uint32_t node = holder; node != no_index; node = shape.parents[node])
            if (has_volume(tree[node].volume)) {
                way.push_back(&tree[node].volume);
                tolerance = std::max(tolerance, allowed.of(tree[node]));
                of_way.push_back(node);
            }
    }
    const TriangleCover cover = cover_of(corners(mesh, item), ways, tolerance);
    unjudged.splits += cover.kind == TriangleCover::Kind::undecided;
    if (cover.kind != TriangleCover::Kind::open) return;
    std::uint32_t farthest = no_index;
    double most = -HUGE_VAL;
    for (const std::uint32_t node : nodes[cover.nearest])
        if (const double amount = excess(tree[node].volume, cover.point); amount > most) {
            most = amount;
            farthest = node;
        }
    worst.note(farthest, TreeFault::part_outside, item, no_index, cover.amount);
}

/// A box along the axes contains the very numbers that it was made of. Where it does not, the
/// engine may have rounded inwards; other volumes are made of rounded numbers anyway.
void note_slight(const EngineNode& node, const Box& below, NodeTolerance tolerance,
                 UnjudgedVolumes& unjudged) {
    const auto* box = std::get_if<Obb>(&node.volume);
    if (!box || box->axes != Mat3::Identity() || !(below.lower[0] <= below.upper[0])) return;
    const Vec3 lower = box->center - box->half, upper = box->center + box->half;
    const double by = std::max((lower - below.lower).maxCoeff(), (below.upper - upper).maxCoeff());
    const double unit = std::ldexp(1.0, std::ilogb(std::max(node.reach, 1e-300)) - 23);
    if (!(by > unit) || by > tolerance.of(node)) return;
    ++unjudged.slightly_open;
    unjudged.open_by = std::max(unjudged.open_by, by);
}

void check_triangles(const EngineNodes& tree, const TreeShape& shape, const Mesh& mesh,
                     NodeTolerance tolerance, Worst& worst, UnjudgedVolumes& unjudged) {
    std::vector<bool> split(mesh.triangles.size(), false);
    for (const auto& [item, node] : shape.more_holders)
        if (!split[item] && has_finite_corners(mesh, item)) {
            split[item] = true;
            ++unjudged.of_splits;
            check_split(tree, shape, mesh, item, tolerance, worst, unjudged);
        }
    const auto is_whole = [&](std::uint32_t item) {
        return item < mesh.triangles.size() && !split[item] && has_finite_corners(mesh, item);
    };
    // From the leaves up: the box of all items below settles most nodes.
    std::vector<Box> boxes(tree.size());
    std::vector<bool> open(tree.size(), false);
    for (auto i = shape.order.rbegin(); i != shape.order.rend(); ++i) {
        Box& box = boxes[*i];
        for (const std::uint32_t item : tree.items(*i))
            if (is_whole(item)) box.add(box_of(mesh, item));
        if (const std::uint32_t parent = shape.parents[*i]; parent != no_index)
            boxes[parent].add(box);
        open[*i] = has_volume(tree[*i].volume) && box.lower[0] <= box.upper[0] &&
                   !(excess(tree[*i].volume, box) <= tolerance.of(tree[*i]));
        note_slight(tree[*i], box, tolerance, unjudged);
    }
    for (const std::uint32_t i : shape.order)
        for (const std::uint32_t item : tree.items(i)) {
            if (!is_whole(item)) continue;
            bool inherited = false;
            for (std::uint32_t above = i; above != no_index; above = shape.parents[above]) {
                if (!open[above]) continue;
                const double amount = excess(tree[above].volume, mesh, item);
                if (!(amount > tolerance.of(tree[above]))) continue;
                worst.note(above, TreeFault::outside, item, no_index, amount, inherited);
                inherited = true;
            }
        }
}

/// Of a tree whose items are objects.
void check_objects(const EngineNodes& tree, const TreeShape& shape, NodeTolerance tolerance,
                   Worst& worst, UnjudgedVolumes& unjudged) {
    // From the leaves up: the box of all extents below settles most nodes.
    std::vector<Box> boxes(tree.size());
    std::vector<bool> open(tree.size(), false);
    for (auto i = shape.order.rbegin(); i != shape.order.rend(); ++i) {
        Box& box = boxes[*i];
        bool known = true;
        for (const std::uint32_t object : tree.items(*i)) {
            const NodeVolume* extent = tree.object_volume(object);
            known = known && extent;
            if (extent) box.add(box_about(convex_shape(*extent)));
        }
        if (const std::uint32_t parent = shape.parents[*i]; parent != no_index)
            boxes[parent].add(box);
        open[*i] = has_volume(tree[*i].volume) && box.lower[0] <= box.upper[0] &&
                   !(excess(tree[*i].volume, box) <= tolerance.of(tree[*i]));
        if (tree.items(*i).empty()) continue;
        ++unjudged.of_leaves;
        unjudged.leaves += !known;
    }
    for (const std::uint32_t leaf : shape.order)
        for (const std::uint32_t object : tree.items(leaf)) {
            const NodeVolume* extent = tree.object_volume(object);
            if (!extent) continue;
            bool inherited = false;
            for (std::uint32_t node = leaf; node != no_index; node = shape.parents[node]) {
                if (!open[node]) continue;
                const double amount =
                    reach_beyond(convex_shape(tree[node].volume), convex_shape(*extent));
                if (!(amount > tolerance.of(tree[node]))) continue;
                worst.note(node, TreeFault::outside, object, no_index, amount, inherited);
                inherited = true;
            }
        }
}

bool is_box_along_axes(const NodeVolume& volume) {
    const auto* box = std::get_if<Obb>(&volume);
    return (box && box->axes == Mat3::Identity()) || std::holds_alternative<OpenBox>(volume);
}

/// Checks boxes of object trees whose objects have no recorded extent: the box of a parent contains
/// the boxes of its children. Objects with an extent are checked themselves. Other types of volumes
/// need not contain the volumes of their children.
void check_children(const EngineNodes& tree, const TreeShape& shape, NodeTolerance tolerance,
                    Worst& worst) {
    std::vector<bool> has_items(tree.size()), has_unknown(tree.size());
    for (auto i = shape.order.rbegin(); i != shape.order.rend(); ++i) {
        for (const std::uint32_t object : tree.items(*i)) {
            has_items[*i] = true;
            if (!tree.object_volume(object)) has_unknown[*i] = true;
        }
        const std::uint32_t parent = shape.parents[*i];
        if (parent == no_index) continue;
        if (has_items[*i]) has_items[parent] = true;
        if (has_unknown[*i]) has_unknown[parent] = true;
    }
    for (const std::uint32_t i : shape.order) {
        const std::uint32_t parent = shape.parents[i];
        if (parent == no_index || (has_items[i] && !has_unknown[i]) ||
            !is_box_along_axes(tree[parent].volume) || !is_box_along_axes(tree[i].volume) ||
            !has_volume(tree[i].volume) || !has_volume(tree[parent].volume))
            continue;
        const double amount =
            reach_beyond(convex_shape(tree[parent].volume), convex_shape(tree[i].volume));
        if (amount > std::max(tolerance.of(tree[parent]), tolerance.of(tree[i])))
            worst.note(parent, TreeFault::outside, no_index, tree[i].number, amount);
    }
}

/// The first vertex that is not finite.
std::uint32_t broken_vertex(const Mesh& mesh, std::uint32_t item) {
    for (const std::uint32_t vertex : mesh.triangles[item])
        if (!is_usable(mesh.vertices[vertex])) return vertex;
    return no_index;
}

std::string number_words(const EngineNodes& tree, std::uint32_t number) {
    const std::uint32_t index = tree.index_of(number);
    return index == no_index ? "node " + std::to_string(number) : tree.words(index);
}

}  // namespace

std::vector<TreeProblem> check_shape(const EngineNodes& tree, const TreeShape& shape,
                                     const Mesh* mesh) {
    std::vector<TreeProblem> problems;
    const auto add = [&](TreeFault fault, std::uint32_t node, std::uint32_t other = no_index,
                         std::uint32_t item = no_index) {
        problems.push_back({fault, node, other, item, 0});
    };
    for (const std::uint32_t number : tree.recorded_twice()) add(TreeFault::recorded_twice, number);
    std::vector<std::uint32_t> lister(tree.size(), no_index);
    for (std::uint32_t i = 0; i < tree.size(); ++i)
        for (const std::uint32_t child : tree.children(i)) {
            const std::uint32_t c = tree.index_of(child);
            if (c == no_index)
                add(TreeFault::missing_child, tree[i].number, child);
            else if (lister[c] != no_index)
                add(TreeFault::listed_twice, child, tree[i].number);
            else
                lister[c] = i;
        }
    for (std::uint32_t i = 0; i < tree.size(); ++i) {
        const EngineNode& node = tree[i];
        const std::uint32_t parent = tree.parent(i);
        if (parent != no_index && lister[i] == no_index)
            add(TreeFault::dropped, node.number, parent);
        else if (parent != no_index && tree[lister[i]].number != parent)
            add(TreeFault::wrong_parent, node.number, parent);
        // No root reaches the node, or it is the arbitrary start of a cycle.
        const bool is_entered = shape.depths[i] != no_index && shape.depths[i] > 0;
        if (!is_entered && lister[i] != no_index) add(TreeFault::unreachable, node.number);
    }
    // Nothing is known about a tree without nodes.
    if (!mesh || tree.size() == 0) return problems;

    const auto count = static_cast<std::uint32_t>(mesh->triangles.size());
    for (const std::uint32_t i : shape.order)
        for (const std::uint32_t item : tree.items(i))
            if (item >= count) add(TreeFault::triangle_unknown, tree[i].number, no_index, item);
    for (std::uint32_t item = 0; item < count; ++item)
        if (shape.holder_of(item) == no_index && !has_no_area(*mesh, item))
            add(TreeFault::triangle_nowhere, no_index, no_index, item);
    for (std::uint32_t item = 0; item < count; ++item)
        if (!has_finite_corners(*mesh, item))
            add(TreeFault::triangle_broken, no_index, broken_vertex(*mesh, item), item);
    return problems;
}

std::vector<TreeProblem> check_volumes(const EngineNodes& tree, const TreeShape& shape,
                                       const Mesh* mesh, NodeTolerance tolerance,
                                       UnjudgedVolumes* unjudged) {
    std::vector<TreeProblem> problems;
    bool any = false;
    for (const std::uint32_t i : shape.order) any |= has_volume(tree[i].volume);
    Worst worst(tree);
    UnjudgedVolumes not_judged;
    if (mesh) {
        for (std::uint32_t item = 0; item < mesh->triangles.size() && tree.size() > 0; ++item)
            not_judged.dropped += shape.holder_of(item) == no_index && has_no_area(*mesh, item);
        check_triangles(tree, shape, *mesh, tolerance, worst, not_judged);
    } else if (tree.has_objects) {
        check_children(tree, shape, tolerance, worst);
        check_objects(tree, shape, tolerance, worst, not_judged);
    }
    if (unjudged) *unjudged = not_judged;
    for (const std::uint32_t i : shape.order) {
        // A leaf without items may have an empty volume, or none.
        if (shape.is_leaf(i) && tree.items(i).empty() && !worst.found[i]) continue;
        if (!tree.volume_fault(i).empty())
            worst.problems[i] = {TreeFault::bad_volume, tree[i].number};
        else if (any && !has_volume(tree[i].volume))
            worst.problems[i] = {TreeFault::no_volume, tree[i].number};
        else if (!worst.found[i])
            continue;
        problems.push_back(worst.problems[i]);
    }
    std::stable_sort(problems.begin(), problems.end(),
                     [&](const TreeProblem& a, const TreeProblem& b) {
                         const auto depth = [&](const TreeProblem& p) {
                             return shape.depths[tree.index_of(p.node)];
                         };
                         return depth(a) > depth(b);
                     });
    return problems;
}

std::string amount_words(double length) {
    return length >= max_coordinate / 2 ? "an infinite length" : format("%.6g", length);
}

std::string words_of(const TreeProblem& problem, const EngineNodes& tree) {
    const std::string node = problem.node == no_index ? "" : number_words(tree, problem.node),
                      other = problem.other == no_index ? "" : number_words(tree, problem.other),
                      triangle = (tree.has_objects ? "object " : "triangle ") +
                                 std::to_string(problem.item);
    switch (problem.fault) {
        case TreeFault::recorded_twice:
            return node + " is described twice";
        case TreeFault::missing_child:
            return node + " lists " + other + ", which is not described";
        case TreeFault::listed_twice:
            return node + " is a child of two nodes, the second is " + other;
        case TreeFault::wrong_parent:
            return node + " names " + other + " as its parent, but is a child of another node";
        case TreeFault::dropped:
            return node + " names " + other +
                   " as its parent, but is not among that node's children: no query reaches it";
        case TreeFault::unreachable:
            return node + " is in a cycle, or below one";
        case TreeFault::triangle_nowhere:
            return triangle + " is in no leaf";
        case TreeFault::triangle_unknown:
            return node + " has " + triangle + ", which the mesh does not have";
        case TreeFault::triangle_broken:
            return triangle + " has vertex " + std::to_string(problem.other) +
                   ", which is not finite";
        case TreeFault::bad_volume:
            return node +
                   " has an invalid volume: " + tree.volume_fault(tree.index_of(problem.node));
        case TreeFault::no_volume:
            return node + " has no volume";
        case TreeFault::outside:
            return node + " does not contain " +
                   (problem.item != no_index ? triangle : "the volume of " + other) + ", by " +
                   amount_words(problem.amount);
        case TreeFault::part_outside:
            return node + " does not contain its part of " + triangle + ", by " +
                   amount_words(problem.amount);
    }
    return {};
}

}  // namespace scb
