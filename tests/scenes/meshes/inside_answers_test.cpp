#include <gtest/gtest.h>

#include <array>
#include <charconv>
#include <fstream>
#include <optional>
#include <sstream>

#include "core/geometry/mesh_parts.h"
#include "core/hierarchy/mesh_parity.h"
#include "scenes/meshes/mesh_file.h"
#include "tests/real_models.h"

namespace scb::scenes {
namespace {

constexpr const char* answer_names[] = {"out", "in", "on"};

// Points at, near and far from the surfaces of 24 meshes, by three exact rays each and by CGAL.
TEST(MeshParity, AgreesWithTheAnswersOfOtherLibraries) {
    if (!has_model_file("../answers/inside.tsv", "which points are inside of real meshes"))
        GTEST_SKIP();
    std::ifstream table(models_folder() / "../answers/inside.tsv");
    std::string line, name, read;
    Mesh mesh;
    Topology topology;
    std::optional<MeshParity> parity;
    std::size_t rows = 0;
    while (std::getline(table, line)) {
        if (line.starts_with('#')) continue;
        std::istringstream cells(line);
        std::array<std::string, 3> numbers;
        std::string answer;
        cells >> name >> numbers[0] >> numbers[1] >> numbers[2] >> answer;
        if (name != read) {
            parity.reset();
            mesh = load_mesh(models_folder() / (name + ".ply"));
            ASSERT_TRUE(are_closed(joined_triangles(mesh))) << name;
            topology = build_topology(mesh);
            parity.emplace(mesh, topology);
            read = name;
        }
        Vec3 point;
        for (std::size_t i = 0; i < 3; ++i)
            std::from_chars(numbers[i].data(), numbers[i].data() + numbers[i].size(),
                            point[static_cast<int>(i)]);
        EXPECT_EQ(answer_names[static_cast<int>(parity->side(point))], answer) << line;
        ++rows;
    }
    EXPECT_EQ(rows, 4800u);
}

}  // namespace
}  // namespace scb::scenes
