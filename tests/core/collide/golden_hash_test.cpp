#include <gtest/gtest.h>

#include <cstring>

#include "scb/hierarchy.h"
#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

// FNV-1a over the bytes of doubles and integers, in a stated order.
struct Hash {
    std::uint64_t value = 0xcbf29ce484222325u;

    template <class T>
    void add(const T& number) {
        unsigned char bytes[sizeof(T)];
        std::memcpy(bytes, &number, sizeof(T));
        for (const unsigned char byte : bytes) value = (value ^ byte) * 0x100000001b3u;
    }
    void add(const Vec3& v) {
        for (int i = 0; i < 3; ++i) add(v[i] + 0.0);  // 0 for -0
    }
};

// The same bits for gcc and clang, Debug and Release, sanitizers or not, every CPU: the constants
// below are part of the interface.
TEST(GoldenHash, TopologyIsTheSameEverywhere) {
    Hash hash;
    for (const Mesh& mesh : {height_field(40), random_soup(61, 3000, 0.1)}) {
        const Topology topology = build_topology(mesh);
        for (const TopologyNode& node : topology.nodes) {
            hash.add(node.first);
            hash.add(node.count);
            hash.add(node.left);
        }
        for (const std::uint32_t t : topology.order) hash.add(t);
    }
    EXPECT_EQ(hash.value, 612267036590027459u);
}

TEST(GoldenHash, VolumesAreTheSameEverywhere) {
    Hash scb, ball, obb;
    for (const Mesh& mesh : {height_field(40), random_soup(61, 3000, 0.1)}) {
        for (const Scb& s : build_hierarchy<Scb>(mesh).volumes) {
            scb.add(s.c);
            scb.add(s.r);
            scb.add(s.n);
            scb.add(s.e + 0.0);
            scb.add(s.f + 0.0);
        }
        for (const Ball& b :
             build_hierarchy<Ball>(mesh, {.fit = {.ball_method = BallMethod::ritter}}).volumes) {
            ball.add(b.center);
            ball.add(b.radius);
        }
        for (const Obb& b : build_hierarchy<Obb>(mesh).volumes) {
            obb.add(b.center);
            for (int i = 0; i < 3; ++i) obb.add(Vec3(b.axes.col(i)));
            obb.add(b.half);
        }
    }
    EXPECT_EQ(scb.value, 5939249910335701495u);
    EXPECT_EQ(ball.value, 1132298264040824702u);
    EXPECT_EQ(obb.value, 10426606663329733255u);
}

}  // namespace
}  // namespace scb
