#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/distance/distance_certificate.h"
#include "scb/any_hierarchy.h"
#include "scb/any_packed.h"
#include "scenes/meshes/mesh_file.h"
#include "tests/answer_table.h"
#include "tests/core/hierarchy/built_mesh.h"
#include "tests/real_models.h"
#include "tests/unless_sanitized.h"

// Distances of real meshes that PQP, FCL and a third program agree on, and the numbers of triangles
// within a tolerance. The README beside these answers says how they were made.

namespace scb::scenes {
namespace {

constexpr std::size_t largest_mesh = unless_sanitized(5000, 1300);

/// Meshes by name, with their hierarchies; null if a mesh is too large.
class BuiltModels {
  public:
    const BuiltMesh* find(const std::string& name) {
        const auto [at, is_new] = built_.try_emplace(name);
        if (!is_new) return at->second.get();
        const Mesh mesh = load_mesh(models_folder() / (name + ".ply"));
        if (mesh.triangles.size() <= largest_mesh) at->second = std::make_unique<BuiltMesh>(mesh);
        return at->second.get();
    }

  private:
    std::map<std::string, std::unique_ptr<BuiltMesh>> built_;
};

double largest_coordinate(const Mesh& a, const Mesh& b, const Pose& b_to_a) {
    double most = 0;
    for (const Vec3& v : a.vertices) most = std::max(most, v.cwiseAbs().maxCoeff());
    for (const Vec3& v : b.vertices)
        most = std::max(most, transform_point(b_to_a, v).cwiseAbs().maxCoeff());
    return most;
}

/// Calls `use` with the colliders of a kind of volume.
template <class Use>
void with_kind(const BuiltMesh& a, const BuiltMesh& b, std::size_t kind, const Use& use) {
    std::visit(
        [&]<Volume V>(const Hierarchy<V>& of_a) {
            use(Collider<V>{of_a, a.mesh},
                Collider<V>{std::get<Hierarchy<V>>(b.hierarchies[kind]), b.mesh});
        },
        a.hierarchies[kind]);
}

/// Calls `use` with each row of a table whose meshes are small enough. Returns the number of rows.
template <class Use>
int for_each_row(const std::string& file, const Use& use) {
    AnswerTable answers(file);
    BuiltModels built;
    int rows = 0;
    while (answers.next()) {
        const BuiltMesh *a = built.find(answers.text("meshA")),
                        *b = built.find(answers.text("meshB"));
        if (!a || !b) continue;
        SCOPED_TRACE(answers.text("row"));
        ++rows;
        use(answers, *a, *b);
    }
    return rows;
}

TEST(DistanceAnswers, AreFoundByEveryVolume) {
    if (!has_model_file("horse.ply", "distances of real meshes")) GTEST_SKIP();
    const auto check = [](const AnswerTable& row, const BuiltMesh& a, const BuiltMesh& b) {
        const Pose pose = row.pose();
        const double allowed = 4 * 0x1p-52 * largest_coordinate(a.mesh, b.mesh, pose),
                     answer = row.number("dist_ref");
        std::optional<Distance> first;
        for (std::size_t kind = 0; kind < all_volume_kinds().size(); ++kind) {
            SCOPED_TRACE(volume_kind_name(all_volume_kinds()[kind]));
            with_kind(a, b, kind, [&](const auto& of_a, const auto& of_b) {
                const Distance found = distance(of_a, of_b, pose);
                ASSERT_TRUE(found.triangles);
                EXPECT_NEAR(found.found.distance, answer, allowed);
                EXPECT_EQ(found.found.distance == 0, answer == 0);
                if (answer == 0) return;
                const std::string pair = std::to_string(found.triangles->a) + ":" +
                                         std::to_string(found.triangles->b),
                                  ties = "," + row.text("tied_pairs") + ",";
                EXPECT_TRUE(ties.find("," + pair + ",") != ties.npos || ties.ends_with("...,"))
                    << pair;
                if (!first) first = found;
                EXPECT_EQ(found.found.distance, first->found.distance);
                EXPECT_EQ(found.triangles, first->triangles);
            });
        }
    };
    EXPECT_GT(for_each_row("distances.tsv", check), unless_sanitized(20, 5));
}

TEST(DistanceAnswers, AreProven) {
    if (!has_model_file("horse.ply", "proofs of distances of real meshes")) GTEST_SKIP();
    const auto check = [](const AnswerTable& row, const BuiltMesh& a, const BuiltMesh& b) {
        const double answer = row.number("dist_ref");
        with_kind(a, b, static_cast<std::size_t>(VolumeKind::scb2),
                  [&](const auto& of_a, const auto& of_b) {
                      const Pose pose = row.pose();
                      const Distance found = distance(of_a, of_b, pose);
                      ASSERT_TRUE(found.triangles);
                      const MeshTree tree_a = mesh_tree(of_a), tree_b = mesh_tree(of_b);
                      const ProvenDistance proven =
                          check_distance(tree_a, tree_b, pose,
                                         make_certificate(tree_a, tree_b, pose, *found.triangles));
                      EXPECT_EQ(proven.fault, "");
                      EXPECT_TRUE(certifies(proven, found.found.distance));
                      EXPECT_TRUE(certifies(proven, answer));
                  });
    };
    EXPECT_GT(for_each_row("distances.tsv", check), unless_sanitized(20, 5));
}

/// A mesh of the table in all layouts, with one slab and two.
std::vector<AnyPacked> all_packed(const BuiltMesh& built) {
    std::vector<AnyPacked> result;
    for (const VolumeKind volume : {VolumeKind::scb, VolumeKind::scb2})
        for (const PackedLayout& layout : all_packed_layouts())
            result.push_back(
                pack_any(layout, built.hierarchies[static_cast<std::size_t>(volume)], built.mesh));
    return result;
}

TEST(DistanceAnswers, AreThoseOfTheReferenceInEveryLayout) {
    if (!has_model_file("horse.ply", "distances of real meshes")) GTEST_SKIP();
    const auto check = [](const AnswerTable& row, const BuiltMesh& a, const BuiltMesh& b) {
        const Pose pose = row.pose();
        const std::vector<AnyPacked> packed_a = all_packed(a), packed_b = all_packed(b);
        std::optional<Distance> expected;
        with_kind(
            a, b, static_cast<std::size_t>(VolumeKind::scb2),
            [&](const auto& of_a, const auto& of_b) { expected = distance(of_a, of_b, pose); });
        for (std::size_t i = 0; i < packed_a.size(); ++i) {
            const PackedDistance found =
                distance_packed(packed_a[i], a.mesh, packed_b[i], b.mesh, pose);
            EXPECT_EQ(found.found.distance, expected->found.distance) << i;
            if (found.found.distance > 0) {
                EXPECT_EQ(found.triangles, expected->triangles) << i;
            }
        }
    };
    EXPECT_GT(for_each_row("distances.tsv", check), unless_sanitized(20, 5));
}

TEST(DistanceAnswers, WithinATolerance) {
    if (!has_model_file("horse.ply", "triangles of real meshes within a tolerance")) GTEST_SKIP();
    const auto check = [](const AnswerTable& row, const BuiltMesh& a, const BuiltMesh& b) {
        for (const VolumeKind volume : {VolumeKind::scb2, VolumeKind::obb})
            with_kind(
                a, b, static_cast<std::size_t>(volume), [&](const auto& of_a, const auto& of_b) {
                    const Collision found = within(of_a, of_b, row.pose(), row.number("tolerance"));
                    EXPECT_EQ(std::to_string(found.pairs.size()), row.text("pairs_own"));
                });
        const std::vector<AnyPacked> packed_a = all_packed(a), packed_b = all_packed(b);
        for (std::size_t i = 0; i < packed_a.size(); ++i) {
            const PackedWithin found = within_packed(packed_a[i], a.mesh, packed_b[i], b.mesh,
                                                     row.pose(), row.number("tolerance"));
            EXPECT_EQ(std::to_string(found.pairs.size()), row.text("pairs_own")) << i;
        }
    };
    EXPECT_GT(for_each_row("within.tsv", check), unless_sanitized(5, 0));
}

}  // namespace
}  // namespace scb::scenes
