#include "scenes/scene/model_file.h"

#include <optional>

#include "scb/error.h"
#include "scenes/meshes/mesh_file.h"
#include "scenes/scene/named_file.h"

namespace scb::scenes {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t most_of_a_mesh = std::int64_t{1} << 28;

/// The expected properties of a model's mesh file.
struct Expected {
    std::optional<std::size_t> vertices, triangles;
    std::string published;
};

std::optional<std::size_t> read_count(const JsonPlace& model, const char* name) {
    if (!has(model, name)) return std::nullopt;
    return static_cast<std::size_t>(read_integer(field(model, name), 1, most_of_a_mesh));
}

Expected read_expected(const JsonPlace& model) {
    return {read_count(model, "vertices"), read_count(model, "triangles"),
            has(model, "published") ? read_plain_text(field(model, "published")) : ""};
}

std::string count_text(std::size_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// `48485 vertices and 96966 triangles`, or the known part; may be empty.
std::string counts_text(std::optional<std::size_t> vertices, std::optional<std::size_t> triangles) {
    std::string text;
    if (vertices) text += count_text(*vertices, "vertex", "vertices");
    if (vertices && triangles) text += " and ";
    if (triangles) text += count_text(*triangles, "triangle", "triangles");
    return text;
}

/// ` (48485 vertices and 96966 triangles; published: Some Archive)`, or the known part.
std::string remark(const Expected& expected) {
    std::string text = counts_text(expected.vertices, expected.triangles);
    if (!expected.published.empty())
        text += (text.empty() ? "published: " : "; published: ") + expected.published;
    return text.empty() ? "" : " (" + text + ")";
}

void check_counts(const Mesh& mesh, const fs::path& path, const Expected& expected,
                  const JsonPlace& place) {
    const std::size_t vertices = mesh.vertices.size(), triangles = mesh.triangles.size();
    if (vertices == expected.vertices.value_or(vertices) &&
        triangles == expected.triangles.value_or(triangles))
        return;
    refuse(place,
           path.string() + " has " + counts_text(vertices, triangles) +
               ", but the scene was made for " +
               counts_text(expected.vertices, expected.triangles) +
               (expected.published.empty() ? "" : " (published: " + expected.published + ")") +
               "; give that mesh, or a scene file with the counts of this one.");
}

}  // namespace

NamedMesh read_model_file(const JsonPlace& place, const SceneContext& context) {
    const JsonPlace file = field(place, "file");
    const Expected expected = read_expected(place);
    const fs::path path = named_file(file, context, "mesh file", remark(expected));
    NamedMesh model{"", {}, path};
    try {
        model.mesh = load_mesh(path);
    } catch (const InputError& error) {
        refuse(file, error.what());
    }
    check_counts(model.mesh, path, expected, file);
    return model;
}

}  // namespace scb::scenes
