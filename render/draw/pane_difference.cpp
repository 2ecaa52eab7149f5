#include "render/draw/pane_difference.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace scb::render {
namespace {

struct Shown {
    std::uint32_t id;
    Rgba8 color;

    auto key() const { return std::tuple(id, color.r, color.g, color.b, color.a); }
    bool operator<(const Shown& other) const { return key() < other.key(); }
};

std::vector<Shown> shown_in(const Pane& pane) {
    std::vector<Shown> shown;
    for (const VolumeInstance& volume : pane.volumes)
        if (volume.id != 0) shown.push_back({volume.id, volume.color});
    for (const MeshDraw& mesh : pane.meshes)
        if (mesh.first_id != 0 && mesh.chosen)
            for (const std::uint32_t t : *mesh.chosen)
                shown.push_back({mesh.first_id + t, mesh.triangle_colors.empty()
                                                        ? mesh.color
                                                        : mesh.triangle_colors[t]});
        else if (mesh.first_id != 0)
            for (std::uint32_t t = 0; t < mesh.triangle_colors.size(); ++t)
                shown.push_back({mesh.first_id + t, mesh.triangle_colors[t]});
    std::sort(shown.begin(), shown.end());
    return shown;
}

}  // namespace

std::vector<std::uint32_t> differing_ids(const Pane& a, const Pane& b) {
    const std::vector<Shown> in_a = shown_in(a), in_b = shown_in(b);
    std::vector<Shown> only_one;
    std::set_symmetric_difference(in_a.begin(), in_a.end(), in_b.begin(), in_b.end(),
                                  std::back_inserter(only_one));
    std::vector<std::uint32_t> ids;
    for (const Shown& thing : only_one)
        if (ids.empty() || ids.back() != thing.id) ids.push_back(thing.id);
    return ids;
}

}  // namespace scb::render
