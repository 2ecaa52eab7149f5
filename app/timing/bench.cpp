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
#include "app/pictures/show_pictures.h"
#include "app/query/layout_options.h"
#include "app/query/poses_json.h"
#include "app/shards/parts.h"
#include "app/timing/bench_options.h"
#include "app/timing/bench_report.h"
#include "app/timing/correlation_report.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "render/draw/renderer.h"
#include "render/files/output_file.h"
#include "scb/error.h"
#include "scenes/scene/builtin.h"
#include "scenes/scene/scene_group.h"
#include "scenes/text/input_files.h"
#include "scenes/text/number_list.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

/// A scene that is to be measured.
struct Entry {
    scenes::Scene scene;
    std::string stem;  ///< that its picture's name begins with
    std::size_t a = 0, b = 0;
    std::vector<int> frames;
    bool builtin = false;
};

Entry entry_of(const SceneOptions& scene, const QueryOptions& query) {
    Entry entry;
    entry.scene = scene.load(query.frames);
    entry.stem = scene.file_stem(entry.scene.name);
    std::tie(entry.a, entry.b) = two_bodies(entry.scene, query.bodies);
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

// Those named, two meshes as one; or Table 3's.
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

/// What the run has written and will print.
struct Report {
    std::string table, csv = bench_csv_header;
    Json scenes = Json::array();
    BenchCosts costs;
    std::optional<BenchCorrelation> correlation;  ///< where hierarchies are measured

    std::string text() const {
        return table + "\n" + costs.table() + (correlation ? "\n" + correlation->table() : "");
    }

    std::string json(const BenchCommandOptions& options, const std::string& simd,
                     bool complete) const {
        Json document = {{"scenes", scenes},
                         {"complete", complete},
                         {"equation_1", costs.json()},
                         {"options",
                          {{"threshold", options.query.threshold},
                           {"descent", descent_rule_name(options.query.descent)},
                           {"growth", ball_growth_name(options.hierarchy.growth)},
                           {"margin", options.hierarchy.margin},
                           {"split", options.splits},
                           {"leaf", options.leaf_triangles},
                           {"simd", simd},
                           {"threads", options.threads},
                           {"coherent", options.coherent},
                           {"repeats", options.repeats},
                           {"order", options.warm ? "warm" : "cold"}}},
                         {"compiler", compiler_text()},
                         {"version", SCB_VERSION}};
        if (correlation) document["correlation"] = correlation->json();
        return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    }
};

/// Where the files of a run are: those of another pose, and of other bodies, are others.
struct BenchFiles {
    NamedOptions named;

    explicit BenchFiles(const BenchCommandOptions& options) {
        named.add_if(!options.query.bodies.empty(), "bodies", options.query.bodies);
        name_pose(named, options.scene.pose);
    }
    std::string picture(const Entry& entry) const {
        return picture_name(entry.stem, "bench", named, "") + ".png";
    }
    std::string of_all(const char* name, const char* ending) const {
        return name + named.text() + ending;
    }
};

/// Behind the name of the scene in a title: where B is, which tells poses of one rotation apart.
std::string place_words(const std::vector<double>& pose) {
    if (pose.empty()) return "";
    return format(" · B at %.4g, %.4g, %.4g", pose[3], pose[7], pose[11]);
}

/// The parts of a run are frames of scenes: the number of the scene's first one.
std::size_t first_part(const std::vector<Entry>& all, std::size_t scene) {
    std::size_t first = 0;
    for (std::size_t e = 0; e < scene; ++e) first += all[e].frames.size();
    return first;
}

/// What tells the scenes, with their poses, from others.
Json subject_of(const std::vector<Entry>& all) {
    Json subject;
    for (const Entry& entry : all) {
        for (const std::size_t body : {entry.a, entry.b})
            subject.push_back(hash_text(
                fingerprint(entry.scene.meshes[entry.scene.bodies[body].mesh].mesh).hash));
        subject.push_back(all_poses_json(entry.scene, entry.frames));
    }
    return subject;
}

int run(const BenchCommandOptions& options, const Console& console) {
    BenchOptions bench_options;
    bench_options.subjects = subjects(options);
    QueryOptions one_test = options.query;
    one_test.test = scenes::split_list(options.query.test)[0];
    bench_options.collide = one_test.collide();
    bench_options.build = options.hierarchy.build();
    bench_options.packed.level = simd_level(options);
    check_threads(options.threads);
    bench_options.build.threads = options.threads;
    bench_options.measures = options.measures;
    // Other queries have one thread each.
    if (any_packed(bench_options.subjects)) bench_options.packed.threads = options.threads;
    bench_options.order = options.warm ? BenchOrder::warm : BenchOrder::cold;
    if (options.repeats < 1 || options.repeats > 1000)
        throw InputError("--repeat " + std::to_string(options.repeats) + ": give 1 to 1000.");
    bench_options.repeats = options.repeats;
    options.picture.check();
    // Nothing is measured if one of them is refused.
    const std::vector<Entry> all = entries(options, console);
    // Two names are two bodies only where they are meshes.
    if (all.size() == 1) note_same_pose(options.scene, console);
    note_surprises(options, bench_options.subjects, console);

    if (any_packed(bench_options.subjects))
        for (const Entry& entry : all)
            for (const std::size_t body : {entry.a, entry.b}) {
                const scenes::NamedMesh& mesh = entry.scene.meshes[entry.scene.bodies[body].mesh];
                check_packable(mesh.mesh, entry.scene.name + ", " + mesh.name);
            }

    const ShardOptions& shards = options.picture.shards;
    shards.check_folder(options.picture.output);
    Parts parts(
        shards, first_part(all, all.size()), versions_json(nullptr),
        [&] { return subject_of(all); }, options.picture.output);
    const bool writes = !options.picture.output.empty() && !parts.are_of_shard();
    const BenchFiles files(options);
    const std::string csv_file = files.of_all("bench", ".csv"),
                      json_file = files.of_all("bench", ".json"),
                      measures_csv = files.of_all("measures", ".csv"),
                      measures_picture = files.of_all("measures", ".png");
    if (writes) {
        std::vector<std::string> written = {csv_file, json_file};
        if (options.measures)
            for (const std::string& file : {measures_csv, measures_picture})
                written.push_back(file);
        for (const Entry& entry : all) written.push_back(files.picture(entry));
        for (const std::string& file : written)
            scenes::refuse_input(std::filesystem::path(options.picture.output) / file, "-o");
    }
    std::filesystem::path folder;
    std::optional<render::Context> context;
    std::optional<render::Renderer> renderer;
    if (writes) {
        folder = options.picture.output_folder();
        context.emplace(options.picture.backend());
        renderer.emplace(*context);
    }

    const InterruptWatch watch;
    Report report;
    if (options.measures) report.correlation.emplace();
    const auto draw = [&](auto figure, const std::string& file, const std::string& scene) {
        figure.footnote = conditions(options, bench_options);
        write_plot(std::move(figure), options.picture, *renderer, folder / file, scene);
    };
    const auto json = [&] {
        return report.json(options, simd_text(bench_options.packed.level),
                           report.scenes.size() == all.size());
    };
    const auto scene_names = [&] {
        std::string names;
        for (const std::string& name : report.correlation->names)
            names += (names.empty() ? "" : ", ") + name;
        return names;
    };
    // Whether it was finished.
    const auto measure = [&](std::size_t e) {
        const Entry& entry = all[e];
        const std::size_t first = first_part(all, e);
        const std::size_t queries =
            bench_options.subjects.size() * static_cast<std::size_t>(options.repeats);
        Progress progress(console, parts.count(first, first + entry.frames.size()) * queries);
        const std::string what = entry.scene.name + " (scene " + std::to_string(e + 1) + " of " +
                                 std::to_string(all.size()) + ")";
        const auto step = [&] {
            progress.step(what);
            return watch.signal() == 0;
        };
        std::optional<SceneBench> bench;
        if (parts.are_merged()) {
            bench = empty_bench(entry.scene, entry.a, entry.b, bench_options.subjects);
            for (std::size_t i = 0; i < entry.frames.size(); ++i)
                parts.read(first + i,
                           [&](const Json& made, const auto&) { add_bench_frame(*bench, made); });
        } else {
            std::vector<int> frames;
            std::vector<std::size_t> numbers;
            for (std::size_t i = 0; i < entry.frames.size(); ++i) {
                if (!parts.is_made_here(first + i)) continue;
                frames.push_back(entry.frames[i]);
                numbers.push_back(first + i);
            }
            if (frames.empty()) return true;
            bench = bench_scene(entry.scene, entry.a, entry.b, frames, bench_options, step);
            if (!bench) return false;
            if (parts.are_of_shard()) {
                for (std::size_t i = 0; i < frames.size(); ++i)
                    parts.keep(numbers[i], bench_frame_json(*bench, i));
                return true;
            }
        }
        bench->builtin = entry.builtin;
        bench->all_frames = entry.frames.size() == static_cast<std::size_t>(entry.scene.frames);
        report.table += (report.table.empty() ? "" : "\n") + bench_table(*bench);
        report.costs.add(*bench);
        if (report.correlation) report.correlation->add(*bench);
        report.csv += bench_csv(*bench);
        report.scenes.push_back(bench_json(*bench));
        if (!writes) return true;
        render::BenchFigure figure = bench_figure(*bench);
        figure.scene += place_words(options.scene.pose);
        draw(std::move(figure), files.picture(entry), entry.scene.name);
        if (report.correlation) {
            draw(report.correlation->figure(), measures_picture, scene_names());
            render::write_file_whole(folder / measures_csv,
                                     correlation_csv_header() + report.correlation->csv);
        }
        render::write_file_whole(folder / csv_file, report.csv);
        render::write_file_whole(folder / json_file, json());
        return true;
    };
    // What was measured is printed also where the rest fails.
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
        print_result(json());
    else if (!report.table.empty())
        print_result(report.text() + "\n" + conditions(options, bench_options) + "\n");
    if (failure) std::rethrow_exception(failure);
    if (writes && options.picture.show) {
        std::vector<std::filesystem::path> drawn;
        for (std::size_t e = 0; e < report.scenes.size(); ++e)
            drawn.push_back(folder / files.picture(all[e]));
        show_pictures(drawn, console);
    }
    if (options.picture.open && !report.scenes.empty())
        open_file(all.size() == 1 ? folder / files.picture(all[0]) : folder, console);
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
