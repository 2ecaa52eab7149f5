// scb_distance_peers: the distance of two bodies by this project and by FCL: equal distances first,
// times second. core/topics/section-7.md has its tables.

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <map>

#include "core/base/exit_status.h"
#include "core/base/statistics.h"
#include "core/base/text_format.h"
#include "core/platform/output_file.h"
#include "scb/error.h"
#include "scenes/meshes/mesh_file.h"
#include "scenes/scene/load_scene.h"
#include "tests/peers/core_mesh.h"
#include "tests/peers/distance_plot.h"
#include "tests/peers/distance_scene.h"
#include "tests/peers/gnuplot.h"
#include "tests/peers/output_folder.h"

namespace scb {
namespace {

struct Options {
    std::vector<std::string> bodies;
    std::string models_dir, output;
    std::vector<double> gaps = {0.001, 0.01, 0.1, 1};
    int rounds = 5;
    std::size_t poses = 12;
};

struct Named {
    std::string title;
    std::unique_ptr<DistancePeer> peer;
};

/// The first is the one that the others are compared with.
std::vector<Named> peers_of(const DistanceBodies& bodies) {
    const PeerMesh a = peer_mesh(bodies.a.mesh), b = peer_mesh(bodies.b.mesh);
    std::vector<Named> peers;
    const auto own = [&](std::string_view title, DistanceTree tree, DistanceOrder order,
                         bool seeded = false) {
        peers.push_back({std::string(title), own_distance_peer(bodies, tree, order, seeded)});
    };
    own(packed_title, DistanceTree::packed, DistanceOrder::hybrid);
    own("depth first", DistanceTree::packed, DistanceOrder::depth_first);
    own("nearest", DistanceTree::packed, DistanceOrder::nearest);
    own("with a seed", DistanceTree::packed, DistanceOrder::hybrid, true);
    own(one_slab_title, DistanceTree::packed_one_slab, DistanceOrder::hybrid);
    own(reference_title, DistanceTree::reference, DistanceOrder::hybrid);
    peers.push_back({std::string(distance_baseline_title), fcl_distance_peer(a, b, true)});
    peers.push_back({std::string(rss_title), fcl_distance_peer(a, b, false)});
    return peers;
}

/// The means of the poses in milliseconds, by peer.
struct Means {
    std::vector<double> cold, warm;
};

/// A row of the table, and the times of all peers. Sets `differs` if a distance differs: of this
/// project at all, of FCL by more than 1e-9 of it.
Means measure(std::vector<Named>& named, const std::vector<PeerPoses>& poses, int rounds,
              std::string& row, bool& differs) {
    std::uint64_t n_v = 0, n_p = 0;
    for (const PeerPoses& at : poses) {
        double expected = 0;
        for (std::size_t p = 0; p < named.size(); ++p) {
            named[p].peer->query(at.a, at.b);
            const double found = named[p].peer->distance();
            if (p == 0) expected = found;
            const bool is_own = !named[p].title.starts_with("FCL");
            if (is_own ? found != expected : std::abs(found - expected) > 1e-9 * expected) {
                differs = true;
                std::cerr << "scb_distance_peers: " << named[p].title << " finds "
                          << exact_number(found) << " in place of " << exact_number(expected)
                          << "\n";
            }
        }
        n_v += named[0].peer->n_v();
        n_p += named[0].peer->n_p();
    }
    std::vector<std::unique_ptr<Peer>> peers;
    for (Named& each : named) peers.push_back(std::move(each.peer));
    PeerTiming timing;
    timing.rounds = rounds;
    const std::vector<PeerTimes> times =
        time_peers(peers, std::vector<double>(peers.size(), 0.0), poses, timing);
    for (std::size_t p = 0; p < named.size(); ++p)
        named[p].peer.reset(static_cast<DistancePeer*>(peers[p].release()));
    Means means;
    for (const PeerTimes& each : times) {
        means.cold.push_back(mean(each.cold));
        means.warm.push_back(mean(each.warm));
    }
    for (const double ms : means.cold) row += format(" %.3g |", 1e3 * ms);
    const auto count = [&poses](std::uint64_t sum) {
        return static_cast<double>(sum) / static_cast<double>(poses.size());
    };
    row += format(" %.0f / %.0f |", count(n_v), count(n_p));
    return means;
}

/// The bodies of a name, and the group whose mean has their times.
struct Subject {
    DistanceScene scene;
    std::string group;
};

Subject subject(const std::string& name, const Options& options) {
    static const std::map<std::string, std::string> groups = {
        {"horse", "scans"},       {"skeleton_hand", "scans"}, {"aatbase", "CAD models"},
        {"anchor", "CAD models"}, {"boeing", "CAD models"},   {"tray_bottom", "CAD models"}};
    // Some scenes have the name of a model.
    const auto known = groups.find(name);
    if (known == groups.end() && scenes::names_scene(name)) {
        scenes::LoadOptions load;
        load.models_dir = options.models_dir;
        return {scene_of_frames(scenes::load_scene({name}, load), options.poses), "scenes"};
    }
    const std::filesystem::path file =
        name.ends_with(".ply") ? std::filesystem::path(name)
                               : std::filesystem::path(options.models_dir) / (name + ".ply");
    return {scene_of_gaps(scenes::load_mesh(file), options.gaps, options.poses),
            known == groups.end() ? "others" : known->second};
}

void print_header(const std::vector<Named>& peers, std::size_t poses) {
    std::cout << "FCL " << fcl_version() << "; microseconds, cold, mean of " << poses
              << " poses\n\n| bodies | gap |";
    for (const Named& peer : peers) std::cout << " " << peer.title << " |";
    std::cout << " N_v / N_p | FCL OBBRSS / packed | the same, warm |\n|---|--:|";
    for (std::size_t i = 0; i < peers.size() + 3; ++i) std::cout << "--:|";
    std::cout << "\n";
}

int compare(const Options& options) {
    std::vector<std::string> names = options.bodies;
    if (names.empty())
        names = {"horse",    "skeleton_hand", "aatbase",
                 "anchor",   "boeing",        "tray_bottom",
                 "knots-l1", "knots-l3",      SCB_SOURCE_DIR "/tests/peers/nested-spheres.json"};
    if (!options.output.empty()) make_folder(options.output);
    bool differs = false, has_header = false;
    std::map<std::string, std::vector<double>> logs;  // of FCL's time over the time of the packed
    DistanceTimes times;
    for (const std::string& name : names) {
        const auto [scene, group] = subject(name, options);
        std::vector<Named> peers = peers_of(*scene.bodies);
        if (!has_header) print_header(peers, options.poses);
        has_header = true;
        times.peers.clear();
        for (const Named& peer : peers) times.peers.push_back(peer.title);
        for (const auto& [gap, poses] : scene.rows) {
            const std::string bodies = std::filesystem::path(name).stem().string();
            std::string row = "| " + bodies + " | " + gap + " |";
            const auto [cold, warm] = measure(peers, poses, options.rounds, row, differs);
            times.rows.push_back({bodies, gap, cold});
            for (const auto& [ms, name_of_times] : {std::pair(&cold, "cold"), {&warm, "warm"}}) {
                const double quicker = times.speedup(*ms, packed_title);
                logs[group + ", " + name_of_times].push_back(std::log(quicker));
                row += format(" %.1f |", quicker);
            }
            std::cout << row << std::endl;
        }
    }
    std::cout << "\n";
    for (const auto& [group, values] : logs)
        std::cout << group << ": geometric mean of FCL OBBRSS / packed "
                  << format("%.1f", std::exp(mean(values))) << "\n";
    if (!options.output.empty()) {
        const std::string missing =
            draw_plot(options.output, "distances.gnuplot", distance_plot_script(times));
        if (!missing.empty()) std::cerr << "scb_distance_peers: " << missing << "\n";
    }
    return differs ? exit_different : exit_done;
}

int run(int argc, char** argv) {
    CLI::App program{"scb_distance_peers: distances of this project and of FCL."};
    Options options;
    program.add_option(
        "BODIES", options.bodies,
        "PLY files or names of models, each with a copy of itself, and scenes; else six models, "
        "knots, and nested spheres");
    program.add_option("--models", options.models_dir, "the folder of the models")
        ->envname("SCB_MODELS");
    program.add_option("--gaps", options.gaps, "distances of copies, in longest sides of the mesh")
        ->delimiter(',')
        ->check(CLI::PositiveNumber);
    program.add_option("--poses", options.poses, "random poses of each gap, or frames of a scene")
        ->check(CLI::Range(1, 1000));
    program.add_option("--rounds", options.rounds, "how many times each query is timed")
        ->check(CLI::Range(1, 1000));
    program.add_option("-o,--output", options.output,
                       "a folder for distances.gnuplot and distances.png");
    program.footer(
        "Exit status: 0 done, 1 a distance differs, 2 bad usage or input, 3 a file cannot be "
        "written.");
    try {
        program.parse(argc, argv);
        return compare(options);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? exit_done : exit_bad_input;
    } catch (const InputError& error) {
        std::cerr << "scb_distance_peers: error: " << error.what() << "\n";
        return exit_bad_input;
    } catch (const OutputError& error) {
        std::cerr << "scb_distance_peers: error: " << error.what() << "\n";
        return exit_environment;
    }
}

}  // namespace
}  // namespace scb

int main(int argc, char** argv) { return scb::run(argc, argv); }
