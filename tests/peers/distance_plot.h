#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scb {

/// The titles of peers, as tables and plots name them. Others are compared with the baseline.
inline constexpr std::string_view packed_title = "packed", one_slab_title = "one slab",
                                  reference_title = "reference", rss_title = "FCL RSS",
                                  distance_baseline_title = "FCL OBBRSS";

/// Times of queries for the distance.
struct DistanceTimes {
    struct Row {
        std::string bodies, gap;
        std::vector<double> ms;  ///< one per peer
    };
    std::vector<std::string> peers;  ///< titles
    std::vector<Row> rows;           ///< rows of the same bodies follow each other

    /// How many times as long as a peer the baseline takes, by the times of all peers. Throws
    /// std::out_of_range for a title that is none.
    double speedup(const std::vector<double>& ms, std::string_view title) const;
};

/// A gnuplot script that draws `distances.png` where it runs: how many times as quick as FCL each
/// peer is, by bodies and gaps, on one logarithmic scale.
std::string distance_plot_script(const DistanceTimes& times);

}  // namespace scb
