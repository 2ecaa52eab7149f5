#include <algorithm>
#include <array>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "core/collide/index_pairs.h"
#include "scenes/meshes/mesh_file.h"
#include "tests/core/collide/brute_force.h"
#include "tests/core/hierarchy/built_mesh.h"
#include "tests/core/packed/packed_variants.h"
#include "tests/real_models.h"
#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

/// One row of peer_counts.tsv: two meshes, where B is, and the triangle pairs that an exact library
/// found there.
struct PeerScene {
    int id = 0;
    std::string mesh_a, mesh_b;
    Pose pose;
    std::size_t pairs = 0;
    std::string hash;  ///< FNV-1a of the sorted pairs, each as "%d %d\n"
    std::string kind;  ///< "generic" or "touching"
};

std::vector<PeerScene> peer_scenes() {
    std::ifstream file(models_folder() / "peer_counts.tsv");
    std::vector<PeerScene> scenes;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::istringstream cells(line);
        PeerScene s;
        cells >> s.id >> s.mesh_a >> s.mesh_b;
        // strtod: istream refuses some numbers that printf wrote.
        const auto number = [&cells] {
            std::string text;
            cells >> text;
            return std::strtod(text.c_str(), nullptr);
        };
        for (int i = 0; i < 9; ++i) s.pose.rotation(i / 3, i % 3) = number();
        for (int i = 0; i < 3; ++i) s.pose.translation[i] = number();
        std::size_t other, only_cgal, only_fcl, unstable;
        cells >> s.pairs >> other >> only_cgal >> only_fcl >> unstable >> s.hash >> s.kind;
        scenes.push_back(s);
    }
    return scenes;
}

std::vector<std::string> first_meshes() {
    std::vector<std::string> names;
    for (const PeerScene& scene : peer_scenes())
        if (std::find(names.begin(), names.end(), scene.mesh_a) == names.end())
            names.push_back(scene.mesh_a);
    if (names.empty()) names.push_back("none");
    return names;
}

// The recorded hashes start here, not at FNV's basis.
constexpr std::uint64_t recorded_start = 0x14650fb0739d0383;

/// The exact library left exactly degenerate triangles out. They are segments and points here and
/// may intersect, so they are left out of both for comparing.
std::vector<IndexPair> without_degenerate(const std::vector<IndexPair>& pairs, const Mesh& a,
                                          const Mesh& b) {
    std::vector<IndexPair> kept;
    for (const IndexPair& pair : pairs)
        if (!is_degenerate(a, pair.a) && !is_degenerate(b, pair.b)) kept.push_back(pair);
    return kept;
}

/// A scene, and the pairs that its query found.
struct AnsweredScene {
    PeerScene scene;
    std::vector<IndexPair> pairs;
};

/// Every layout, with one slab and with two.
std::vector<std::pair<PackedLayout, bool>> packed_variants() {
    std::vector<std::pair<PackedLayout, bool>> all;
    for (const PackedLayout& layout : all_packed_layouts())
        for (const bool two_slabs : {false, true}) all.push_back({layout, two_slabs});
    return all;
}

/// Every layout, the widest at every SIMD level, finds these pairs.
void expect_packed(const std::map<std::string, BuiltMesh>& meshes,
                   const std::vector<AnsweredScene>& answered) {
    for (const auto& [layout, two_slabs] : packed_variants()) {
        std::map<std::string, AnyPacked> packed;
        for (const auto& [name, built] : meshes)
            packed.emplace(name, two_slabs ? pack_any(layout, scb_of<Scb2>(built), built.mesh)
                                           : pack_any(layout, scb_of<Scb>(built), built.mesh));
        for (const auto& [scene, pairs] : answered)
            for (const SimdLevel level : available_simd_levels()) {
                if (layout.width != 8 && level != SimdLevel::best) continue;
                ASSERT_EQ(collide_packed(packed.at(scene.mesh_a), meshes.at(scene.mesh_a).mesh,
                                         packed.at(scene.mesh_b), meshes.at(scene.mesh_b).mesh,
                                         scene.pose, {level})
                              .pairs,
                          pairs)
                    << "scene " << scene.id << ", " << packed_layout_name(layout) << ", "
                    << (two_slabs ? "two slabs, " : "") << simd_level_name(level);
            }
    }
}

class PeerPairs : public testing::TestWithParam<std::string> {};

// Every scene of the recorded answers, in every hierarchy, by every test but the one with line 8 as
// printed, and by every descent rule.
TEST_P(PeerPairs, AreFoundByEveryHierarchyTestAndDescentRule) {
    if (!has_model_file("peer_counts.tsv", "pairs against other libraries'")) GTEST_SKIP();
#ifdef SCB_SANITIZED
    if (load_mesh(models_folder() / (GetParam() + ".ply")).triangles.size() > 1'000)
        GTEST_SKIP() << "NOT TESTED: large meshes with sanitizers.";
#endif
    std::map<std::string, BuiltMesh> meshes;
    std::vector<AnsweredScene> answered;
    for (const PeerScene& scene : peer_scenes()) {
        if (scene.mesh_a != GetParam()) continue;
        for (const std::string& name : {scene.mesh_a, scene.mesh_b})
            if (!meshes.contains(name))
                meshes.emplace(name, load_mesh(models_folder() / (name + ".ply")));
        const BuiltMesh &a = meshes.at(scene.mesh_a), &b = meshes.at(scene.mesh_b);
        std::optional<std::vector<IndexPair>> first;
        for (const QueryVariant& variant : all_query_variants()) {
#ifdef SCB_SANITIZED
            if (variant.options.descent != DescentRule::radius) continue;
#endif
            const Collision found = query(a, b, scene.pose, variant);
            const std::string what = "scene " + std::to_string(scene.id) + " (" + scene.mesh_a +
                                     ", " + scene.mesh_b + ", " + scene.kind + "), " +
                                     variant.name();
            if (!first) {
                first = found.pairs;
                const std::vector<IndexPair> kept = without_degenerate(*first, a.mesh, b.mesh);
                EXPECT_EQ(kept.size(), scene.pairs) << what;
                EXPECT_EQ(hash_text(pairs_hash(kept, recorded_start)), scene.hash) << what;
                if (kept.size() != first->size())
                    std::cerr << what << ": " << first->size() - kept.size()
                              << " pairs with a degenerate triangle besides\n";
            }
            ASSERT_EQ(found.pairs, *first) << what;
        }
        answered.push_back({scene, *first});
    }
    expect_packed(meshes, answered);
}

TEST(PeerScenes, AreAllNinetyEight) {
    if (!has_model_file("peer_counts.tsv", "the number of recorded scenes")) GTEST_SKIP();
    EXPECT_EQ(peer_scenes().size(), 98u);
}

INSTANTIATE_TEST_SUITE_P(Models, PeerPairs, testing::ValuesIn(first_meshes()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace scb::scenes
