#include <algorithm>
#include <exception>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/build_text.h"
#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/open_file.h"
#include "app/cli/progress.h"
#include "app/cli/validators.h"
#include "app/cli/version.h"
#include "app/pictures/picture_options.h"
#include "app/pictures/picture_texts.h"
#include "app/query/layout_options.h"
#include "app/timing/bench_report.h"
#include "core/base/exit_status.h"
#include "core/base/text_format.h"
#include "render/draw/renderer.h"
#include "render/files/image_file.h"
#include "render/files/output_file.h"
#include "scb/error.h"
#include "scenes/scene/builtin.h"
#include "scenes/scene/scene_group.h"
#include "scenes/text/input_files.h"
#include "scenes/text/number_list.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

struct BenchCommandOptions {
    SceneOptions scene;
    HierarchyOptions hierarchy{.volumes = "scb,ball,ritter,obb"};
    QueryOptions query;
    PictureOptions picture{.output = ""};
    std::string layouts = "reference", simd = "best";
    int leaf_triangles = most_leaf_triangles, threads = 1;
    int repeats = 3;
    bool warm = false, coherent = false, json = false;
};

/// A scene that is to be measured.
struct Entry {
    scenes::Scene scene;
    std::size_t a = 0, b = 0;
    std::vector<int> frames;
    bool builtin = false;
};

Entry entry_of(const SceneOptions& scene, const QueryOptions& query) {
    Entry entry;
    entry.scene = scene.load();
    std::tie(entry.a, entry.b) = two_bodies(entry.scene, query.bodies);
    entry.frames = scenes::parse_frames(query.frames, entry.scene.frames, entry.scene.name);
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

SimdLevel simd_level(const BenchCommandOptions& options) {
    for (const SimdLevel level : available_simd_levels())
        if (simd_level_name(level) == options.simd) return level;
    throw InputError("--simd " + options.simd + ": give one that this machine has, " +
                     name_list(available_simd_levels(), simd_level_name) + ".");
}

std::vector<BenchSubject> subjects(const BenchCommandOptions& options) {
    std::vector<BenchSubject> result;
    for (const VolumeKind kind : options.hierarchy.kinds()) {
        if (!can_pack(kind)) {
            result.push_back({kind, OverlapTest::corrected});
            continue;
        }
        for (const std::optional<PackedLayout>& layout :
             layouts_of(options.layouts, options.leaf_triangles)) {
            if (layout) result.push_back({kind, OverlapTest::symmetric, layout});
            if (layout && options.coherent)
                result.push_back({kind, OverlapTest::symmetric, layout, true});
            if (layout) continue;
            if (kind != VolumeKind::scb)
                result.push_back({kind, OverlapTest::corrected});
            else
                for (const OverlapTest test : options.query.tests()) result.push_back({kind, test});
        }
    }
    if (options.coherent && std::none_of(result.begin(), result.end(),
                                         [](const BenchSubject& s) { return s.coherent; }))
        throw InputError(
            "--coherent: only packed layouts of slab cut balls keep a front; name one with "
            "--layout, such as float8.");
    return result;
}

bool any_packed(const std::vector<BenchSubject>& subjects) {
    return std::any_of(subjects.begin(), subjects.end(),
                       [](const BenchSubject& s) { return s.layout.has_value(); });
}

/// Notes which options have no effect on what is measured, and what else may surprise.
void note_surprises(const BenchCommandOptions& options, const std::vector<BenchSubject>& subjects,
                    const Console& console) {
    note_doubts(options.hierarchy, options.hierarchy.kinds(), console);
    const BenchCommandOptions defaults;
    const auto note = [&console](const char* option, const char* why) {
        console.note("scb: " + std::string(option) + " has no effect: " + why);
    };
    std::vector<VolumeKind> reference;
    bool has_packable = false;
    for (const BenchSubject& s : subjects) {
        if (!s.layout) reference.push_back(s.kind);
        has_packable |= can_pack(s.kind);
    }
    const bool packed = any_packed(subjects);
    const bool reference_scb =
        std::find(reference.begin(), reference.end(), VolumeKind::scb) != reference.end();
    constexpr const char* own = "packed layouts have a test and a descent of their own.";
    if (packed && !reference_scb) {
        if (options.query.test != defaults.query.test) note("--test", own);
        if (options.query.threshold != defaults.query.threshold) note("--threshold", own);
    } else {
        note_doubts(options.query, reference, console);
    }
    if (reference.empty() && options.query.descent != defaults.query.descent)
        note("--descent", own);
    if (packed) return;
    const char* why = has_packable ? "it is of packed layouts; name one with --layout."
                                   : "only slab cut balls have packed layouts.";
    if (options.layouts != defaults.layouts) note("--layout", why);
    if (options.leaf_triangles != defaults.leaf_triangles) note("--leaf", why);
    if (options.simd != defaults.simd) note("--simd", why);
}

/// The vector instructions of packed layouts.
std::string simd_text(SimdLevel level) {
    // The last one is the best.
    if (level == SimdLevel::best) level = available_simd_levels().back();
    return std::string(simd_level_name(level));
}

std::string conditions(const BenchCommandOptions& options, const BenchOptions& bench) {
    const bool shared = bench.packed.threads > 1;
    const std::string built = build_sentence(options.hierarchy.build());
    return (built.empty() ? "" : built + " ") +
           std::string(options.warm ? "Warm: each hierarchy runs through all frames."
                                    : "Cold: at each frame the hierarchies take turns.") +
           (!shared ? std::string(" One thread, processor time; ")
                    : " " + std::to_string(options.threads) +
                          " threads share a query of packed layouts; time that passes; ") +
           (options.repeats == 1 ? std::string("one run")
                                 : "median of " + std::to_string(options.repeats) + " runs") +
           " per frame, sorting the pairs included. " +
           (any_packed(bench.subjects)
                ? "Packed layouts by the instructions '" + simd_text(bench.packed.level) + "'. "
                : "") +
           "Compiled by " + compiler_text() +
           ". Times differ from machine to machine and from run to run; counts do not.";
}

/// What the run has written and will print.
struct Report {
    std::string table, csv = bench_csv_header;
    Json scenes = Json::array();
    BenchCosts costs;

    std::string json(const BenchCommandOptions& options, const std::string& simd,
                     bool complete) const {
        const Json document = {{"scenes", scenes},
                               {"complete", complete},
                               {"equation_1", costs.json()},
                               {"options",
                                {{"threshold", options.query.threshold},
                                 {"descent", descent_rule_name(options.query.descent)},
                                 {"growth", ball_growth_name(options.hierarchy.growth)},
                                 {"margin", options.hierarchy.margin},
                                 {"split", split_method_name(options.hierarchy.split)},
                                 {"leaf", options.leaf_triangles},
                                 {"simd", simd},
                                 {"threads", options.threads},
                                 {"coherent", options.coherent},
                                 {"repeats", options.repeats},
                                 {"order", options.warm ? "warm" : "cold"}}},
                               {"compiler", compiler_text()},
                               {"version", SCB_VERSION}};
        return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    }
};

std::string bench_picture_name(const scenes::Scene& scene) { return scene.name + "_bench.png"; }

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

    const bool writes = !options.picture.output.empty();
    if (writes) {
        std::vector<std::string> files = {"bench.csv", "bench.json"};
        for (const Entry& entry : all) files.push_back(bench_picture_name(entry.scene));
        for (const std::string& file : files)
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
    const auto json = [&] {
        return report.json(options, simd_text(bench_options.packed.level),
                           report.scenes.size() == all.size());
    };
    // Whether it was finished.
    const auto measure = [&](std::size_t e) {
        const Entry& entry = all[e];
        Progress progress(console, entry.frames.size() * bench_options.subjects.size() *
                                       static_cast<std::size_t>(options.repeats));
        const std::string what = entry.scene.name + " (scene " + std::to_string(e + 1) + " of " +
                                 std::to_string(all.size()) + ")";
        const auto step = [&] {
            progress.step(what);
            return watch.signal() == 0;
        };
        std::optional<SceneBench> bench =
            bench_scene(entry.scene, entry.a, entry.b, entry.frames, bench_options, step);
        if (!bench) return false;
        bench->builtin = entry.builtin;
        report.table += (report.table.empty() ? "" : "\n") + bench_table(*bench);
        report.costs.add(*bench);
        report.csv += bench_csv(*bench);
        report.scenes.push_back(bench_json(*bench));
        if (!writes) return true;
        render::BenchFigure figure = bench_figure(*bench);
        figure.footnote = conditions(options, bench_options);
        figure.theme = options.picture.theme();
        render::Overlay overlay;
        const render::Picture picture =
            render::compose(figure, options.picture.width(), options.picture.height(), overlay);
        const std::vector<std::uint8_t> png =
            render::encode_png(renderer->draw(picture, &overlay).image,
                               picture_texts(options.picture, entry.scene.name));
        render::write_file_whole(folder / bench_picture_name(entry.scene), png);
        render::write_file_whole(folder / "bench.csv", report.csv);
        render::write_file_whole(folder / "bench.json", json());
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
    if (options.json)
        print_result(json());
    else if (!report.table.empty())
        print_result(report.table + "\n" + report.costs.table() + "\n" +
                     conditions(options, bench_options) + "\n");
    if (failure) std::rethrow_exception(failure);
    if (options.picture.open && !report.scenes.empty())
        open_file(all.size() == 1 ? folder / bench_picture_name(all[0].scene) : folder, console);
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
    add_scene_options(command, options->scene, false);
    command.get_option("SCENE")
        .required(false)
        .expected(0, 1000)
        .type_name("[SCENE...]")
        .description(
            "Built-in scenes or scene files, or two mesh files; `cad`: the eight scenes of CAD "
            "models; `table-3`, and by default: the seven scenes of Table 3");
    add_hierarchy_options(command, options->hierarchy);
    add_query_options(command, options->query, true);
    command
        .add_option("--layout", options->layouts,
                    "Layouts of slab cut balls: some of reference, " + layout_names() +
                        "; packed ones have the test 'symmetric'")
        .type_name("LIST")
        .show_default();
    add_leaf_option(command, options->leaf_triangles);
    command
        .add_option(
            "--simd", options->simd,
            "Vector instructions of packed layouts: best, base (none on x86-64: slow), sse4, "
            "avx2 or avx512; answers are the same")
        .type_name("LEVEL")
        .show_default();
    add_threads_option(command, options->threads,
                       "Threads that share a query of packed layouts, and each build");
    command.add_option("--repeat", options->repeats, "Time each query N times and take the median")
        .check(decimal_number)
        .type_name("N")
        .show_default();
    command.add_flag("--warm", options->warm,
                     "Run one hierarchy through all frames, then the next. Default: they take "
                     "turns at each frame");
    add_figure_options(command, options->picture,
                       "Folder for bench.csv, bench.json and a picture per scene");
    command.add_flag("--coherent", options->coherent,
                     "Also time each packed layout with a front: if bodies move slowly, a query "
                     "begins where an earlier one ended. Add --warm for a fair comparison");
    command.add_flag("--json", options->json, "Print JSON instead of a table");
    command.footer(
        "ms: mean processor time of a query (with --threads above 1: the time that passes); / SCB: "
        "time over that of the first\n"
        "hierarchy of slab cut balls; ns/N_v: time per volume test, triangle tests included; "
        "bytes: of the hierarchies, per\n"
        "triangle; front: with --coherent, the share of queries that began where an earlier one "
        "ended. To compare times\n"
        "with and without a front add --warm: else the same query has just been made without one, "
        "and its data is in the\n"
        "caches.\n"
        "Ctrl-C keeps what was finished and exits with 130.\n\n"
        "Examples:\n  scb bench spheres-l1 knots-l1 -o out/\n"
        "  scb bench cad --volume scb,scb2,obb --frames 0:499:10");
    command.callback([&action, &console, options] {
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
