#include "core/judge/tree_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/base/random.h"
#include "core/judge/similarity_fit.h"
#include "core/judge/tree_check.h"

namespace scb {
namespace {

/// Triangles at random places, not alike in any mirror.
Mesh scattered() {
    Random random(11);
    Mesh mesh;
    for (std::uint32_t i = 0; i < 64; ++i) {
        const Vec3 at(random.uniform(0, 10), random.uniform(0, 5), random.uniform(0, 2));
        for (int k = 0; k < 3; ++k)
            mesh.vertices.push_back(
                at + Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)) / 3);
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return mesh;
}

/// A tree of boxes about these triangles, in pairs of leaves; `items`: what leaf i names.
struct BoxTree {
    EngineNodes tree;
    TreeShape shape;

    explicit BoxTree(const Mesh& mesh, const std::vector<std::uint32_t>& items = {}) {
        const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
        add(mesh, 0, count, items);
        shape = tree_shape(tree, count);
    }
    std::uint32_t add(const Mesh& mesh, std::uint32_t first, std::uint32_t end,
                      const std::vector<std::uint32_t>& items) {
        Vec3 lower = Vec3::Constant(HUGE_VAL), upper = -lower;
        for (std::uint32_t i = first; i < end; ++i)
            for (const std::uint32_t v : mesh.triangles[i]) {
                lower = lower.cwiseMin(mesh.vertices[v]);
                upper = upper.cwiseMax(mesh.vertices[v]);
            }
        std::vector<std::uint32_t> children, own;
        const std::uint32_t middle = (first + end) / 2;
        if (end - first == 1)
            own = {items.empty() ? first : items[first]};
        else
            children = {add(mesh, first, middle, items), add(mesh, middle, end, items)};
        EngineNode node;
        node.number = next_++;
        node.volume = box_between(lower, upper);
        tree.add(node, "", children, own);
        return node.number;
    }
    std::optional<TreeFit> fit(const Mesh& mesh, const std::vector<OtherMesh>& others = {}) const {
        const std::size_t outside = check_volumes(tree, shape, &mesh, 1e-9).size();
        EXPECT_GT(outside, 0u);
        return find_tree_fit(tree, shape, mesh, 1e-9, outside, others);
    }

  private:
    std::uint32_t next_ = 0;
};

template <class Map>
Mesh moved(Mesh mesh, Map&& map) {
    for (Vec3& vertex : mesh.vertices) vertex = map(vertex);
    return mesh;
}

void expect_fit(const std::optional<TreeFit>& fit, const std::string& what) {
    ASSERT_TRUE(fit) << what;
    EXPECT_EQ(fit->what, what);
    EXPECT_EQ(fit->nodes, 127u);
    EXPECT_EQ(fit->of, 127u);
}

// The engine's boxes are of the mesh after a change that its recording does not have.
TEST(TreeFit, NamesTheChange) {
    const Mesh mesh = scattered();
    expect_fit(BoxTree(moved(mesh, [](Vec3 p) { return Vec3(-p[0], p[1], p[2]); })).fit(mesh),
               "a mirror of x");
    expect_fit(BoxTree(moved(mesh, [](Vec3 p) { return Vec3(p[0], p[2], p[1]); })).fit(mesh),
               "the axes in the order x, z, y");
    expect_fit(BoxTree(moved(mesh, [](Vec3 p) { return Vec3(p * 1000); })).fit(mesh),
               "a scale by 1000");
    expect_fit(BoxTree(moved(mesh, [](Vec3 p) { return Vec3(p + Vec3(0, 3, 0)); })).fit(mesh),
               "a shift by (0, 3, 0)");
    expect_fit(
        BoxTree(moved(mesh, [](Vec3 p) { return Vec3(p.cwiseMin(Vec3(5, 9, 9))); })).fit(mesh),
        "coordinates cut off at x <= 5");
}

TEST(TreeFit, NamesARotationWithAScaleAndAShift) {
    const Mesh mesh = scattered();
    Similarity map;
    const double angle = 40 * 3.14159265358979323846 / 180;
    map.rotation << std::cos(angle), 0, std::sin(angle), 0, 1, 0, -std::sin(angle), 0,
        std::cos(angle);
    expect_fit(BoxTree(moved(mesh, map)).fit(mesh), "a rotation by 40 degrees about y");
    map.scale = 2;
    map.shift = Vec3(1, 0, 0);
    expect_fit(BoxTree(moved(mesh, map)).fit(mesh),
               "a rotation by 40 degrees about y, a scale by 2 and a shift by (1, 0, 0)");
}

TEST(TreeFit, NamesTrianglesInAnotherOrder) {
    const Mesh mesh = scattered();
    std::vector<std::uint32_t> places(mesh.triangles.size());
    std::iota(places.begin(), places.end(), 0u);
    std::rotate(places.begin(), places.begin() + 5, places.end());
    expect_fit(BoxTree(mesh, places).fit(mesh),
               "the triangles in another order; item 0 would be triangle 59");
}

TEST(TreeFit, TriesOtherMeshesFirst) {
    const Mesh mesh = scattered();
    const Mesh before = moved(mesh, [](Vec3 p) { return Vec3(p + Vec3(0, 3, 0)); });
    expect_fit(BoxTree(before).fit(mesh, {{"another", [&] { return mesh; }},
                                          {"the mesh of frame 0", [&] { return before; }}}),
               "the mesh of frame 0");
}

TEST(TreeFit, NothingIsNamedWhereNoChangeExplainsMost) {
    const Mesh mesh = scattered();
    Random random(5);
    const Mesh shaken = moved(mesh, [&random](Vec3 p) {
        return Vec3(p + Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
    });
    EXPECT_FALSE(BoxTree(shaken).fit(mesh));
}

}  // namespace
}  // namespace scb
