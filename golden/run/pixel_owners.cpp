#include "golden/run/pixel_owners.h"

#include <nlohmann/json.hpp>

#include "core/base/parallel_for.h"
#include "core/platform/json_reader.h"
#include "scb/error.h"
#include "scenes/meshes/isolated_mesh.h"
#include "scenes/scene/load_scene.h"
#include "scenes/scene/scene_hierarchies.h"

namespace scb::golden {
namespace {

using Json = nlohmann::json;

}  // namespace

Owners::Owners(const GoldenCase& golden, const GoldenRunSettings& settings,
               const std::filesystem::path& index, bool same_meshes)
    : same_meshes_(same_meshes) {
    const Json document = parse_json(read_text_file(index.string()), index.string());
    try {
        scenes::LoadOptions options;
        options.models_dir = settings.models;
        const scenes::Scene scene = scenes::load_scene(golden.scene, options);
        const std::vector<MeshTopology> topologies =
            scenes::build_topologies(scene, {.threads = processor_count()});
        for (const scenes::Body& body : scene.bodies)
            depths_[body.name] = node_depths(*topologies[body.mesh].topology);
        add_ranges(document);
    } catch (const InputError&) {
        // Then things have only numbers.
    } catch (const scenes::MeshReaderError&) {
    } catch (const Json::exception&) {
    }
}

std::string Owners::name(std::uint32_t id) const {
    for (const IdRange& range : ranges_) {
        if (id < range.first || id - range.first >= range.count) continue;
        const std::uint32_t number = id - range.first;
        std::string text = range.what + " " + std::to_string(number);
        if (!range.body.empty()) text += " of " + range.body;
        const auto depths = depths_.find(range.body);
        if (same_meshes_ && range.what == "node" && depths != depths_.end() &&
            number < depths->second.size())
            text += ", level " + std::to_string(depths->second[number]);
        return text;
    }
    return "";
}

void Owners::add_ranges(const Json& index) {
    const Json& drawn = index.at("files").at(0);
    if (index.contains("ids"))
        for (const Json& range : index["ids"])
            ranges_.push_back(
                {range.at("what"), range.at("body"), range.at("first"), range.at("count")});
    // This file describes the new run. Pairs have the last ids: with the same meshes, all ids
    // behind them are pairs of the baseline, which may have more.
    if (drawn.contains("pair_ids"))
        ranges_.push_back(
            {"pair", "", drawn["pair_ids"].at("first"),
             same_meshes_ ? UINT32_MAX : drawn["pair_ids"].at("count").get<std::uint32_t>()});
    if (!drawn.contains("bodies")) return;
    for (const Json& body : drawn["bodies"]) {
        const std::string name = body.at("body");
        ranges_.push_back(
            {"node", name, body.at("first_id"), static_cast<std::uint32_t>(depths_[name].size())});
    }
}

}  // namespace scb::golden
