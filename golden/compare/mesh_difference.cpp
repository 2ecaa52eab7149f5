#include "golden/compare/mesh_difference.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "golden/compare/number_words.h"
#include "golden/suite/files_equal.h"
#include "scenes/text/json_reader.h"

namespace scb {
namespace {

constexpr std::int64_t most = std::int64_t{1} << 32;

/// What tells the mesh of each body from others.
std::map<std::string, std::string> meshes_in(const std::filesystem::path& file) {
    std::map<std::string, std::string> meshes;
    if (!is_there(file)) return meshes;
    const nlohmann::json document = parse_json(read_text_file(file.string()), file.string());
    const JsonPlace all{&document, file.string(), ""};
    if (!document.is_object()) refuse_value(all, "an object");
    if (!has(all, "bodies")) return meshes;
    const JsonPlace bodies = field(all, "bodies");
    const std::size_t size = array_size(bodies, "a list of bodies");
    for (std::size_t i = 0; i < size; ++i) {
        const JsonPlace body = element(bodies, i);
        check_fields(body, {"name", "triangles", "vertices", "hash"});
        const auto counted = [&](const char* what, const char* one) {
            return words::counted(
                static_cast<std::uint64_t>(read_integer(field(body, what), 0, most)), one, what);
        };
        meshes[read_text(field(body, "name"))] = counted("triangles", "triangle") + ", " +
                                                 counted("vertices", "vertex") + ", hash " +
                                                 read_text(field(body, "hash"));
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

}  // namespace scb
