#include "render/figures/level_figure.h"

#include <algorithm>
#include <limits>

#include "core/hierarchy/node_surfaces.h"
#include "core/model/level_statistics.h"
#include "render/figures/figure_words.h"
#include "render/overlay/side_panel.h"

namespace scb::render {
namespace {

// Whether the thickness is only rounding noise.
bool is_flat(const VolumeStatistics& s) { return s.thickness_sum < 1e-12 * s.diameter_sum; }

std::string ratio_text(const VolumeStatistics& s) {
    return is_flat(s)           ? "0"
           : s.diameter_sum > 0 ? number_text(s.mean_thickness() / s.mean_diameter())
                                : "–";
}

std::vector<PanelItem> panel_items(const LevelFigure& figure, const LevelNumbers& numbers) {
    const bool by_body = figure.style.colors.by == ColorBy::body;
    std::vector<PanelItem> items;
    // One column per body if they fit, else the sums.
    std::vector<const VolumeStatistics*> columns;
    std::vector<ItemCount> counts;
    for (const LevelBody& body : figure.bodies)
        counts.push_back(item_count(*body.mesh, *body.tree));
    PanelRow names{"body", {}, {}, true}, held{std::string(item_words(counts)), {}};
    if (figure.bodies.size() <= 2) {
        for (std::size_t b = 0; b < figure.bodies.size(); ++b) {
            columns.push_back(&numbers.bodies[b]);
            names.values.push_back(figure.bodies[b].name);
            names.swatches.push_back(by_body ? std::optional(category_color(b)) : std::nullopt);
            held.values.push_back(count_text(counts[b].count));
        }
    } else {
        columns.push_back(&numbers.all);
        names.values.push_back("all " + std::to_string(figure.bodies.size()));
        names.swatches.push_back(std::nullopt);
        std::uint64_t sum = 0;
        for (const ItemCount& count : counts) sum += count.count;
        held.values.push_back(count_text(sum));
    }
    const auto row = [&](const char* label, auto value_of, bool strong = false) {
        PanelRow r{label, {}, {}, strong};
        for (const VolumeStatistics* s : columns) r.values.push_back(value_of(*s));
        items.emplace_back(std::move(r));
    };
    if (figure.bodies.size() == 2) names.values = column_names(items, names.values);
    items.emplace_back(std::move(names));
    items.emplace_back(std::move(held));
    row(
        "volumes", [](const VolumeStatistics& s) { return count_text(s.volumes); }, true);
    row("leaves", [](const VolumeStatistics& s) { return count_text(s.leaves); });
    row("mean d", [](const VolumeStatistics& s) { return number_text(s.mean_diameter()); });
    row("mean τ", [](const VolumeStatistics& s) { return thickness_text(s); });
    row("τ / d", [](const VolumeStatistics& s) { return ratio_text(s); });
    row("Σ area", [](const VolumeStatistics& s) { return number_text(s.area); });
    row("Σ volume", [](const VolumeStatistics& s) { return volume_text(s); });
    if (figure.bodies.size() > 2 && by_body) items.emplace_back(PanelHeading{""});
    if (figure.bodies.size() > 2 && by_body)
        for (std::size_t b = 0; b < figure.bodies.size(); ++b)
            items.emplace_back(PanelKey{category_color(b), figure.bodies[b].name});
    if (const std::optional<PanelScale> scale = legend_of(figure.style.colors)) {
        items.emplace_back(PanelHeading{""});
        items.emplace_back(*scale);
    }
    if (figure.style.colors.by == ColorBy::subtree)
        items.emplace_back(PanelNote{"color: the subtree below the third division"});
    const VolumeFamily family = figure.bodies[0].tree->family();
    items.emplace_back(PanelNote{std::string(lengths_words(family)) +
                                 (family == VolumeFamily::two_slabs ? "; units of the scene"
                                  : family == VolumeFamily::slab_cut || family == VolumeFamily::ball
                                      ? "; lengths in units of the scene"
                                      : "")});
    return items;
}

/// The meshes alone, small, below the numbers if there is room.
void add_meshes(Picture& picture, Overlay& overlay, const LevelFigure& figure,
                const FigureLayout& layout, int below) {
    std::optional<PixelRect> place = detail_square(layout, below);
    if (!place) return;
    if (!layout.portrait) place->width = layout.panel.width;
    LevelStyle style = figure.style;
    style.mesh = true;
    style.opacity = 0;
    picture.panes.push_back(level_pane(*place, figure.camera_of_meshes(aspect_of(*place)),
                                       figure.bodies, figure.level, style));
    const int small = small_size(layout.unit);
    overlay.text(place->x, place->y - small * 5 / 4,
                 figure.bodies.size() == 1 ? "the mesh" : "the meshes",
                 {small, FontWeight::regular, style.theme->faint_text});
}

}  // namespace

std::string_view lengths_words(VolumeFamily family) {
    switch (family) {
        case VolumeFamily::slab_cut:
            break;
        case VolumeFamily::two_slabs:
            return "d = 2r, τ: the thinner slab";
        case VolumeFamily::ball:
            return "τ = d = 2r";
        case VolumeFamily::box:
            return "d: diagonal, τ: shortest side";
        case VolumeFamily::convex:
            return "d: length, τ: thickness of a volume";
    }
    return "d = 2r, τ = e − f";
}

std::string thickness_text(const VolumeStatistics& s) {
    return is_flat(s) ? "0" : number_text(s.mean_thickness());
}

std::string volume_text(const VolumeStatistics& s) {
    return is_flat(s) ? "0" : number_text(s.volume);
}

LevelNumbers level_numbers(const std::vector<LevelBody>& bodies, int level) {
    LevelNumbers numbers;
    for (const LevelBody& body : bodies) {
        numbers.bodies.push_back(
            cover_statistics(*body.tree, level_cover(body.tree->shape(), level)));
        numbers.all.add(numbers.bodies.back());
    }
    return numbers;
}

LengthHistogram level_lengths(const std::vector<LevelBody>& bodies, int level,
                              const LevelStyle& style) {
    LengthHistogram lengths;
    lengths.root_diameter = style.colors.root_diameter;
    for (const LevelBody& body : bodies)
        for (const std::uint32_t node : level_cover(body.tree->shape(), level)) {
            if (!body.tree->has_volume(node)) continue;
            const VolumeLengths of_node = body.tree->lengths(node);
            lengths.add(of_node.diameter, of_node.thickness);
        }
    return lengths;
}

Support support_of_levels(const std::vector<LevelBody>& bodies, const std::vector<int>& levels) {
    std::vector<Support> parts;
    for (const LevelBody& body : bodies) {
        std::vector<std::uint32_t> nodes;
        for (const int level : levels) {
            const std::vector<std::uint32_t> cover = level_cover(body.tree->shape(), level);
            nodes.insert(nodes.end(), cover.begin(), cover.end());
        }
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        std::erase_if(nodes, [&body](std::uint32_t node) { return !body.tree->has_volume(node); });
        parts.push_back([&body, nodes = std::move(nodes)](const Vec3& direction) {
            const Vec3 local = rotate(body.pose.rotation.transpose(), direction);
            double most = -std::numeric_limits<double>::infinity();
            for (const std::uint32_t node : nodes)
                most = std::max(most, reach(body.tree->volume(node), local));
            return most + dot(body.pose.translation, direction);
        });
    }
    return support_of_all(std::move(parts));
}

Pane level_pane(const PixelRect& viewport, const Camera& camera,
                const std::vector<LevelBody>& bodies, int level, const LevelStyle& style) {
    Pane pane;
    pane.viewport = viewport;
    pane.camera = camera;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const LevelBody& body = bodies[b];
        if (style.mesh) {
            MeshDraw mesh;
            mesh.mesh = body.handle;
            mesh.pose = body.pose;
            // Without volumes, meshes have the colors of their bodies.
            mesh.color = style.opacity <= 0 && style.colors.by == ColorBy::body ? category_color(b)
                                                                                : style.theme->mesh;
            mesh.edges = style.mesh_edges;
            pane.meshes.push_back(std::move(mesh));
        }
        if (style.opacity <= 0) continue;
        const TreeShape& shape = body.tree->shape();
        std::vector<std::uint8_t> subtrees;
        if (style.colors.by == ColorBy::subtree) subtrees = subtrees_of(shape);
        std::vector<double> surfaces;
        if (style.colors.by == ColorBy::surface) surfaces = node_surfaces(shape, *body.mesh);
        double whole = 0;
        if (!surfaces.empty())
            for (const std::uint32_t root : shape.roots) whole += surfaces[root];
        std::optional<AnyVolume> drawn;
        const std::vector<std::uint32_t> cover = level_cover(shape, level);
        pane.volumes.reserve(pane.volumes.size() + cover.size());
        for (const std::uint32_t node : cover) {
            if (!body.tree->has_volume(node)) continue;
            AnyVolume volume = body.tree->volume(node);
            // Duplicate triangles have equal leaves: of a run of equal volumes, only one is
            // visible.
            if (drawn && identical(volume, *drawn)) continue;
            const Rgba8 color = surfaces.empty()
                                    ? volume_color(style.colors, body.tree->lengths(node),
                                                   static_cast<int>(shape.depths[node]),
                                                   subtrees.empty() ? b : subtrees[node], node)
                                    : viridis(surface_magnitude(surfaces[node] / whole *
                                                                static_cast<double>(cover.size())));
            pane.volumes.push_back({placed(volume, body.pose), with_opacity(color, style.opacity),
                                    body.first_id + node});
            drawn = std::move(volume);
        }
    }
    return pane;
}

Picture compose(const LevelFigure& figure, int width, int height, int samples, Overlay& overlay) {
    const FigureLayout layout = figure_layout(width, height, figure.with_panel);
    const Theme& theme = *figure.style.theme;
    Picture picture{width, height, samples, theme.background, {}};
    picture.panes.push_back(
        level_pane(layout.view, figure.camera, figure.bodies, figure.level, figure.style));

    overlay.begin();
    if (!figure.with_panel) return picture;
    draw_heading(overlay, layout, theme, figure.title, figure.subtitle);
    int below = draw_side_panel(overlay, layout.panel, theme, layout.unit,
                                panel_items(figure, level_numbers(figure.bodies, figure.level)));
    PixelRect beside = layout.panel;
    beside.y = below + layout.unit / 2;
    if (layout.portrait) {
        beside = {layout.panel.x + layout.panel.width + 2 * layout.unit, layout.panel.y, 0,
                  layout.panel.height};
        beside.width = std::min(layout.panel.width, layout.view.x + layout.view.width - beside.x);
    }
    beside.height = layout.panel.y + layout.panel.height - beside.y;
    // In a portrait picture, a detail has this place.
    if (!layout.portrait || !figure.detail) {
        const PixelRect lengths = draw_length_histogram(
            overlay, beside, level_lengths(figure.bodies, figure.level, figure.style),
            {theme, layout.unit});
        below = std::max(below, lengths.y + lengths.height);
    }
    draw_scale_bar(overlay, layout.view, figure.camera, figure.center, theme, layout.unit);

    if (figure.camera_of_meshes) add_meshes(picture, overlay, figure, layout, below);
    if (!figure.detail) return picture;
    const std::optional<PixelRect> square = detail_square(layout, below);
    if (!square) return picture;
    picture.panes.push_back(
        level_pane(*square, figure.detail->camera, figure.bodies, figure.level, figure.style));
    draw_detail_frames(overlay, layout, *square, figure.camera, *figure.detail, theme);
    return picture;
}

}  // namespace scb::render
