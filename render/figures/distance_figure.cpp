#include "render/figures/distance_figure.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "core/analysis/ending.h"
#include "core/base/text_format.h"
#include "core/geometry/triangle_segment.h"
#include "render/figures/contact_areas.h"
#include "render/figures/figure_words.h"
#include "render/plots/ending_colors.h"
#include "scb/triangle_distance.h"

namespace scb::render {

std::string ending_words(const EndingGroup& group, QueryKind kind) {
    if (!is_of_distance(kind)) return group.label;
    switch (group.endings.front()) {
        case Stage::triangles_apart:
            return kind == QueryKind::within ? "triangles too far apart" : "triangles not nearer";
        case Stage::triangles_meet:
            return kind == QueryKind::within ? "triangles within" : "triangles nearer than before";
        case Stage::left_over:
            return "not needed any more";
        case Stage::slab_a:
            return "axes of A";
        case Stage::slab_b:
            return "axes of B";
        default:
            return group.label;
    }
}

std::string distance_text(double value) { return format("%.6g", value); }

std::vector<std::array<Vec3, 2>> distance_lines(const QueryBodies& bodies,
                                                const QueryTrace& frame) {
    using Line = std::array<Vec3, 2>;
    return of_pairs<Line>(bodies, frame,
                          [](const TriangleCorners& a, const TriangleCorners& b) -> Line {
                              const TriangleDistance found = triangle_distance(a, b);
                              if (found.distance == 0)
                                  if (const auto meet = triangles_intersection(a, b))
                                      return {meet->a, meet->b};
                              return {found.point_a, found.point_b};
                          });
}

std::vector<Segment> distance_segments(const QueryBodies& bodies, const QueryTrace& frame) {
    const std::vector<std::array<Vec3, 2>> lines = distance_lines(bodies, frame);
    std::vector<Segment> segments;
    for (std::size_t i = 0; i < lines.size(); ++i)
        segments.push_back({transform_point(bodies[0].pose, lines[i][0]),
                            transform_point(bodies[0].pose, lines[i][1]), Rgba8{},
                            static_cast<std::uint32_t>(i)});
    return segments;
}

std::vector<SceneLabel> distance_labels(const QueryBodies& bodies, const QueryTrace& frame,
                                        const Theme& theme) {
    if (!frame.nearest || frame.nearest->distance == 0) return {};
    const Vec3 middle = 0.5 * (frame.nearest->point_a + frame.nearest->point_b);
    return {{transform_point(bodies[0].pose, middle), distance_text(frame.nearest->distance),
             theme.text, transform_point(bodies[0].pose, frame.nearest->point_b)}};
}

PanelItem distance_row(const QueryTrace& frame) {
    return PanelRow{
        "distance", {frame.nearest ? distance_text(frame.nearest->distance) : "–"}, {}, true};
}

PanelKey distance_key(const TraceHeader& header, const QueryTrace& frame, const Theme& theme) {
    const bool meets = frame.nearest && frame.nearest->distance == 0;
    return {theme.text, header.kind == QueryKind::within     ? "between closest points"
                        : meets                              ? "where triangles meet"
                        : header.distance.relative_error > 0 ? "the distance found"
                                                             : "the shortest distance"};
}

std::vector<PanelItem> distance_panel(const QueryBodies& bodies, const TraceHeader& header,
                                      const QueryTrace& frame, const Attribution& verdicts,
                                      const Theme& theme) {
    const bool is_within = header.kind == QueryKind::within;
    std::vector<PanelItem> items;
    std::vector<std::string> names, counts, closest;
    std::vector<std::optional<Rgba8>> pale, strong;
    for (std::size_t side = 0; side < 2; ++side) {
        names.push_back(bodies[side].name);
        counts.push_back(count_text(bodies[side].mesh->triangles.size()));
        pale.emplace_back(dimmed_body_color(side, theme));
        strong.emplace_back(body_color(side));
        if (!frame.found.pairs.empty())
            closest.push_back(
                count_text(side == 0 ? frame.found.pairs.front().a : frame.found.pairs.front().b));
    }
    items.emplace_back(PanelRow{"body", column_names(items, names), pale, true});
    items.emplace_back(PanelRow{"triangles", counts});
    if (!is_within && !closest.empty()) items.emplace_back(PanelRow{"closest", closest, strong});
    items.emplace_back(PanelHeading{""});
    if (is_within) {
        items.emplace_back(PanelRow{"at most", {distance_text(header.tolerance)}});
        items.emplace_back(PanelRow{"pairs", {count_text(frame.found.pairs.size())}, {}, true});
    } else {
        items.push_back(distance_row(frame));
    }
    items.emplace_back(PanelRow{"N_v", {count_text(frame.found.n_v)}});
    items.emplace_back(PanelRow{"N_p", {count_text(frame.found.n_p)}});

    const Outcomes outcomes = outcomes_of(header, frame);
    const EndingCounts ended = ending_counts(outcomes);
    const std::uint64_t paths = std::accumulate(ended.begin(), ended.end(), std::uint64_t{0});
    items.emplace_back(PanelRow{"passed on", {count_text(frame.found.n_v - paths)}});
    const auto in_vain = static_cast<std::uint64_t>(std::count_if(
        verdicts.passed.begin(), verdicts.passed.end(), [&outcomes](const PassedPair& pair) {
            return is_divided(outcomes[pair.test]) && pair.reason != PassReason::triangles_meet;
        }));
    items.emplace_back(PanelRow{"of these in vain", {count_text(in_vain)}});
    std::string heading;
    for (const EndingGroup& group : ending_groups(header, theme)) {
        const std::uint64_t count = count_of(group, ended);
        if (count == 0) continue;
        const double share = 100.0 * static_cast<double>(count) / static_cast<double>(paths);
        const std::string above =
            is_rejection(group.endings.front()) ? "left out by the bound along" : "ended otherwise";
        if (std::exchange(heading, above) != above) items.emplace_back(PanelHeading{above});
        items.emplace_back(PanelLegendRow{group.color, ending_words(group, header.kind),
                                          count_text(count), format("%.1f %%", share)});
    }
    if (frame.found.pairs.empty()) return items;
    items.emplace_back(distance_key(header, frame, theme));
    items.emplace_back(PanelNote{"dashed, or pale: behind a body"});
    return items;
}

PanelChart distance_chart(const TraceHeader& header, const QueryTrace& frame, const Theme& theme) {
    PanelChart chart;
    chart.title = "by depth of the pair";
    const std::vector<EndingGroup> groups = ending_groups(header, theme);
    for (const EndingCounts& counts : endings_by_depth(frame, outcomes_of(header, frame))) {
        std::vector<BarPart>& row = chart.rows.emplace_back();
        for (const EndingGroup& group : groups)
            row.push_back({group.color, static_cast<double>(count_of(group, counts))});
    }
    return chart;
}

}  // namespace scb::render
