#include "app/golden/init_suite.h"

#include <algorithm>
#include <bit>
#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>

#include "app/golden/init_camera.h"
#include "core/base/text_format.h"
#include "render/gl/embedded.h"
#include "scb/error.h"
#include "scenes/scene/builtin.h"

SCB_DECLARE_EMBEDDED(golden_cases_json)

namespace scb::app {
namespace {

namespace fs = std::filesystem;
using kainjow::mustache::data;

constexpr const char* picture_size = "400x300";

/// The name in the suite: files are relative to its folder.
std::string name_from(const std::string& name, const fs::path& folder) {
    if (scenes::find_builtin(name) != nullptr) return name;
    // Only the beginning of the folder's path need exist.
    const fs::path relative = fs::relative(fs::absolute(name), fs::absolute(folder));
    return (relative.empty() ? fs::absolute(name) : relative).string();
}

/// A JSON list on one line, with a blank after each comma.
std::string list_text(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : ", ") + nlohmann::json(word).dump();
    return "[" + text + "]";
}

std::string scene_text(const std::vector<std::string>& names, const fs::path& folder) {
    std::vector<std::string> own;
    for (const std::string& name : names) own.push_back(name_from(name, folder));
    return own.size() == 1 ? nlohmann::json(own[0]).dump() : list_text(own);
}

/// About eleven of the frames, including the first and nearly the last; empty if there is one.
std::string some_frames(int frames) {
    if (frames == 1) return "";
    if (frames <= 11) return "all";
    const int step = (frames - 1 + 9) / 10;
    return "0:" + std::to_string(frames - 1) + ":" + std::to_string(step);
}

/// A level near the root and a finer one. A tree of n leaves, each a triangle, is at least log2(n)
/// deep.
std::vector<int> some_levels(const scenes::Scene& scene) {
    std::size_t most = 1;
    for (const scenes::NamedMesh& named : scene.meshes)
        most = std::max(most, named.mesh.triangles.size());
    const int depth = static_cast<int>(std::bit_width(most - 1));
    std::vector<int> levels = {std::min(5, depth)};
    if (depth > 5) levels.push_back(std::min(7, depth));
    return levels;
}

/// The options that the scene needs besides its name.
std::vector<std::string> pose_words(const SceneOptions& options, const fs::path& folder) {
    const auto [of_a, of_b] = options.pose_logs();
    const std::string b = of_b.empty() ? "" : name_from(of_b, folder);
    if (!of_a.empty()) {
        // A body may have the name B.
        const auto [name_a, name_b] = scenes::body_names(options.names[0], options.names[1]);
        return {"--poses",
                name_a + "=" + name_from(of_a, folder) + (b.empty() ? "" : "," + name_b + "=" + b)};
    }
    if (!b.empty()) return {"--poses", b};
    if (options.pose.empty()) return {};
    std::string numbers;
    for (const double number : options.pose)
        numbers += (numbers.empty() ? "" : ",") + exact_number(number);
    return {"--pose", numbers};
}

/// The arguments of a case with this picture, if any: `words`, and the camera.
void add_view(data& collides, const std::string& name, const SceneOptions& options,
              const std::string& bodies, int frame, std::vector<std::string> words) {
    for (std::string& word : seeing_camera_words(options, bodies, frame, picture_size))
        words.push_back(std::move(word));
    if (!words.empty()) collides[name] = list_text(words);
}

void add_collisions(data& values, std::size_t& cases, const scenes::Scene& scene,
                    const SceneOptions& options, std::vector<std::string> words) {
    if (scene.bodies.size() < 2) return;
    data collides;
    if (!words.empty()) collides["counted"] = list_text(words);
    std::string bodies;
    if (scene.bodies.size() > 2) {
        // Counts are of all pairs of bodies, pictures of one pair.
        bodies = scene.bodies[0].name + "," + scene.bodies[1].name;
        words.insert(words.end(), {"--bodies", bodies});
    }
    // When bodies touch, most tests pass; halfway, more are rejected.
    const int middle = scene.frames / 2;
    collides["middle"] = std::to_string(middle);
    if (const std::string frames = some_frames(scene.frames); !frames.empty())
        collides["frames"] = frames;
    add_view(collides, "pairs", options, bodies, scene.default_frame, words);
    add_view(collides, "rejections", options, bodies, middle, words);
    values.set("collides", collides);
    cases += 3;
}

void add_levels(data& values, std::size_t& cases, const scenes::Scene& scene,
                const std::vector<std::string>& words) {
    data levels(data::type::list);
    const std::vector<int> chosen = some_levels(scene);
    for (const int level : chosen) {
        std::vector<std::string> arguments = words;
        arguments.emplace_back("--levels");
        arguments.push_back(std::to_string(level));
        data row;
        row["level"] = std::to_string(level);
        row["arguments"] = list_text(arguments);
        row["last"] = data(level == chosen.back() ? data::type::bool_true : data::type::bool_false);
        levels << row;
        ++cases;
    }
    values.set("levels", levels);
}

}  // namespace

FirstSuite first_suite(const SceneOptions& options, const fs::path& folder) {
    if (options.is_recording())
        throw InputError(options.names[0] +
                         ": a suite of a recording is written by hand; golden/README.md has an "
                         "example.");
    const scenes::Scene scene = options.load();
    FirstSuite suite;
    if (!scene.file.empty()) suite.files.push_back(scene.file);
    const auto add_file = [&files = suite.files](const fs::path& file) {
        if (!file.empty() && std::find(files.begin(), files.end(), file) == files.end())
            files.push_back(file);
    };
    for (const scenes::NamedMesh& named : scene.meshes) add_file(named.file);
    for (const scenes::Body& body : scene.bodies) add_file(body.motion.log);
    data values;
    values["scene"] = scene_text(options.names, folder);
    values["size"] = std::string(picture_size);
    values["frame"] = std::to_string(scene.default_frame);
    const std::vector<std::string> words = pose_words(options, folder);
    add_collisions(values, suite.cases, scene, options, words);
    add_levels(values, suite.cases, scene, words);
    kainjow::mustache::mustache text{std::string(SCB_EMBEDDED(golden_cases_json))};
    suite.text = text.render(values);
    return suite;
}

}  // namespace scb::app
