#include "tests/peers/peer_timing.h"

#include <gtest/gtest.h>

namespace scb {
namespace {

/// Counts its queries.
class CountingPeer : public Peer {
  public:
    explicit CountingPeer(int& queries) : queries_(queries) {}
    void query(const PeerPose&, const PeerPose&) override { ++queries_; }
    std::vector<IndexPair> pairs() const override { return {}; }

  private:
    int& queries_;
};

TEST(PeerTiming, ComparesOverTheFramesThatBothTook) {
    const std::vector<double> all = {1, 100, 2, 100, 3}, every_second = {10, 20, 30};
    EXPECT_DOUBLE_EQ(mean_over(all, 1, 2), 2);
    EXPECT_DOUBLE_EQ(mean_over(every_second, 2, 2), 20);
    EXPECT_DOUBLE_EQ(speedup(all, 1, every_second, 2), 10);
    EXPECT_DOUBLE_EQ(speedup(every_second, 2, all, 1), 0.1);
}

TEST(PeerTiming, GivesSlowPeersFewerFrames) {
    int quick = 0, slow = 0;
    std::vector<std::unique_ptr<Peer>> peers;
    peers.push_back(std::make_unique<CountingPeer>(quick));
    peers.push_back(std::make_unique<CountingPeer>(slow));
    const std::vector<PeerPoses> frames(10);
    PeerTiming timing;
    timing.rounds = 2;
    timing.budget = 1;
    // 10 frames of 300 ms are 3 s; of 4 times fewer, rounded up, 0.9 s.
    const std::vector<PeerTimes> times =
        time_peers(peers, std::vector<double>{1, 300}, frames, timing);
    EXPECT_EQ(times[0].stride, 1u);
    EXPECT_EQ(times[1].stride, 4u);
    EXPECT_EQ(times[0].warm.size(), 10u);
    EXPECT_EQ(times[1].warm.size(), 3u);
    EXPECT_EQ(times[1].cold.size(), 3u);
    // A warm pass that is not timed, one that is, and a cold one, in each of two rounds.
    EXPECT_EQ(quick, 2 * 3 * 10);
    EXPECT_EQ(slow, 2 * 3 * 3);
}

}  // namespace
}  // namespace scb
