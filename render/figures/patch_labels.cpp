#include "render/figures/patch_labels.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "core/geometry/mesh_parts.h"
#include "render/figures/figure_words.h"

namespace scb::render {
namespace {

constexpr std::size_t most_labels = 20, most_patch_rows = 8;
/// Labels are this far apart, as a part of the view's height, if the patches allow it.
constexpr double least_apart = 0.05;

bool is_free(const Vec3& place, const std::vector<SceneLabel>& labels, const Camera& camera) {
    const Vec3 here = project(camera, place, 1, 1);
    return std::none_of(labels.begin(), labels.end(), [&](const SceneLabel& label) {
        const Vec3 there = project(camera, label.at, 1, 1);
        return std::hypot(here[0] - there[0], here[1] - there[1]) < least_apart;
    });
}

/// `places` must not be empty.
Vec3 nearest_to_eye(const std::vector<Vec3>& places, const Camera& camera) {
    return *std::max_element(places.begin(), places.end(), [&](const Vec3& p, const Vec3& q) {
        return to_eye(camera, p)[2] < to_eye(camera, q)[2];
    });
}

}  // namespace

std::vector<ContactPatch> patches_of(const QueryBodies& bodies, const TraceHeader& header,
                                     const QueryTrace& frame) {
    const Mesh &a = *bodies[0].mesh, &b = *bodies[1].mesh;
    const std::vector<Triangle> of_a = joined_triangles(a), of_b = joined_triangles(b);
    return contact_patches({a, of_a}, {b, of_b}, frame.b_to_a, frame.found.pairs,
                           header.kind == QueryKind::self);
}

std::vector<SceneLabel> patch_labels(std::span<const ContactPatch> patches,
                                     const QueryBodies& bodies, std::span<const Segment> contact,
                                     const Camera& camera, const Theme& theme) {
    std::size_t pairs = 0;
    for (const ContactPatch& patch : patches) pairs += patch.pairs.size();
    std::vector<std::size_t> patch_of(pairs);
    for (std::size_t i = 0; i < patches.size(); ++i)
        for (const std::uint32_t pair : patches[i].pairs) patch_of[pair] = i;
    std::vector<std::vector<Vec3>> places(patches.size());
    for (const Segment& segment : contact)
        places[patch_of[segment.id]].push_back(0.5 * segment.from + 0.5 * segment.to);
    std::vector<SceneLabel> labels;
    for (std::size_t i = 0; i < std::min(patches.size(), most_labels); ++i) {
        const Box& box = patches[i].box;
        if (places[i].empty())
            places[i].push_back(transform_point(bodies[0].pose, 0.5 * box.lower + 0.5 * box.upper));
        std::vector<Vec3> free;
        std::copy_if(places[i].begin(), places[i].end(), std::back_inserter(free),
                     [&](const Vec3& place) { return is_free(place, labels, camera); });
        labels.push_back({nearest_to_eye(free.empty() ? places[i] : free, camera),
                          std::to_string(i + 1), theme.text});
    }
    return labels;
}

std::vector<PanelItem> patch_rows(std::span<const ContactPatch> patches) {
    std::vector<PanelItem> items;
    items.emplace_back(PanelRow{"patches", {count_text(patches.size())}, {}, true});
    const std::size_t shown =
        patches.size() > most_patch_rows ? most_patch_rows - 1 : patches.size();
    for (std::size_t i = 0; i < shown; ++i)
        items.emplace_back(
            PanelRow{"pairs in " + std::to_string(i + 1), {count_text(patches[i].pairs.size())}});
    if (shown == patches.size()) return items;
    std::size_t others = 0;
    for (std::size_t i = shown; i < patches.size(); ++i) others += patches[i].pairs.size();
    items.emplace_back(PanelRow{"pairs in others", {count_text(others)}});
    return items;
}

}  // namespace scb::render
