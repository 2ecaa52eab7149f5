#include "tests/peers/peer_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/statistics.h"
#include "tests/peers/peer_tables.h"
#include "tests/peers/peers.h"

namespace scb {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const UnsharedPairs& unshared) {
    return {
        {"count", unshared.count}, {"degenerate", unshared.degenerate}, {"close", unshared.close}};
}

Json json_of(const std::vector<double>& times, std::size_t stride, const std::vector<double>* other,
             std::size_t other_stride) {
    Json json = {{"mean_ms", mean(times)}};
    if (other)
        json["speedup_over_" + std::string(baseline_name)] =
            speedup(times, stride, *other, other_stride);
    json["ms"] = times;
    return json;
}

Json json_of(const SceneComparison& scene, std::span<const PeerKind> kinds) {
    const std::optional<std::size_t> baseline = find_peer(kinds, baseline_name);
    Json of_scene = {{"scene", scene.scene},
                     {"triangles", scene.triangles},
                     {"frames", scene.frames},
                     {"peers", Json::array()}};
    for (std::size_t p = 0; p < kinds.size(); ++p) {
        const PeerResult& peer = scene.peers[p];
        const PeerTimes* other = baseline ? &scene.peers[*baseline].times : nullptr;
        Json of_peer = {{"name", kinds[p].name},
                        {"compared_frames", peer.difference.frames},
                        {"pairs", peer.difference.pairs},
                        {"missing", json_of(peer.difference.missing)},
                        {"extra", json_of(peer.difference.extra)},
                        {"build_ms", peer.build_ms},
                        {"bytes_per_triangle", nullptr},
                        {"frame_stride", peer.times.stride}};
        if (std::isfinite(peer.bytes)) of_peer["bytes_per_triangle"] = peer.bytes;
        of_peer["warm"] = json_of(peer.times.warm, peer.times.stride,
                                  other ? &other->warm : nullptr, other ? other->stride : 1);
        of_peer["cold"] = json_of(peer.times.cold, peer.times.stride,
                                  other ? &other->cold : nullptr, other ? other->stride : 1);
        of_scene["peers"].push_back(std::move(of_peer));
    }
    return of_scene;
}

}  // namespace

std::string peer_json(std::span<const PeerKind> kinds, std::span<const ComparisonGroup> groups,
                      PeerQuery query) {
    Json json = {{"query", query == PeerQuery::first_contact ? "first_contact" : "all_pairs"},
                 {"peers", Json::array()},
                 {"scenes", Json::array()}};
    for (const PeerKind& kind : kinds)
        json["peers"].push_back(
            {{"name", kind.name}, {"title", kind.title}, {"method", kind.method}});
    for (const ComparisonGroup& group : groups)
        for (const SceneComparison& scene : group.scenes)
            json["scenes"].push_back(json_of(scene, kinds));
    return json.dump(1) + "\n";
}

}  // namespace scb
