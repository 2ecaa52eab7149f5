#include "golden/compare/mesh_difference.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "golden/compare/number_words.h"
#include "render/files/output_file.h"
#include "scenes/text/json_reader.h"

namespace scb::golden {
namespace {

constexpr std::int64_t most = std::int64_t{1} << 32;

/// What tells the mesh of each body from others.
std::map<std::string, std::string> meshes_in(const std::filesystem::path& file) {
    std::map<std::string, std::string> meshes;
    if (!render::is_there(file)) return meshes;
    const nlohmann::json document =
        scenes::parse_json(scenes::read_text_file(file.string()), file.string());
    const scenes::JsonPlace all{&document, file.string(), ""};
    if (!document.is_object()) scenes::refuse_value(all, "an object");
    if (!scenes::has(all, "bodies")) return meshes;
    const scenes::JsonPlace bodies = scenes::field(all, "bodies");
    const std::size_t size = scenes::array_size(bodies, "a list of bodies");
    for (std::size_t i = 0; i < size; ++i) {
        const scenes::JsonPlace body = scenes::element(bodies, i);
        scenes::check_fields(body, {"name", "triangles", "vertices", "hash"});
        const auto counted = [&](const char* what, const char* one) {
            return words::counted(static_cast<std::uint64_t>(
                                      scenes::read_integer(scenes::field(body, what), 0, most)),
                                  one, what);
        };
        meshes[scenes::read_text(scenes::field(body, "name"))] =
            counted("triangles", "triangle") + ", " + counted("vertices", "vertex") + ", hash " +
            scenes::read_text(scenes::field(body, "hash"));
    }
    return meshes;
}

}  // namespace

std::string mesh_sentences(const std::filesystem::path& before,
                           const std::filesystem::path& after) {
    const std::map<std::string, std::string> was = meshes_in(before), is = meshes_in(after);
    // Bodies often have one mesh.
    std::vector<std::pair<std::string, std::string>> changes;  // and who has them
    for (const auto& [body, mesh] : is) {
        const auto old = was.find(body);
        if (old == was.end() || old->second == mesh) continue;
        const std::string change = mesh + " instead of " + old->second;
        const auto same = std::find_if(changes.begin(), changes.end(),
                                       [&](const auto& c) { return c.first == change; });
        if (same == changes.end())
            changes.emplace_back(change, body);
        else
            same->second += " and " + body;
    }
    std::string sentences;
    for (const auto& [change, bodies] : changes)
        sentences += (sentences.empty() ? "The mesh of " : " The mesh of ") + bodies +
                     " is another: " + change + ".";
    return sentences;
}

}  // namespace scb::golden
