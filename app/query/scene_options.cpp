#include "app/query/scene_options.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <sstream>

#include "core/base/text_format.h"
#include "render/files/output_file.h"
#include "scb/error.h"
#include "scenes/text/utf8.h"
#include "scenes/traces/trace_input.h"

namespace scb {
namespace {

template <class Number>
bool parses_as(const std::string& text) {
    Number value{};
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, value);
    return parsed.ec == std::errc() && parsed.ptr == end;
}

void refuse_same_file(const std::string& output, const std::string& option,
                      const std::filesystem::path& input) {
    std::error_code ignored;
    if (std::filesystem::equivalent(output, input, ignored))
        throw InputError(option + " " + output +
                         ": the scene is read from this file; name another.");
}

}  // namespace

Scene SceneOptions::load() const {
    for (const std::string& name : names)
        if (names_trace(name) && std::filesystem::exists(name))
            throw InputError(name +
                             ": this is a trace, which is named alone, or with a second one where "
                             "two are compared; print it with `scb trace`.");
    LoadOptions load_options;
    load_options.models_dir = models_dir;
    if (!pose.empty()) {
        Pose p;
        for (int row = 0; row < 3; ++row) {
            const auto first = static_cast<std::size_t>(4 * row);
            for (int column = 0; column < 3; ++column)
                p.rotation(row, column) = pose[first + static_cast<std::size_t>(column)];
            p.translation[row] = pose[first + 3];
        }
        if (!(p.translation.cwiseAbs().maxCoeff() <= max_coordinate))
            throw InputError(
                "--pose: its translation is not finite or beyond 1e70; move the "
                "bodies nearer to the origin.");
        load_options.pose = p;
    }
    return load_scene(names, load_options);
}

int SceneOptions::frame_of(const Scene& scene) const {
    const int wanted = frame.value_or(scene.default_frame);
    if (wanted >= 0 && wanted < scene.frames) return wanted;
    std::ostringstream sentence;
    sentence << "--frame " << wanted << ": the scene '" << scene.name << "' has the frames 0 to "
             << scene.frames - 1 << "; give one of these.";
    throw InputError(sentence.str());
}

std::vector<std::string> utf8_names(const std::vector<std::string>& names) {
    std::vector<std::string> result;
    for (const std::string& name : names) result.push_back(as_utf8(name));
    return result;
}

void refuse_overwriting(const std::string& path, const std::string& option,
                        const SceneOptions& scene) {
    for (const std::string& name : scene.names)
        for (const std::filesystem::path& folder :
             {std::filesystem::path(), std::filesystem::path(scene.models_dir)})
            refuse_same_file(path, option, folder / name);
}

void check_output(const std::string& path, const std::string& option, const Scene& scene) {
    for (const NamedMesh& mesh : scene.meshes) refuse_same_file(path, option, mesh.file);
}

void refuse_inputs(const std::string& path, const std::string& option, const SceneOptions& options,
                   const Scene& scene) {
    refuse_overwriting(path, option, options);
    check_output(path, option, scene);
}

void check_output(const std::string& path, const std::string& option, const SceneOptions& scene,
                  const std::string& folder_to_make) {
    if (path == "-") throw InputError(option + " -: standard output is taken; name a file.");
    std::error_code ignored;
    refuse_overwriting(path, option, scene);
    // Before the work, not after it.
    std::filesystem::path parent = std::filesystem::path(path).parent_path();
    if (parent.empty()) parent = ".";
    const auto folder_of = [](const std::filesystem::path& file) {
        std::error_code none;
        return std::filesystem::weakly_canonical(file, none).parent_path();
    };
    const bool will_be_made =
        !folder_to_make.empty() &&
        folder_of(std::filesystem::path(folder_to_make) / "file") == folder_of(parent / "file");
    if (!will_be_made && !std::filesystem::is_directory(parent, ignored))
        throw OutputError(option + " " + path + ": there is no folder " + parent.string() +
                          "; create it first.");
    if (std::filesystem::is_directory(path, ignored) || path.back() == '/')
        throw OutputError(option + " " + path + ": a folder has that name; name a file.");
}

void add_scene_options(CLI::App& command, SceneOptions& options, bool with_frame) {
    command
        .add_option(
            "SCENE", options.names,
            "A built-in scene (see `scb scenes`), a scene file, a mesh file, or two mesh files")
        ->required()
        ->expected(1, 2)
        ->type_name("[SCENE]");
    command
        .add_option("--pose", options.pose,
                    "Pose of the second of two meshes: 12 numbers, [R|t] row by row, with commas")
        ->delimiter(',')
        ->expected(12)
        ->type_name("R00,R01,R02,T0,...");
    command
        .add_option("--models", options.models_dir,
                    "Where meshes are looked for that are not where they are named")
        ->envname("SCB_MODELS")
        ->type_name("DIR");
    if (with_frame)
        command.add_option("--frame", options.frame, "Frame of the scene")
            ->check(decimal_number())
            ->type_name("N");
}

BuildOptions HierarchyOptions::build() const {
    BuildOptions options;
    if (growth == "radius")
        options.fit.growth = BallGrowth::radius;
    else if (growth != "ritter")
        throw InputError("--growth " + growth + ": unknown rule; give 'ritter' or 'radius'.");
    if (!(margin >= 0 && margin <= 1))
        throw InputError(format("--margin %g: give a share of the radius from 0 to 1.", margin));
    options.fit.margin = margin + 0.0;  // -0 is 0
    const std::optional<SplitMethod> method = split_method_of(split);
    if (!method) throw InputError("--split " + split + ": unknown method; give 'paper' or 'cost'.");
    options.split = *method;
    return options;
}

std::vector<VolumeKind> HierarchyOptions::kinds() const {
    std::vector<VolumeKind> kinds;
    for (const std::string& name : split_list(volumes)) {
        const std::optional<VolumeKind> kind = volume_kind_of(name);
        if (!kind)
            throw InputError("--volume " + volumes + ": '" + name +
                             "' is no volume; give some of scb,ball,ritter,obb.");
        if (std::find(kinds.begin(), kinds.end(), *kind) == kinds.end()) kinds.push_back(*kind);
    }
    return kinds;
}

VolumeKind HierarchyOptions::kind() const {
    const std::vector<VolumeKind> all = kinds();
    if (all.size() != 1)
        throw InputError("--volume " + volumes +
                         ": this command takes one of scb,ball,ritter,obb at a time.");
    return all[0];
}

void add_hierarchy_options(CLI::App& command, HierarchyOptions& options, bool several) {
    command
        .add_option("--volume", options.volumes,
                    several ? "Bounding volumes: some of scb,ball,ritter,obb"
                            : "Bounding volume: one of scb, ball, ritter, obb")
        ->check(has_name())
        ->type_name(several ? "LIST" : "VOLUME")
        ->capture_default_str();
    command.add_option("--growth", options.growth, "How minimum balls are grown: ritter or radius")
        ->check(has_name())
        ->type_name("RULE")
        ->capture_default_str();
    command
        .add_option(
            "--split", options.split,
            "How nodes are divided: paper (Section 3), or cost, which takes longer to build "
            "and less to query")
        ->check(has_name())
        ->type_name("METHOD")
        ->capture_default_str();
    command.add_option("--margin", options.margin, "Widen slabs by this share of the radius")
        ->check(real_number())
        ->capture_default_str();
}

CLI::Validator has_name() {
    return CLI::Validator(
        [](std::string& text) -> std::string {
            return text.empty() ? "the name is empty; give one" : "";
        },
        "");
}

CLI::Validator decimal_number() {
    return CLI::Validator(
        [](std::string& text) -> std::string {
            const std::size_t sign = text.starts_with('-') ? 1 : 0;
            const bool padded = text.size() > sign + 1 && text[sign] == '0';
            if (parses_as<std::int64_t>(text) && !padded) return {};
            return "'" + text + "' is no whole number";
        },
        "");
}

CLI::Validator real_number() {
    return CLI::Validator(
        [](std::string& text) -> std::string {
            return parses_as<double>(text) ? "" : "'" + text + "' is no number";
        },
        "");
}

std::vector<std::string> split_list(const std::string& text, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

int whole_number(const std::string& text, const std::string& what, const std::string& hint) {
    int value = 0;
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, value);
    if (text.empty() || parsed.ec != std::errc() || parsed.ptr != end)
        throw InputError(what + ": '" + text + "' is no whole number" + hint);
    return value;
}

}  // namespace scb
