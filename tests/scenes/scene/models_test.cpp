#include <sstream>

#include "scenes/meshes/mesh_file.h"
#include "tests/real_models.h"
#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

/// The rows `| FILE.ply | VERTICES (...) | TRIANGLES | ...` of the table that describes the models.
struct Row {
    std::string file;
    std::size_t vertices = 0, triangles = 0;
};

std::vector<Row> table(const std::filesystem::path& readme) {
    std::ifstream stream(readme);
    std::vector<Row> rows;
    for (std::string line; std::getline(stream, line);) {
        std::istringstream cells(line);
        std::string bar, file, vertices, skipped, triangles;
        cells >> bar >> file;
        if (bar != "|" || file.size() < 5 || file.substr(file.size() - 4) != ".ply") continue;
        std::getline(cells, skipped, '|');
        std::getline(cells, vertices, '|');
        std::getline(cells, triangles, '|');
        rows.push_back({file, std::stoul(vertices), std::stoul(triangles)});
    }
    return rows;
}

TEST(Models, HaveTheCountsThatTheirTableStates) {
    if (!has_model_file("README.md", "the counts of real meshes")) GTEST_SKIP();
    const std::vector<Row> rows = table(models_folder() / "README.md");
    EXPECT_GE(rows.size(), 30u);
    for (const Row& row : rows) {
        const Mesh mesh = load_mesh(models_folder() / row.file);
        EXPECT_EQ(mesh.vertices.size(), row.vertices) << row.file;
        EXPECT_EQ(mesh.triangles.size(), row.triangles) << row.file;
    }
}

}  // namespace
}  // namespace scb::scenes
