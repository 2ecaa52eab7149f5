#include "render/web/tree_blocks.h"

#include <algorithm>
#include <cmath>

namespace scb::render {
namespace {

/// A level with fewer nodes is packed together with the next level.
constexpr std::size_t least_nodes = 512;

/// What a few levels have, before they are packed.
struct Level {
    std::size_t levels = 0;
    std::vector<std::uint8_t> shapes, colors;
    std::vector<float> numbers, texels;
    std::vector<std::uint32_t> extras;
};

/// Appends a volume to a level.
struct Append {
    Level& level;
    const Vec3& center;

    void put(double value) { level.numbers.push_back(static_cast<float>(value)); }
    void put(const Vec3& v, double w) {
        for (int i = 0; i < 3; ++i) put(v[i]);
        put(w);
    }
    void begin(WebShape shape) { level.shapes.push_back(static_cast<std::uint8_t>(shape)); }
    void texel(const Vec3& v, double w) {
        for (int i = 0; i < 3; ++i) level.texels.push_back(static_cast<float>(v[i]));
        level.texels.push_back(static_cast<float>(w));
    }

    void operator()(const Scb& v) {
        begin(WebShape::scb);
        put(v.c - center, v.r);
        put(v.n, v.e);
        put(v.f);
    }
    void operator()(const Ball& v) {
        (*this)(Scb{v.center, v.radius, Vec3::UnitZ(), v.radius, -v.radius});
    }
    void operator()(const Scb2& v) {
        begin(WebShape::scb2);
        put(v.c - center, v.r);
        for (const Slab& slab : v.slabs) put(slab.n, slab.e);
        for (const Slab& slab : v.slabs) put(slab.f);
    }
    void operator()(const Obb& v) {
        begin(WebShape::box);
        put(v.center - center, v.half[0]);
        put(v.axes.col(0), v.half[1]);
        put(v.axes.col(1), v.half[2]);
    }
    void operator()(const ConvexShape& v) {
        double reach = 0;
        for (int corner = 0; corner < 8; ++corner) {
            // The corners of the box of its own axes.
            Vec3 p = Vec3::Zero();
            for (int i = 0; i < 3; ++i) {
                const double sign = (corner >> i & 1) ? 1 : -1;
                const Vec3 axis = sign * v.axes.col(i);
                p += support(v, axis) * axis;
            }
            reach = std::max(reach, std::sqrt(squared_norm(p)));
        }
        if (v.rounding > 0)
            round(v, reach);
        else
            cut(v, reach);
    }

    void cut(const ConvexShape& v, double reach) {
        begin(WebShape::polytope);
        put(v.center - center, reach);
        const std::vector<FacePlane> planes = planes_about(v, touching_directions());
        for (const FacePlane& plane : planes) {
            const double length = std::sqrt(squared_norm(plane.normal));
            texel(plane.normal / length, plane.offset / length);
        }
        // The highest bit: they stand for a curve, and have no edges.
        level.extras.push_back(static_cast<std::uint32_t>(planes.size()) |
                               (v.faces.empty() ? 0x80000000u : 0u));
    }

    /// The core is the hull of its farthest points.
    void round(const ConvexShape& v, double reach) {
        begin(WebShape::rounded);
        put(v.center - center, reach);
        put(v.rounding);
        std::vector<Vec3> points;
        for (const Vec3& own : touching_directions()) {
            const Vec3 point = v.support_point(rotate(v.axes, own));
            if (std::find(points.begin(), points.end(), point) == points.end())
                points.push_back(point);
        }
        for (const Vec3& point : points) texel(point, 0);
        level.extras.push_back(static_cast<std::uint32_t>(points.size()));
    }
};

Vec3 middle_of(const Tree& tree) {
    for (const std::uint32_t root : tree.shape().roots)
        if (tree.has_volume(root)) return center(tree.volume(root));
    return Vec3::Zero();
}

}  // namespace

TreeBlocks tree_blocks(const Tree& tree, const std::function<Rgba8(std::uint32_t)>& color,
                       BlockStore& store) {
    const TreeShape& shape = tree.shape();
    TreeBlocks result;
    result.center = middle_of(tree);
    std::vector<std::uint32_t> order, children, item_counts, items, here = shape.roots;
    Level level;
    const auto pack = [&] {
        LevelBlocks& blocks = result.parts.emplace_back();
        blocks.levels = level.levels;
        blocks.shapes = store.add(level.shapes);
        blocks.numbers = store.add(level.numbers);
        blocks.colors = store.add(level.colors);
        blocks.has_extras = !level.texels.empty();
        if (blocks.has_extras) {
            blocks.extras = store.add(level.extras);
            blocks.texels = store.add(level.texels);
        }
        level = {};
    };
    while (!here.empty()) {
        std::vector<std::uint32_t> below;
        for (const std::uint32_t node : here) {
            std::uint32_t count = 0;
            for (std::uint32_t child = shape.first_child[node]; child != no_index;
                 child = shape.next_sibling[child], ++count)
                below.push_back(child);
            order.push_back(node);
            children.push_back(count);
            const std::span<const std::uint32_t> own = tree.items(node);
            item_counts.push_back(static_cast<std::uint32_t>(own.size()));
            items.insert(items.end(), own.begin(), own.end());
            const std::size_t before = level.extras.size();
            if (tree.has_volume(node))
                std::visit(Append{level, result.center}, tree.volume(node));
            else
                level.shapes.push_back(static_cast<std::uint8_t>(WebShape::none));
            if (level.extras.size() == before) level.extras.push_back(0);
            const Rgba8 c = color(node);
            level.colors.insert(level.colors.end(), {c.r, c.g, c.b});
        }
        result.counts.push_back(here.size());
        ++level.levels;
        if (level.shapes.size() >= least_nodes || below.empty()) pack();
        here = std::move(below);
    }
    result.order = store.add(order);
    result.children = store.add(children);
    result.item_counts = store.add(item_counts);
    result.items = store.add(items);
    if (tree.has_own_numbers()) {
        std::vector<std::uint32_t> numbers;
        for (const std::uint32_t node : order) numbers.push_back(tree.number(node));
        result.numbers = store.add(numbers);
    }
    return result;
}

}  // namespace scb::render
