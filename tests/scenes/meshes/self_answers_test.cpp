#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/collide/index_pairs.h"
#include "scb/any_collide.h"
#include "scenes/meshes/mesh_file.h"
#include "tests/real_models.h"
#include "tests/unless_sanitized.h"

namespace scb::scenes {
namespace {

// The pairs of 35 meshes against themselves, by CGAL and by rational arithmetic.
TEST(CollideSelf, AgreesWithTheAnswersOfOtherLibraries) {
    if (!has_model_file("../answers/self.tsv", "which triangles of real meshes intersect"))
        GTEST_SKIP();
    std::ifstream table(models_folder() / "../answers/self.tsv");
    std::size_t rows = 0, with_pairs = 0;
    for (std::string line; std::getline(table, line);) {
        if (line.starts_with('#')) continue;
        std::istringstream cells(line);
        std::string name, hash, hash_of_all;
        std::size_t triangles = 0, degenerate = 0, pairs = 0, pairs_with_degenerate = 0;
        cells >> name >> triangles >> degenerate >> pairs >> hash >> pairs_with_degenerate >>
            hash_of_all;
        ++rows;
        // The volumes of small meshes; of large ones boxes alone, whose tests take the least time.
        constexpr std::size_t small = unless_sanitized<std::size_t>(3000, 500),
                              most = unless_sanitized<std::size_t>(SIZE_MAX, 8'000);
        if (triangles > most) continue;
        const Mesh mesh = load_mesh(models_folder() / (name + ".ply"));
        const std::vector<std::uint32_t> joined = joined_vertices(mesh);
        const std::vector<VolumeKind> boxes = {VolumeKind::aabb};
        const std::span<const VolumeKind> kinds = triangles <= small ? all_volume_kinds() : boxes;
        for (const AnyHierarchy& hierarchy : build_hierarchies(mesh, kinds)) {
            const Collision found = collide_self(hierarchy, mesh, joined);
            EXPECT_EQ(found.pairs.size(), pairs + pairs_with_degenerate) << name;
            EXPECT_EQ(hash_text(pairs_hash(found.pairs)), hash_of_all) << name;
        }
        with_pairs += pairs + pairs_with_degenerate > 0;
    }
    EXPECT_EQ(rows, 35u);
    EXPECT_GE(with_pairs, 3u);
}

}  // namespace
}  // namespace scb::scenes
