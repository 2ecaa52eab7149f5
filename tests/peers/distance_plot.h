#pragma once

#include <string>
#include <vector>

namespace scb {

/// Times of queries for the distance, and how they are drawn.
struct DistancePlot {
    struct Row {
        std::string bodies, gap;
        std::vector<double> ms;  ///< one per peer
    };
    std::vector<std::string>
        peers;              ///< titles; "FCL OBBRSS" is the one that others are compared with
    std::vector<Row> rows;  ///< rows of the same bodies follow each other
};

/// A gnuplot script that draws `distances.png` where it runs: how many times as quick as FCL each
/// peer is, by bodies and gaps, on one logarithmic scale.
std::string distance_plot_script(const DistancePlot& plot);

}  // namespace scb
