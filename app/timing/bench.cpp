#include <algorithm>
#include <exception>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/open_file.h"
#include "app/cli/progress.h"
#include "app/cli/version.h"
#include "app/pictures/picture_name.h"
#include "app/pictures/plot_file.h"
#include "app/query/layout_options.h"
#include "app/report/scene_report.h"
#include "app/shards/parts.h"
#include "app/timing/bench_options.h"
#include "app/timing/bench_report.h"
#include "app/timing/correlation_report.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "core/platform/input_files.h"
#include "core/platform/number_list.h"
#include "core/platform/output_file.h"
#include "render/draw/renderer.h"
#include "scb/error.h"
#include "scenes/scene/builtin.h"
#include "scenes/scene/scene_group.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

/// A scene to measure.
struct Entry {
    scenes::Scene scene;
    std::string stem;  ///< the beginning of its picture's name
    std::size_t a = 0, b = 0;
    std::vector<int> frames;
    bool builtin = false;

    const scenes::NamedMesh& mesh(std::size_t body) const {
        return scene.meshes[scene.bodies[body].mesh];
    }
};

Entry entry_of(const SceneOptions& scene, const QueryOptions& query) {
    Entry entry;
    entry.scene = scene.load(query.frames);
    entry.stem = scene.file_stem(entry.scene.name);
    const BodyPair bodies = body_pairs(entry.scene, query.bodies).front();
    entry.a = bodies[0];
    entry.b = bodies[1];
    if (entry.a == entry.b)
        throw InputError("--bodies " + query.bodies +
                         ": `scb bench` times queries of two bodies; give two.");
    entry.frames = frames_of(entry.scene, query.frames);
    return entry;
}

bool is_mesh_file(const std::string& name) {
    return scenes::find_builtin(name) == nullptr && scenes::find_scene_group(name) == nullptr &&
           !name.ends_with(".json");
}

// The named scenes, or two meshes as one scene; by default Table 3's.
std::vector<Entry> entries(const BenchCommandOptions& options, const Console& console) {
    SceneOptions one = options.scene;
    if (one.names.size() == 2 && is_mesh_file(one.names[0]) && is_mesh_file(one.names[1]))
        return {entry_of(one, options.query)};
    const scenes::MeasuredScenes measured =
        scenes::measured_scenes(one.names, {"table-3"}, one.models_dir);
    for (const std::string& sentence : measured.left_out) console.note("scb: " + sentence);
    std::vector<Entry> result;
    for (const std::string& name : measured.names) {
        one.names = {name};
        Entry entry = entry_of(one, options.query);
        entry.builtin = scenes::find_builtin(name) != nullptr;
        for (const Entry& other : result)
            if (other.scene.name == entry.scene.name)
                throw InputError("two scenes have the name '" + entry.scene.name +
                                 "'; give each once, or rename one.");
        result.push_back(std::move(entry));
    }
    return result;
}

/// Results of the scenes that were measured.
struct Report {
    const BenchCommandOptions& options;
    const BenchOptions& bench;
    std::size_t wanted;  ///< number of scenes to measure
    std::string table{}, csv = bench_csv_header(bench.distance);
    Json scenes = Json::array();
    BenchCosts costs{};
    std::optional<BenchCorrelation> correlation{};  ///< with --measures

    void add(const SceneBench& scene) {
        table += (table.empty() ? "" : "\n") + bench_table(scene);
        costs.add(scene);
        if (correlation) correlation->add(scene);
        csv += bench_csv(scene);
        scenes.push_back(bench_json(scene));
    }

    std::string text() const {
        return table + "\n" + costs.table() + (correlation ? "\n" + correlation->table() : "") +
               "\n" + conditions(options, bench) + "\n";
    }

    std::string json() const {
        Json document = {{"scenes", scenes},
                         {"complete", scenes.size() == wanted},
                         {"equation_1", costs.json()},
                         {"options",
                          {{"query", query_kind_name(options.query.kind())},
                           {"threshold", options.query.threshold},
                           {"descent", descent_rule_name(options.query.descent)},
                           {"growth", ball_growth_name(options.hierarchy.growth)},
                           {"margin", options.hierarchy.margin},
                           {"split", options.splits},
                           {"leaf", options.leaf_triangles},
                           {"simd", simd_text(bench.packed.level)},
                           {"threads", options.threads},
                           {"coherent", options.coherent},
                           {"first", options.first},
                           {"repeats", options.repeats},
                           {"order", options.warm ? "warm" : "cold"}}},
                         {"compiler", compiler_text()},
                         {"version", SCB_VERSION}};
        if (options.query.distance) document["options"].update(asked_json(*options.query.distance));
        if (correlation) document["correlation"] = correlation->json();
        return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    }
};

/// For titles, after the scene's name: the position of B, which distinguishes poses with the same
/// rotation.
std::string place_words(const std::vector<double>& pose) {
    if (pose.empty()) return "";
    return format(" · B at %.4g, %.4g, %.4g", pose[3], pose[7], pose[11]);
}

/// Files of a run. Their names have the pose and the bodies, if given.
struct BenchFiles {
    std::filesystem::path folder;
    NamedOptions named;

    explicit BenchFiles(const BenchCommandOptions& options) : folder(options.picture.output) {
        named.add_if(!options.query.bodies.empty(), "bodies", options.query.bodies);
        name_pose(named, options.scene.pose);
    }
    std::filesystem::path picture(const Entry& entry) const {
        return folder / (picture_name(entry.stem, "bench", named, "") + ".png");
    }
    std::filesystem::path of_all(const char* name, const char* ending) const {
        return folder / (name + named.text() + ending);
    }

    /// Throws InputError if the run has read one of the files that it will write.
    void refuse_inputs(const std::vector<Entry>& all, bool measures) const {
        std::vector<std::filesystem::path> written = {of_all("bench", ".csv"),
                                                      of_all("bench", ".json")};
        if (measures)
            for (const char* ending : {".csv", ".png"})
                written.push_back(of_all("measures", ending));
        for (const Entry& entry : all) written.push_back(picture(entry));
        for (const std::filesystem::path& file : written) refuse_input(file, "-o");
    }
};

/// Draws a scene of the report, and writes the tables of all scenes.
void write_files(const Report& report, const Entry& entry, const SceneBench& bench,
                 const BenchFiles& files, render::Renderer& renderer) {
    const auto draw = [&](auto figure, const std::filesystem::path& file,
                          const std::string& scene) {
        figure.footnote = conditions(report.options, report.bench);
        write_plot(std::move(figure), report.options.picture, renderer, file, scene);
    };
    render::BenchFigure figure = bench_figure(bench);
    figure.scene += place_words(report.options.scene.pose);
    draw(std::move(figure), files.picture(entry), entry.scene.name);
    if (report.correlation) {
        std::string names;
        for (const std::string& name : report.correlation->names)
            names += (names.empty() ? "" : ", ") + name;
        draw(report.correlation->figure(), files.of_all("measures", ".png"), names);
        write_file_whole(files.of_all("measures", ".csv"),
                         correlation_csv_header() + report.correlation->csv);
    }
    write_file_whole(files.of_all("bench", ".csv"), report.csv);
    write_file_whole(files.of_all("bench", ".json"), report.json());
}

/// A run's parts are the frames of its scenes, in order. Returns the number of the scene's first
/// part.
std::size_t first_part(const std::vector<Entry>& all, std::size_t scene) {
    std::size_t first = 0;
    for (std::size_t e = 0; e < scene; ++e) first += all[e].frames.size();
    return first;
}

/// Identifies the scenes with their poses.
Json subject_of(const std::vector<Entry>& all) {
    Json subject;
    for (const Entry& entry : all) {
        for (const std::size_t body : {entry.a, entry.b})
            subject.push_back(hash_text(fingerprint(entry.mesh(body).mesh).hash));
        subject.push_back(all_poses_json(entry.scene, entry.frames));
    }
    return subject;
}

/// The measurement that the options describe. Throws InputError.
BenchOptions measurement(const BenchCommandOptions& options) {
    BenchOptions result;
    result.subjects = subjects(options);
    QueryOptions one_test = options.query;
    one_test.test = split_list(options.query.test)[0];
    result.collide = one_test.collide();
    result.build = options.hierarchy.build();
    result.packed.level = simd_level(options);
    check_threads(options.threads);
    result.build.threads = options.threads;
    result.measures = options.measures;
    result.first = options.first;
    result.distance = options.query.distance;
    if (result.distance) result.distance->limits.descent = options.query.descent;
    // Only packed queries for all pairs can share threads.
    if (any_packed(result.subjects) && !options.first && !result.distance)
        result.packed.threads = options.threads;
    result.order = options.warm ? BenchOrder::warm : BenchOrder::cold;
    if (options.repeats < 1 || options.repeats > 1000)
        throw InputError("--repeat " + std::to_string(options.repeats) + ": give 1 to 1000.");
    result.repeats = options.repeats;
    return result;
}

/// Throws InputError if packed layouts cannot hold a mesh.
void check_meshes(const std::vector<Entry>& all) {
    for (const Entry& entry : all)
        for (const std::size_t body : {entry.a, entry.b}) {
            const scenes::NamedMesh& mesh = entry.mesh(body);
            check_packable(mesh.mesh, entry.scene.name + ", " + mesh.name);
        }
}

/// Times the frames of the scene that are parts of this run, or reads all of them from shards. A
/// shard keeps its parts. `first`: number of the scene's first part. Returns nothing if `step`
/// ended the measurement.
std::optional<SceneBench> measured(const Entry& entry, std::size_t first, Parts& parts,
                                   const BenchOptions& options, const std::function<bool()>& step) {
    std::optional<SceneBench> bench = empty_bench(entry.scene, entry.a, entry.b, options);
    std::vector<int> frames;
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < entry.frames.size(); ++i) {
        if (parts.are_merged())
            parts.read(first + i,
                       [&](const Json& made, const auto&) { add_bench_frame(*bench, made); });
        if (!parts.is_made_here(first + i)) continue;
        frames.push_back(entry.frames[i]);
        numbers.push_back(first + i);
    }
    if (!frames.empty()) bench = bench_scene(entry.scene, entry.a, entry.b, frames, options, step);
    if (!bench) return std::nullopt;
    if (parts.are_of_shard())
        for (std::size_t i = 0; i < frames.size(); ++i)
            parts.keep(numbers[i], bench_frame_json(*bench, i));
    bench->builtin = entry.builtin;
    bench->all_frames = entry.frames.size() == static_cast<std::size_t>(entry.scene.frames);
    return bench;
}

/// Shows and opens the pictures of the first scenes, if the options say so.
void present(const BenchCommandOptions& options, const BenchFiles& files,
             const std::vector<Entry>& all, std::size_t drawn, const Console& console) {
    if (options.picture.show) {
        std::vector<std::filesystem::path> pictures;
        for (std::size_t e = 0; e < drawn; ++e) pictures.push_back(files.picture(all[e]));
        show_pictures(pictures, console);
    }
    if (options.picture.open && drawn > 0)
        open_file(all.size() == 1 ? files.picture(all[0]) : files.folder, console);
}

int run(BenchCommandOptions& options, const Console& console) {
    options.kind.apply(options.query);
    const BenchOptions bench_options = measurement(options);
    options.picture.check();
    // If a scene is refused, nothing is measured.
    const std::vector<Entry> all = entries(options, console);
    // Two names can be two scenes; if they are meshes, they are the bodies of one scene.
    for (const Entry& entry : all)
        note_poses(all.size() == 1 ? options.scene : SceneOptions{}, entry.scene, console.notes());
    note_surprises(options, bench_options.subjects, console);
    if (any_packed(bench_options.subjects)) check_meshes(all);

    const ShardOptions& shards = options.picture.shards;
    shards.check_folder(options.picture.output);
    Parts parts(
        shards, first_part(all, all.size()), versions_json(nullptr),
        [&] { return subject_of(all); }, options.picture.output);
    const BenchFiles files(options);
    std::optional<render::Context> context;
    std::optional<render::Renderer> renderer;  // if files are written
    if (!options.picture.output.empty() && !parts.are_of_shard()) {
        files.refuse_inputs(all, options.measures);
        options.picture.output_folder();
        context.emplace(options.picture.backend());
        renderer.emplace(*context);
    }

    const InterruptWatch watch;
    Report report{options, bench_options, all.size()};
    if (options.measures) report.correlation.emplace();
    // Returns false if the run is interrupted.
    const auto measure = [&](std::size_t e) {
        const Entry& entry = all[e];
        const std::size_t first = first_part(all, e);
        const std::size_t queries =
            bench_options.subjects.size() * static_cast<std::size_t>(options.repeats);
        Progress progress(console, parts.count(first, first + entry.frames.size()) * queries);
        const std::string title = entry.scene.name + " (scene " + std::to_string(e + 1) + " of " +
                                  std::to_string(all.size()) + ")";
        const auto bench = measured(entry, first, parts, bench_options, [&] {
            progress.step(title);
            return watch.signal() == 0;
        });
        if (!bench) return false;
        if (parts.are_of_shard()) return true;
        report.add(*bench);
        if (renderer) write_files(report, entry, *bench, files, *renderer);
        return true;
    };
    // Print the finished measurements even if the others fail.
    std::exception_ptr failure;
    try {
        for (std::size_t e = 0; e < all.size() && measure(e); ++e) {
        }
    } catch (const std::exception&) {
        failure = std::current_exception();
    }
    if (failure && report.scenes.empty()) std::rethrow_exception(failure);
    if (parts.are_of_shard()) return finish_shard(parts, watch, console);
    if (options.json)
        print_result(report.json());
    else if (!report.table.empty())
        print_result(report.text());
    if (failure) std::rethrow_exception(failure);
    if (renderer) present(options, files, all, report.scenes.size(), console);
    if (watch.signal() == 0) return exit_done;
    console.note("scb: interrupted; " + std::to_string(report.scenes.size()) + " of " +
                 std::to_string(all.size()) + " scenes are finished.");
    return exit_interrupted(watch.signal());
}

}  // namespace

void add_bench(const Command& program, const Console& console, Action& action) {
    const Command command =
        program.add_subcommand("bench", "Time queries: Table 3 and Figure 11 of the paper");
    const auto options = std::make_shared<BenchCommandOptions>();
    add_bench_options(command, *options);
    command.callback([&action, &console, options] {
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
