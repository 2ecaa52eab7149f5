#include "tests/peers/distance_plot.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace scb {
namespace {

DistanceTimes some_times() {
    DistanceTimes times;
    times.peers = {"packed", "one slab", "reference", "FCL OBBRSS", "FCL RSS"};
    times.rows = {{"horse", "0.1", {1, 2, 20, 12, 11}},
                  {"horse", "1", {2, 2, 40, 12, 12}},
                  {"knots", "-", {4, 4, 80, 12, 12}}};
    return times;
}

TEST(DistancePlot, HasTheSpeedOfEachPeer) {
    const std::string script = distance_plot_script(some_times());
    // An empty line ends the lines of the first bodies.
    EXPECT_NE(script.find("$data << END\n0 12 6 0.6 1.091 1\n1 6 6 0.3 1 1\n\n2 3 3 0.15 1 1\nEND"),
              std::string::npos)
        << script;
    EXPECT_NE(script.find("'0.1' 0, '1' 1, 'knots' 2"), std::string::npos) << script;
    EXPECT_NE(script.find("label 'horse' at first 0.5"), std::string::npos) << script;
    EXPECT_EQ(script.find("label 'knots'"), std::string::npos) << "the tic has the name";
}

TEST(DistancePlot, NeedsAllPeers) {
    DistanceTimes times = some_times();
    times.peers[1] = "two slabs";
    EXPECT_THROW(distance_plot_script(times), std::out_of_range);
}

}  // namespace
}  // namespace scb
