// scb_point_peers: the distances of points to a mesh by this project, by CGAL and by Embree: equal
// distances first, times second.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

#include "core/base/exit_status.h"
#include "core/base/statistics.h"
#include "core/base/text_format.h"
#include "core/platform/clock.h"
#include "scb/error.h"
#include "scenes/meshes/mesh_file.h"
#include "tests/peers/core_mesh.h"
#include "tests/peers/distance_scene.h"
#include "tests/peers/point_peer.h"

namespace scb {
namespace {

constexpr int point_count = 1000, rounds = 5;

class OwnPointPeer : public PointPeer {
  public:
    explicit OwnPointPeer(const Mesh& mesh) : mesh_(mesh), hierarchy_(build_hierarchy<Scb2>(mesh)) {
        of_probe_ = build_hierarchy<Scb2>(probe_);
    }

    double distance(const std::array<double, 3>& point) override {
        Pose at;
        at.translation = Vec3(point[0], point[1], point[2]);
        return scb::distance(Collider<Scb2>{hierarchy_, mesh_}, Collider<Scb2>{of_probe_, probe_},
                             at)
            .found.distance;
    }

  private:
    const Mesh& mesh_;
    Mesh probe_{{Vec3::Zero()}, {Triangle{0, 0, 0}}};
    Hierarchy<Scb2> hierarchy_, of_probe_;
};

struct Named {
    const char* title;
    std::unique_ptr<PointPeer> peer;
    double bound;  ///< of the difference to this project
    std::vector<double> ms{};
};

int compare(const std::string& file) {
    const Mesh mesh = normalized(scenes::load_mesh(file));
    const PeerMesh for_peers = peer_mesh(mesh);
    // Coordinates are at most 1. CGAL has doubles. Embree's corners, points and radii are floats:
    // each moves a distance by at most 2 x 2^-24.
    std::vector<Named> peers;
    peers.push_back({"scb", std::make_unique<OwnPointPeer>(mesh), 0});
    peers.push_back({"CGAL", cgal_point_peer(for_peers), std::ldexp(1.0, -44)});
    peers.push_back({"Embree", embree_point_peer(for_peers), std::ldexp(1.0, -21)});
    std::mt19937 random(1);
    const auto coordinate = [&random] { return std::ldexp(random(), -31) - 1; };
    std::vector<std::array<double, 3>> points(point_count);
    for (auto& p : points)
        for (double& x : p) x = coordinate();
    bool differs = false;
    for (const auto& p : points) {
        const double expected = peers[0].peer->distance(p);
        for (const Named& each : peers)
            if (const double found = each.peer->distance(p);
                !(std::abs(found - expected) <= each.bound)) {
                differs = true;
                std::cerr << "scb_point_peers: " << each.title << " finds " << exact_number(found)
                          << ", and scb " << exact_number(expected) << "\n";
            }
    }
    for (int round = 0; round < rounds; ++round)
        for (Named& each : peers) {
            const double start = milliseconds(Clock::thread);
            for (const auto& p : points) each.peer->distance(p);
            each.ms.push_back(milliseconds(Clock::thread) - start);
        }
    const double own = median(peers[0].ms);
    for (const Named& each : peers)
        std::cout << each.title
                  << format(": %.2f us a point, ", median(each.ms) * 1e3 / point_count)
                  << format("%.3f of the time of scb\n", median(each.ms) / own);
    return differs ? exit_different : exit_done;
}

}  // namespace
}  // namespace scb

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "scb_point_peers: give one PLY file.\n";
        return scb::exit_bad_input;
    }
    try {
        return scb::compare(argv[1]);
    } catch (const scb::InputError& error) {
        std::cerr << "scb_point_peers: error: " << error.what() << "\n";
        return scb::exit_bad_input;
    }
}
