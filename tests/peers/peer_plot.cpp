#include "tests/peers/peer_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render/view/palette.h"
#include "scb/any_hierarchy.h"
#include "tests/peers/gnuplot.h"
#include "tests/peers/peer_tables.h"
#include "tests/peers/peers.h"

namespace scb {
namespace {

/// The first of these colors are the own hierarchies', in shades of the color that slab cut balls
/// have in every figure. FCL's boxes have the color of boxes.
std::string color_of(std::span<const PeerKind> kinds, std::size_t p) {
    constexpr std::size_t library_colors[] = {0, 5, 2, 4, 6};
    std::size_t own = 0, own_count = 0, library = 0;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (kinds[i].own) {
            own += i < p ? 1u : 0u;
            ++own_count;
        } else if (i < p && kinds[i].name != baseline_name) {
            ++library;
        }
    }
    render::Rgba8 color =
        render::category_color(library_colors[library % std::size(library_colors)]);
    if (kinds[p].own)
        color = render::shade_of(render::hierarchy_color(VolumeKind::scb), own_count - 1 - own,
                                 own_count, render::light_theme);
    if (kinds[p].name == baseline_name) color = render::hierarchy_color(VolumeKind::obb);
    return gnuplot_color(color);
}

struct Panel {
    const char* title;
    std::vector<double> PeerTimes::*times;
    double left, right;  ///< of the picture's width
};

constexpr Panel panels[] = {{"warm: all frames in turn", &PeerTimes::warm, 0.065, 0.505},
                            {"cold: peers take turns", &PeerTimes::cold, 0.55, 0.99}};

/// The points of a panel, a column for each peer.
std::string data_block(std::span<const SceneComparison> scenes, std::size_t baseline,
                       const std::vector<double> PeerTimes::*times) {
    std::string text;
    for (const SceneComparison& scene : scenes) {
        const PeerTimes& other = scene.peers[baseline].times;
        text += "\"" + scene.scene + "\"";  // a name fit for a file name needs no escapes
        for (const PeerResult& peer : scene.peers) {
            char cell[32];
            std::snprintf(
                cell, sizeof cell, " %.4g",
                speedup(peer.times.*times, peer.times.stride, other.*times, other.stride));
            text += cell;
        }
        text += "\n";
    }
    return text;
}

/// How peer p is drawn, without a title.
std::string style(std::span<const PeerKind> kinds, std::size_t p) {
    // Filled symbols that gnuplot has: circle, square, triangle up and down, rhombus, pentagon.
    constexpr int symbols[] = {7, 5, 9, 11, 13, 15};
    const bool baseline = kinds[p].name == baseline_name;
    return "with linespoints linewidth " + std::string(baseline ? "4" : "2") + " pointtype " +
           std::to_string(symbols[p % std::size(symbols)]) + " pointsize 2 linecolor rgb '" +
           color_of(kinds, p) + "'";
}

/// In the legend; marked where the peer finds other pairs somewhere.
std::string title(std::span<const PeerKind> kinds, std::span<const ComparisonGroup> groups,
                  std::size_t p) {
    return kinds[p].title + (finds_the_same(groups, p) ? "" : " *");
}

/// Where things are in the picture, in pixels: under each other, so that neither more groups of
/// scenes nor more peers make anything smaller.
struct Layout {
    static constexpr int width = 1600, top = 120, panel = 440, names = 115, panel_title = 60,
                         legend_row = 36, note = 60;
    int rows, legend_rows, height;

    Layout(std::size_t groups, std::size_t peers)
        : rows(static_cast<int>(groups)),
          legend_rows(static_cast<int>((peers + 2) / 3)),
          height(legend_top() + legend_row * legend_rows + note) {}

    /// From the top of the picture.
    int panel_top(int row) const { return top + row * (panel + names + panel_title); }
    int legend_top() const { return panel_top(rows - 1) + panel + names; }

    /// As gnuplot has it: from the bottom, as a share of the height.
    std::string screen(int from_top) const {
        return std::to_string(1 - static_cast<double>(from_top) / height);
    }
};

/// The least and the most that is drawn.
std::pair<double, double> range(std::span<const ComparisonGroup> groups, std::size_t baseline) {
    double least = 1, most = 1;
    for (const ComparisonGroup& group : groups)
        for (const SceneComparison& scene : group.scenes)
            for (const Panel& panel : panels)
                for (const PeerResult& peer : scene.peers) {
                    const PeerTimes& other = scene.peers[baseline].times;
                    const double by = speedup(peer.times.*panel.times, peer.times.stride,
                                              other.*panel.times, other.stride);
                    least = std::min(least, by);
                    most = std::max(most, by);
                }
    return {least, most};
}

/// The name of a panel's data.
std::string block_name(std::size_t group, std::size_t panel) {
    return "$panel" + std::to_string(group * std::size(panels) + panel);
}

/// The panels of a group of scenes, beside each other.
std::string panel_row(std::span<const PeerKind> kinds, const ComparisonGroup& group, std::size_t g,
                      const Layout& layout) {
    const int top = layout.panel_top(static_cast<int>(g));
    std::string text = "set tmargin at screen " + layout.screen(top) + "\nset bmargin at screen " +
                       layout.screen(top + Layout::panel) + "\nset xrange [-0.4:" +
                       std::to_string(static_cast<double>(group.scenes.size()) - 0.6) + "]\n";
    for (std::size_t i = 0; i < std::size(panels); ++i) {
        text += "set lmargin at screen " + std::to_string(panels[i].left) +
                "\nset rmargin at screen " + std::to_string(panels[i].right) + "\nset title " +
                gnuplot_text((group.title.empty() ? "" : group.title + ", ") + panels[i].title) +
                (i == 0 ? "\nset ylabel 'times as quick as FCL' offset 0.5\nset ytics format '%g'\n"
                        : "\nunset ylabel\nset ytics format ''\n") +
                "plot ";
        for (std::size_t p = 0; p < kinds.size(); ++p)
            text += std::string(p > 0 ? ", \\\n     " : "") + block_name(g, i) +
                    " using 0:" + std::to_string(p + 2) + ":xtic(1) " + style(kinds, p);
        text += "\n";
    }
    return text;
}

/// The legend, below all panels.
std::string legend(std::span<const PeerKind> kinds, std::span<const ComparisonGroup> groups,
                   const Layout& layout) {
    const std::string top = layout.screen(layout.legend_top());
    std::string text =
        "unset title\nunset ylabel\nunset border\nunset xtics\nunset ytics\nunset grid\nunset "
        "logscale\n"
        "set tmargin at screen " +
        top +
        "\nset bmargin at screen 0\n"
        "set lmargin at screen 0\nset rmargin at screen 1\nset xrange [0:1]\nset yrange [0:1]\n"
        "set key at screen 0.5, screen " +
        top + " center top maxrows " + std::to_string(layout.legend_rows) +
        " width -1 samplen 3 spacing 1.2 Left reverse font ',18' textcolor rgb '#1C2026'\n";
    bool all_same = true;
    for (std::size_t p = 0; p < kinds.size(); ++p) all_same &= finds_the_same(groups, p);
    if (!all_same)
        text +=
            "set label '* finds other pairs of triangles than the others on some scenes' at screen "
            "0.5, screen " +
            layout.screen(layout.height - 22) + " center textcolor rgb '#60676F'\n";
    text += "plot ";
    for (std::size_t p = 0; p < kinds.size(); ++p)
        text += std::string(p > 0 ? ", \\\n     " : "") + "NaN " + style(kinds, p) + " title " +
                gnuplot_text(title(kinds, groups, p));
    return text + "\n";
}

}  // namespace

std::string plot_script(std::span<const PeerKind> kinds, std::span<const ComparisonGroup> groups,
                        PeerQuery query) {
    const std::size_t baseline = find_peer(kinds, baseline_name).value();
    const auto [least, most] = range(groups, baseline);
    const Layout layout(groups.size(), kinds.size());
    std::string text = "# gnuplot: draws peers.png\nset terminal pngcairo size " +
                       std::to_string(Layout::width) + "," + std::to_string(layout.height) +
                       " font 'Roboto,19' noenhanced background '#FFFFFF'\n"
                       "set output 'peers.png'\n"
                       "set encoding utf8\n";
    for (std::size_t g = 0; g < groups.size(); ++g)
        for (std::size_t i = 0; i < std::size(panels); ++i)
            text += block_name(g, i) + " << END\n" +
                    data_block(groups[g].scenes, baseline, panels[i].times) + "END\n";
    text +=
        "set multiplot title '" +
        std::string(query == PeerQuery::first_contact ? "First contact of two bodies"
                                                      : "All pairs of triangles that intersect") +
        ": speed of a query, by scene' "
        "font ',23' textcolor rgb '#1C2026'\n"
        "set logscale y\n"
        "set yrange [" +
        std::to_string(least / 1.3) + ":" + std::to_string(most * 1.3) +
        "]\n"
        "set border 3 linecolor rgb '#60676F'\n"
        "set grid ytics linecolor rgb '#C4C8CE' linewidth 1\n"
        "set xtics nomirror rotate by 25 right textcolor rgb '#1C2026'\n"
        "set ytics nomirror (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100) "
        "textcolor rgb '#1C2026'\n"
        "unset key\n";
    for (std::size_t g = 0; g < groups.size(); ++g) text += panel_row(kinds, groups[g], g, layout);
    return text + legend(kinds, groups, layout) + "unset multiplot\n";
}

}  // namespace scb
