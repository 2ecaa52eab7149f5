#include "app/timing/bench_options.h"

#include <algorithm>

#include "app/cli/validators.h"
#include "app/cli/version.h"
#include "app/report/build_text.h"
#include "core/base/text_format.h"
#include "scb/error.h"

namespace scb::app {

SimdLevel simd_level(const BenchCommandOptions& options) {
    for (const SimdLevel level : available_simd_levels())
        if (simd_level_name(level) == options.simd) return level;
    throw InputError("--simd " + options.simd + ": give one that this machine has, " +
                     name_list(available_simd_levels(), simd_level_name) + ".");
}

namespace {

/// The subjects with one split.
std::vector<BenchSubject> subjects_of(const BenchCommandOptions& options) {
    std::vector<BenchSubject> result;
    for (const VolumeKind kind : options.hierarchy.kinds()) {
        if (!can_pack(kind)) {
            result.push_back({kind});
            continue;
        }
        for (const std::optional<PackedLayout>& layout :
             layouts_of(options.layouts, options.leaf_triangles)) {
            if (layout) result.push_back({kind, {}, layout});
            if (layout && options.coherent) result.push_back({kind, {}, layout, true});
            if (layout) continue;
            if (kind != VolumeKind::scb || options.query.distance)
                result.push_back({kind});
            else
                for (const OverlapTest test : options.query.tests()) result.push_back({kind, test});
        }
    }
    return result;
}

}  // namespace

std::vector<BenchSubject> subjects(const BenchCommandOptions& options) {
    const std::vector<SplitMethod> splits = splits_of(options.splits);
    std::vector<BenchSubject> result;
    for (const SplitMethod split : splits)
        for (BenchSubject subject : subjects_of(options)) {
            subject.split = split;
            subject.names_split = splits.size() > 1;
            result.push_back(subject);
        }
    for (const auto& [name, is_given] :
         {std::pair("--coherent", options.coherent), std::pair("--measures", options.measures),
          std::pair("--test", options.query.test != QueryOptions{}.test),
          std::pair("--threshold", options.query.threshold != QueryOptions{}.threshold)})
        if (is_given && options.query.distance)
            throw InputError(
                std::string(name) +
                " is of queries for triangles that intersect, and these queries are of "
                "distances; leave it out.");
    if (options.first && options.query.distance && !options.query.distance->within)
        throw InputError(
            "--first ends a query at its first pair, and a distance needs all; give --within T, or "
            "leave it out.");
    refuse_with_shard(options.picture.shards, options.coherent, "--coherent",
                      "a front is kept from each frame to the next");
    if (options.coherent && std::none_of(result.begin(), result.end(),
                                         [](const BenchSubject& s) { return s.coherent; }))
        throw InputError(
            "--coherent: only packed layouts of slab cut balls keep a front; name one with "
            "--layout, such as float8.");
    if (options.measures && std::all_of(result.begin(), result.end(),
                                        [](const BenchSubject& s) { return s.layout.has_value(); }))
        throw InputError(
            "--measures: only reference hierarchies are measured; add reference to --layout.");
    return result;
}

bool any_packed(const std::vector<BenchSubject>& subjects) {
    return std::any_of(subjects.begin(), subjects.end(),
                       [](const BenchSubject& s) { return s.layout.has_value(); });
}

void note_surprises(const BenchCommandOptions& options, const std::vector<BenchSubject>& subjects,
                    const Console& console) {
    note_doubts(options.hierarchy, options.hierarchy.kinds(), console.notes());
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
        note_doubts(options.query, reference, console.notes());
    }
    if (reference.empty() && options.query.descent != defaults.query.descent)
        note("--descent", own);
    if (packed && options.threads > 1 && (options.first || options.query.distance))
        note("--threads", options.first ? "a query up to the first pair runs in one thread."
                                        : "a query of distances runs in one thread.");
    if (packed) return;
    const char* why = has_packable ? "it is of packed layouts; name one with --layout."
                                   : "only slab cut balls have packed layouts.";
    if (options.layouts != defaults.layouts) note("--layout", why);
    if (options.leaf_triangles != defaults.leaf_triangles) note("--leaf", why);
    if (options.simd != defaults.simd) note("--simd", why);
}

std::string simd_text(SimdLevel level) {
    // The last level is the best.
    if (level == SimdLevel::best) level = available_simd_levels().back();
    return std::string(simd_level_name(level));
}

std::string conditions(const BenchCommandOptions& options, const BenchOptions& bench) {
    const bool shared = bench.packed.threads > 1;
    BuildOptions build = options.hierarchy.build();
    const std::vector<SplitMethod> splits = splits_of(options.splits);
    // With several splits, the subjects' names have the split.
    if (splits.size() == 1) build.split = splits[0];
    const std::string built = build_sentence(build);
    std::string pose;
    for (const double number : options.scene.pose)
        pose += (pose.empty() ? "" : ",") + exact_number(number);
    return (built.empty() ? "" : built + " ") + (pose.empty() ? "" : "Pose of B: " + pose + ". ") +
           std::string(options.warm ? "Warm: each hierarchy runs through all frames."
                                    : "Cold: at each frame the hierarchies take turns.") +
           (!shared ? std::string(" One thread, processor time; ")
                    : " " + std::to_string(options.threads) +
                          " threads share a query of packed layouts; time that passes; ") +
           (options.repeats == 1 ? std::string("one run")
                                 : "median of " + std::to_string(options.repeats) + " runs") +
           (bench.distance && !bench.distance->within ? " per frame. " : " per frame, ") +
           (bench.first                                 ? "up to the first pair. "
            : bench.distance && !bench.distance->within ? ""
                                                        : "sorting the pairs included. ") +
           (any_packed(bench.subjects)
                ? "Packed layouts by the instructions '" + simd_text(bench.packed.level) + "'. "
                : "") +
           "Compiled by " + compiler_text() +
           ". Times differ from machine to machine and from run to run; counts do not.";
}

void add_bench_options(const Command& command, BenchCommandOptions& options) {
    add_scene_options(command, options.scene, false);
    command.get_option("SCENE")
        .required(false)
        .expected(0, 1000)
        .type_name("[SCENE...]")
        .description(
            "Built-in scenes or scene files, or two mesh files; `cad`: the eight scenes of CAD "
            "models; `cad-aligned`: eleven of parts that lie on each other; `table-3`, and by "
            "default: the seven scenes of Table 3");
    add_hierarchy_options(command, options.hierarchy, true, &options.splits);
    add_query_options(command, options.query, true);
    add_kind_options(command, options.kind);
    command
        .add_option("--layout", options.layouts,
                    "Layouts of slab cut balls: some of reference, " + layout_names() +
                        "; packed ones have the test 'symmetric'")
        .offer_list(layout_words())
        .type_name("LIST")
        .show_default()
        .shareable();
    add_leaf_option(command, options.leaf_triangles);
    command
        .add_option(
            "--simd", options.simd,
            "Vector instructions of packed layouts: best, base (none on x86-64: slow), sse4, "
            "avx2 or avx512; answers are the same")
        .offer({"best", "base", "sse4", "avx2", "avx512"})
        .type_name("LEVEL")
        .show_default()
        .shareable();
    add_threads_option(command, options.threads,
                       "Threads that share a query of packed layouts, and each build");
    command.add_option("--repeat", options.repeats, "Time each query N times and take the median")
        .check(decimal_number)
        .type_name("N")
        .show_default()
        .shareable();
    command
        .add_flag("--warm", options.warm,
                  "Run one hierarchy through all frames, then the next. Default: they take "
                  "turns at each frame")
        .shareable();
    add_figure_options(command, options.picture,
                       "Folder for bench.csv, bench.json and a picture per scene");
    add_shard_options(command, options.picture.shards, "frames of each scene");
    command.add_flag("--coherent", options.coherent,
                     "Also time each packed layout with a front: if bodies move slowly, a query "
                     "begins where an earlier one ended. Add --warm for a fair comparison");
    command
        .add_flag("--first", options.first,
                  "End each query at its first pair, as to ask whether bodies touch")
        .shareable();
    command
        .add_flag("--measures", options.measures,
                  "Also measure each hierarchy (see scb stats --measures), and say which measure "
                  "goes together with the cost: measures.csv and measures.png of -o")
        .shareable();
    command.add_flag("--json", options.json, "Print JSON instead of a table").shareable();
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
        "  scb bench cad --volume scb,scb2,obb --frames 0:499:10\n"
        "  scb bench spheres-l1 --kind distance --volume scb2,rss --split cost --frames 0:499:10");
}

}  // namespace scb::app
