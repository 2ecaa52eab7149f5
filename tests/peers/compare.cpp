// scb_peers: this project's queries against other libraries': the same scenes, pair sets first,
// times second. See run for the one command that builds and runs it.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <new>

#include "core/base/exit_status.h"
#include "core/platform/child_process.h"
#include "core/platform/output_file.h"
#include "scb/error.h"
#include "scenes/scene/load_scene.h"
#include "scenes/scene/scene_group.h"
#include "tests/peers/gnuplot.h"
#include "tests/peers/output_folder.h"
#include "tests/peers/peer_json.h"
#include "tests/peers/peer_plot.h"
#include "tests/peers/peer_tables.h"
#include "tests/peers/peers.h"

namespace scb {
namespace {

struct Options {
    std::vector<std::string> scenes, peers;
    std::string models_dir, frames = "all", output, json;
    int rounds = 3, threads = 1;
    std::size_t compared_frames = 25;
    double budget = 3;
    bool first = false;

    PeerQuery query() const { return first ? PeerQuery::first_contact : PeerQuery::all_pairs; }
};

void note(const std::string& line) { std::cerr << "scb_peers: " << line << std::endl; }

/// "all", or FIRST:LAST[:STEP].
std::vector<int> frames_of(const std::string& text, const scenes::Scene& scene) {
    const auto refuse = [&]() -> InputError {
        return InputError("--frames " + text +
                          ": give all, or FIRST:LAST[:STEP] with frames from " + "0 to " +
                          std::to_string(scene.frames - 1) + ", which the scene '" + scene.name +
                          "' has, and STEP >= 1.");
    };
    int numbers[3] = {0, scene.frames - 1, 1};
    if (text != "all") {
        const char* at = text.data();
        const char* const end = at + text.size();
        for (int i = 0; i < 3; ++i) {
            const auto [next, error] = std::from_chars(at, end, numbers[i]);
            if (error != std::errc{}) throw refuse();
            at = next;
            if (at == end && i > 0) break;
            if (at == end || *at++ != ':' || i == 2) throw refuse();
        }
    }
    const auto [first, last, step] = numbers;
    if (first < 0 || last < first || last >= scene.frames || step < 1) throw refuse();
    std::vector<int> frames;
    for (int frame = first; frame <= last; frame += step) frames.push_back(frame);
    return frames;
}

void write_files(const Options& options, std::span<const PeerKind> kinds,
                 std::span<const ComparisonGroup> groups, const std::string& tables) {
    if (!options.json.empty())
        write_file_whole(options.json, peer_json(kinds, groups, options.query()));
    if (options.output.empty()) return;
    const std::filesystem::path folder = options.output;
    write_file_whole(folder / "peers.md", tables);
    write_file_whole(folder / "peers.json", peer_json(kinds, groups, options.query()));
    if (!find_peer(kinds, baseline_name))
        return note(std::string("there is no plot: it compares with ") + baseline_name +
                    ", which does not take part.");
    const std::string missing =
        draw_plot(folder, "peers.gnuplot", plot_script(kinds, groups, options.query()));
    if (!missing.empty()) note(missing);
}

/// What the program ends with: whether the peers that must find the reference's pairs did.
int compare(const Options& options) {
    std::vector<std::string> names = options.peers.empty() ? default_peers() : options.peers;
    // The reference takes part in any case: it is what pairs are compared with.
    if (std::find(names.begin(), names.end(), reference_name) == names.end())
        names.insert(names.begin(), reference_name);
    const std::vector<PeerKind> kinds = peers_of(names, options.threads);
    if (!options.output.empty()) make_folder(options.output);

    // All at once, so that what is wrong with the last is said before the first is measured.
    std::vector<scenes::Scene> loaded;
    std::vector<std::vector<int>> frames;
    const scenes::MeasuredScenes measured = scenes::measured_scenes(
        options.scenes, {"table-3", "dragons", "cad", "cad-aligned"}, options.models_dir);
    for (const std::string& sentence : measured.left_out) note(sentence);
    for (const std::string& name : measured.names) {
        loaded.push_back(
            scenes::load_scene({name}, {.models_dir = options.models_dir, .pose = {}}));
        const scenes::Scene& scene = loaded.back();
        if (scene.bodies.size() != 2)
            throw InputError("the scene '" + scene.name + "' has " +
                             std::to_string(scene.bodies.size()) + " bodies; give one with two.");
        frames.push_back(frames_of(options.frames, scene));
    }

    std::vector<ComparisonGroup> groups;
    bool same = true;
    for (std::size_t i = 0; i < loaded.size(); ++i) {
        const scenes::Scene& scene = loaded[i];
        PeerTiming timing;
        timing.rounds = options.rounds;
        timing.budget = options.budget;
        timing.wall = options.threads > 1;
        timing.progress = [&](const std::string& what) { note(scene.name + ": " + what); };
        SceneComparison found = compare_peers(scene, frames[i], kinds, options.query(),
                                              options.compared_frames, timing);
        for (std::size_t p = 0; p < kinds.size(); ++p) {
            if (!kinds[p].own || found.peers[p].difference.none()) continue;
            same = false;
            note(kinds[p].name + " finds other pairs on " + scene.name +
                 " than the reference, which is an error of this project.");
        }
        add_to_group(groups, std::move(found));
    }
    const std::string tables = peer_tables(kinds, groups, options.query());
    std::cout << tables << std::flush;
    write_files(options, kinds, groups, tables);
    return same ? exit_done : exit_different;
}

int run(int argc, char** argv) {
    CLI::App program{
        "scb_peers: slab cut balls against other libraries: pair sets first, times second."};
    Options options;
    program.add_option(
        "SCENE", options.scenes,
        "built-in scenes or scene files of two bodies, or table-3, cad, cad-aligned; else table-3, "
        "dragons, cad and cad-aligned");
    program.add_option("--models", options.models_dir, "the folder that meshes are in")
        ->envname("SCB_MODELS");
    program.add_option("--frames", options.frames, "all, or FIRST:LAST[:STEP]")
        ->capture_default_str();
    program
        .add_option(
            "--peers", options.peers,
            "which take part: reference, a layout as of scb bench, or one with -cost, -scb2 or "
            "both, fcl, bullet, ode, embree, cgal")
        ->delimiter(',');
    program.add_flag("--first", options.first,
                     "the first contact, not all pairs: whether the bodies touch");
    program.add_option("--rounds", options.rounds, "how many times each query is timed")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    program
        .add_option("--budget", options.budget,
                    "seconds of one pass of a peer over a scene; slower ones take fewer frames")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    program
        .add_option("--compare-frames", options.compared_frames,
                    "in how many frames at most pairs are compared")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    program
        .add_option("--threads", options.threads,
                    "threads that share a query of a packed layout; more than 1: all times are of "
                    "the clock")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    program.add_option("-o,--output", options.output,
                       "a folder for peers.md, peers.json, peers.gnuplot and peers.png");
    program.add_option("--json", options.json, "a file for everything that was found");
    program.footer(
        "Exit status: 0 done, 1 a layout of this project finds other pairs than its reference, 2 "
        "bad usage or\ninput, 3 the environment failed.");
    try {
        program.parse(argc, argv);
        return compare(options);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? exit_done : exit_bad_input;
    } catch (const InputError& error) {
        note(std::string("error: ") + error.what());
        return exit_bad_input;
    } catch (const OutputError& error) {
        note(std::string("error: ") + error.what());
        return exit_environment;
    } catch (const std::bad_alloc&) {
        note("error: there is not enough memory; compare smaller meshes or fewer peers.");
        return exit_environment;
    }
}

}  // namespace
}  // namespace scb

int main(int argc, char** argv) { return scb::run(argc, argv); }
