#include "tests/peers/distance_plot.h"

#include <algorithm>
#include <string_view>

#include "core/base/text_format.h"
#include "scb/any_hierarchy.h"
#include "tests/peers/gnuplot.h"

namespace scb {
namespace {

/// A peer that is drawn; the others are in the table alone.
struct Drawn {
    std::string_view title, legend;
    render::Rgba8 color;
    int symbol;  ///< of gnuplot: circle, square, triangle, rhombus
};

std::vector<Drawn> drawn_peers() {
    const render::Rgba8 own = render::hierarchy_color(VolumeKind::scb2);
    return {{packed_title, "scb, packed, two slabs", own, 7},
            {one_slab_title, "scb, packed, one slab", render::hierarchy_color(VolumeKind::scb), 5},
            {reference_title, "scb, reference, two slabs",
             render::shade_of(own, 1, 2, render::light_theme), 9},
            {rss_title, "FCL, RSS", render::hierarchy_color(VolumeKind::rss), 13},
            {distance_baseline_title, "FCL, OBBRSS", render::hierarchy_color(VolumeKind::obb), 11}};
}

/// The rows, with a column for each drawn peer; an empty line between bodies ends the lines.
std::string data_block(const DistanceTimes& times) {
    std::string text;
    for (std::size_t i = 0; i < times.rows.size(); ++i) {
        const DistanceTimes::Row& row = times.rows[i];
        if (i > 0 && row.bodies != times.rows[i - 1].bodies) text += "\n";
        text += std::to_string(i);
        for (const Drawn& peer : drawn_peers())
            text += format(" %.4g", times.speedup(row.ms, peer.title));
        text += "\n";
    }
    return text;
}

/// A tic at each row, a title above the rows of the same bodies, and a line between two of them.
/// The tic of a scene is its name.
std::string row_labels(const DistanceTimes& times) {
    std::string tics, text;
    std::size_t first = 0;
    for (std::size_t i = 0; i < times.rows.size(); ++i) {
        const DistanceTimes::Row& row = times.rows[i];
        tics += (i == 0 ? "" : ", ") + gnuplot_text(row.gap == "-" ? row.bodies : row.gap) + " " +
                std::to_string(i);
        const bool ends = i + 1 == times.rows.size() || times.rows[i + 1].bodies != row.bodies;
        if (!ends) continue;
        if (row.gap != "-")
            text += "set label " + gnuplot_text(row.bodies) +
                    format(" at first %g, graph 1.03 center\n", static_cast<double>(first + i) / 2);
        if (i + 1 < times.rows.size())
            text += format("set arrow from first %g, graph 0 to first %g, graph 1 nohead ",
                           static_cast<double>(i) + 0.5, static_cast<double>(i) + 0.5) +
                    "linecolor rgb '#C4C8CE'\n";
        first = i + 1;
    }
    return text + "set xtics nomirror rotate by 45 right (" + tics + ")\n";
}

}  // namespace

double DistanceTimes::speedup(const std::vector<double>& ms, std::string_view title) const {
    const auto of = [&](std::string_view name) {
        const auto found = std::find(peers.begin(), peers.end(), name);
        return ms.at(static_cast<std::size_t>(found - peers.begin()));
    };
    return of(distance_baseline_title) / of(title);
}

std::string distance_plot_script(const DistanceTimes& times) {
    std::string text =
        "# gnuplot: draws distances.png\n"
        "set terminal pngcairo size 1600,760 font 'Roboto,19' noenhanced background '#FFFFFF'\n"
        "set output 'distances.png'\nset encoding utf8\n$data << END\n" +
        data_block(times) +
        "END\nset title 'The distance of two bodies: speed of a query, cold, by gap (1: the "
        "longest side)' "
        "font ',23' offset 0,1\n"
        "set logscale y\nset border 3 linecolor rgb '#60676F'\n"
        "set grid ytics linecolor rgb '#C4C8CE' linewidth 1\n"
        "set ytics nomirror (0.5, 1, 2, 5, 10, 20, 50, 100)\n"
        "set ylabel 'times as quick as FCL, OBBRSS'\n"
        "set lmargin 9\nset rmargin 2\nset tmargin 5\nset bmargin 9.5\n"
        "set key at screen 0.5, screen 0.02 center bottom maxrows 2 width -3 samplen 3 spacing "
        "1.2 Left "
        "reverse font ',18'\n" +
        format("set xrange [-0.7:%g]\n", static_cast<double>(times.rows.size()) - 0.3) +
        row_labels(times) + "plot ";
    const std::vector<Drawn> drawn = drawn_peers();
    for (std::size_t p = 0; p < drawn.size(); ++p)
        text +=
            format("%s$data using 1:%zu with linespoints linewidth %d pointtype %d pointsize 2 ",
                   p > 0 ? ", \\\n     " : "", p + 2,
                   drawn[p].title == distance_baseline_title ? 4 : 2, drawn[p].symbol) +
            "linecolor rgb '" + gnuplot_color(drawn[p].color) + "' title " +
            gnuplot_text(std::string(drawn[p].legend));
    return text + "\n";
}

}  // namespace scb
