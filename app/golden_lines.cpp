#include "app/golden_lines.h"

#include <algorithm>
#include <map>
#include <sstream>

#include "app/options.h"
#include "app/scene_hierarchies.h"
#include "app/trace_input.h"
#include "core/error.h"
#include "golden/baseline.h"
#include "render/image_file.h"
#include "scenes/json_reader.h"

namespace scb {
namespace {

using Json = nlohmann::json;

/// More do not help a reader.
constexpr std::size_t most_things = 10;

/// What the ids from `first` on are: nodes or triangles of a body, or pairs.
struct IdRange {
    std::string what, body;
    std::uint32_t first = 0, count = 0;
};

/// Names what owns the pixels of a case's pictures.
class Owners {
  public:
    Owners(const GoldenCase& golden, const Json& index, const GoldenRunSettings& settings) {
        try {
            SceneOptions options;
            options.names = golden.scene;
            options.models_dir = settings.models;
            const Scene scene = options.load();
            const std::vector<MeshTopology> topologies = build_topologies(scene);
            for (const Body& body : scene.bodies)
                depths_[body.name] = node_depths(*topologies[body.mesh].topology);
            add_ranges(index);
        } catch (const InputError&) {
            // Then things have numbers only.
        } catch (const Json::exception&) {
        }
    }

    std::string name(std::uint32_t id) const {
        for (const IdRange& range : ranges_) {
            if (id < range.first || id - range.first >= range.count) continue;
            const std::uint32_t number = id - range.first;
            std::string text = range.what + " " + std::to_string(number);
            if (!range.body.empty()) text += " of " + range.body;
            const auto depths = depths_.find(range.body);
            if (range.what == "node" && depths != depths_.end() && number < depths->second.size())
                text += ", level " + std::to_string(depths->second[number]) + ",";
            return text;
        }
        return "thing " + std::to_string(id);
    }

  private:
    void add_ranges(const Json& index) {
        const Json& drawn = index.at("files").at(0);
        if (index.contains("ids"))
            for (const Json& range : index["ids"])
                ranges_.push_back(
                    {range.at("what"), range.at("body"), range.at("first"), range.at("count")});
        if (drawn.contains("pair_ids"))
            ranges_.push_back(
                {"pair", "", drawn["pair_ids"].at("first"), drawn["pair_ids"].at("count")});
        if (!drawn.contains("bodies")) return;
        for (const Json& body : drawn["bodies"]) {
            const std::string name = body.at("body");
            ranges_.push_back({"node", name, body.at("first_id"),
                               static_cast<std::uint32_t>(depths_[name].size())});
        }
    }

    std::vector<IdRange> ranges_;
    std::map<std::string, std::vector<std::uint16_t>> depths_;  // per body, per node
};

std::string pixels(std::size_t count) {
    return std::to_string(count) + (count == 1 ? " pixel" : " pixels");
}

std::string capitalized(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
        text[0] = static_cast<char>(text[0] - 32);
    return text;
}

void add_id_lines(CaseResult& result, const Owners& owners) {
    std::size_t said = 0;
    for (const IdChange& change : result.ids->changes) {
        if (said++ == most_things) break;
        const std::string name = capitalized(owners.name(change.id));
        if (change.after == 0)
            result.lines.push_back(name + " is missing: " + pixels(change.before) + ".");
        else if (change.before == 0)
            result.lines.push_back(name + " is new: " + pixels(change.after) + ".");
        else
            result.lines.push_back(name + " had " + pixels(change.before) + " and has " +
                                   std::to_string(change.after) + ".");
    }
    if (result.ids->changes.size() > most_things)
        result.lines.push_back(std::to_string(result.ids->changes.size() - most_things) +
                               " more things have other pixels.");
}

/// Things whose pixels have other colors where the ids are the same.
void add_color_lines(CaseResult& result, const ComparisonFolders& folders, const Owners& owners) {
    const CaseFiles made = case_files(folders.candidates, result.name);
    const std::vector<std::filesystem::path> accepted =
        accepted_images(folders.baselines, result.name);
    const Image before = read_png(accepted[static_cast<std::size_t>(result.variant) - 1]),
                after = read_png(made.image);
    const IdImage ids = unpack_ids(read_png(made.ids));
    if (ids.width != after.width || ids.height != after.height) return;
    std::map<std::uint32_t, std::size_t> changed;
    for (int y = 0; y < after.height; ++y)
        for (int x = 0; x < after.width; ++x)
            if (!(pixel(before, x, y) == pixel(after, x, y))) ++changed[pixel(ids, x, y)];
    std::vector<std::pair<std::uint32_t, std::size_t>> most(changed.begin(), changed.end());
    std::stable_sort(most.begin(), most.end(),
                     [](const auto& x, const auto& y) { return x.second > y.second; });
    for (std::size_t i = 0; i < most.size() && i < most_things; ++i)
        result.lines.push_back(capitalized(most[i].first == 0
                                               ? std::string("the background, or text and figures,")
                                               : owners.name(most[i].first)) +
                               " has other colors: " + pixels(most[i].second) + ".");
    if (most.size() > most_things)
        result.lines.push_back(std::to_string(most.size() - most_things) +
                               " more things have other colors.");
}

/// Volume tests by the depth of the pair, frame by frame.
Json tests_by_depth(const std::filesystem::path& trace) {
    TraceInput input(trace.string());
    Json counts = Json::object();
    while (const TraceFrame* frame = input.reader.next()) {
        std::map<int, std::int64_t> tests;
        for (const VolumeTest& test : frame->events.volume_tests)
            ++tests[test.depth_a + test.depth_b];
        for (const auto& [depth, count] : tests)
            counts["frames"][std::to_string(frame->frame)]["n_v at depth"][std::to_string(depth)] =
                count;
    }
    return counts;
}

void add_trace_lines(CaseResult& result, const GoldenRunSettings& settings,
                     const ComparisonFolders& folders) {
    const std::filesystem::path before = case_files(folders.baselines, result.name).trace,
                                after = case_files(folders.candidates, result.name).trace;
    std::error_code ignored;
    if (!std::filesystem::exists(before, ignored) || !std::filesystem::exists(after, ignored))
        return;
    for (CountChange& change : counts_difference(tests_by_depth(before), tests_by_depth(after)))
        result.counts.push_back(std::move(change));
    const ProgramAnswer answer = ask_program(settings, {"diff", before.string(), after.string()});
    if (answer.status != 1) return;
    std::istringstream stream(answer.text);
    for (std::string line; std::getline(stream, line);)
        if (!line.empty()) result.lines.push_back(line);
}

}  // namespace

void add_lines(CaseResult& result, const GoldenCase& golden, const GoldenRunSettings& settings,
               const ComparisonFolders& folders) {
    if (result.verdict != Verdict::different) return;
    try {
        if (result.ids || (result.colors && golden.ids)) {
            const std::string file = (folders.candidates / (result.name + ".index.json")).string();
            const Owners owners(golden, parse_json(read_text_file(file), file), settings);
            if (result.ids) add_id_lines(result, owners);
            if (result.colors && golden.ids) add_color_lines(result, folders, owners);
        }
        add_trace_lines(result, settings, folders);
    } catch (const InputError& error) {
        result.lines.push_back(error.what());
    }
}

}  // namespace scb
