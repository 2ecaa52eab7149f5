#include "scb/packed_scb.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/packed/grown_slab.h"
#include "scb/node_codec.h"
#include "tests/core/packed/random_scbs.h"

namespace scb {
namespace {

TEST(FloatAbove, IsTheSmallestThatIsNoLess) {
    EXPECT_EQ(float_above(1.0), 1.0f);
    EXPECT_EQ(float_above(1 + 0x1p-52), 1 + 0x1p-23f);
    EXPECT_EQ(float_above(-1 - 0x1p-52), -1.0f);
    EXPECT_EQ(float_above(0), 0.0f);
    EXPECT_EQ(float_above(1e-300), std::numeric_limits<float>::denorm_min());
}

double narrowest(const Scb& scb) { return scb.e - scb.f; }
double narrowest(const Scb2& scb) { return thickness(scb); }
double half_of(const PackedScb& scb) { return static_cast<double>(scb.h); }
double half_of(const PackedScb2& scb) { return static_cast<double>(scb.h[0]); }

template <class V>
void expect_that_floats_hold() {
    Random random(81);
    for (int i = 0; i < 20'000; ++i) {
        const V scb =
            some_volume<V>(random, std::ldexp(1.0, static_cast<int>(random.below(40)) - 20));
        const Vec3 origin = scb.c + scb.r * random_point(random);
        const auto small = packed(scb, origin);
        for (int k = 0; k < 8; ++k)
            ASSERT_TRUE(contains(small, point_of(scb, random) - origin)) << i;
        ASSERT_LT(static_cast<double>(small.r), scb.r * (1 + 1e-6));
        ASSERT_LT(2 * half_of(small), narrowest(scb) + 4e-6 * scb.r);
    }
}
TEST(PackedScb, HoldsTheWholeVolume) { expect_that_floats_hold<Scb>(); }
TEST(PackedScb2, HoldsTheWholeVolume) { expect_that_floats_hold<Scb2>(); }

TEST(PackedScb2, HasTheAxesOfTheVolume) {
    Random random(83);
    for (int i = 0; i < 10'000; ++i) {
        const Scb2 scb = some_scb2(random, 1);
        const PackedScb2 small = packed(scb, scb.c);
        const std::array<Vec3, 2> n = normals(small);
        const bool swapped = scb.slabs[1].e - scb.slabs[1].f < scb.slabs[0].e - scb.slabs[0].f;
        for (std::size_t k = 0; k < 2; ++k) {
            const Vec3& own = scb.slabs[swapped ? 1 - k : k].n;
            EXPECT_NEAR(std::abs(dot(n[k], own)), 1, 1e-6) << i;
            EXPECT_NEAR(squared_norm(n[k]), 1, 2e-6) << i;
        }
        EXPECT_NEAR(dot(n[0], n[1]), 0, 2e-6) << i;
        for (const float q : small.q) EXPECT_LE(std::abs(q), 0.7072f) << i;
    }
}

template <class Codec>
void expect_that_children_hold(double growth) {
    using V = typename Codec::Volume;
    Random random(82);
    for (int i = 0; i < 3'000; ++i) {
        const double size = std::ldexp(1.0, static_cast<int>(random.below(40)) - 20);
        std::vector<V> children(1 + random.below(Codec::width));
        double reach = 0;
        const Vec3 origin = size * random_point(random);
        for (V& scb : children) {
            scb = some_volume<V>(random, size);
            reach = std::max(reach, scb.r + (scb.c - origin).cwiseAbs().maxCoeff());
        }
        Codec codec;
        codec.encode(children, origin);
        for (std::size_t k = 0; k < children.size(); ++k) {
            const auto decoded = codec.decode(k);
            for (int sample = 0; sample < 8; ++sample)
                ASSERT_TRUE(contains(decoded, point_of(children[k], random) - origin)) << i;
            ASSERT_LT(static_cast<double>(decoded.r), children[k].r + growth * reach);
        }
    }
}

TEST(NodeCodec, FloatsHoldTheVolumes) {
    expect_that_children_hold<FloatCodec<8>>(1e-6);
    expect_that_children_hold<FloatCodec<8, Scb2>>(1e-6);
}
TEST(NodeCodec, QuantizedOnesHoldTheVolumes) {
    expect_that_children_hold<QuantizedCodec<4>>(2e-4);
    expect_that_children_hold<QuantizedCodec<4, Scb2>>(2e-4);
}

TEST(NodeCodec, ThinSlabsStayThin) {
    const Scb scb{{0.3, 0.1, 0.2}, 0.5, {0, 0.6, 0.8}, 1e-7, -1e-7};
    FloatCodec<2> floats;
    floats.encode(std::span(&scb, 1), Vec3::Zero());
    EXPECT_LT(floats.decode(0).h, 2e-7f);
    QuantizedCodec<2> quantized;
    quantized.encode(std::span(&scb, 1), Vec3::Zero());
    EXPECT_LT(quantized.decode(0).h, 4e-5f) << "a normal is off by some 2^-16";
    const Scb2 needle{
        {0.3, 0.1, 0.2}, 0.5, {Slab{{0, 0.6, 0.8}, 1e-7, -1e-7}, Slab{{1, 0, 0}, 1e-6, -1e-6}}};
    FloatCodec<2, Scb2> two_floats;
    two_floats.encode(std::span(&needle, 1), Vec3::Zero());
    EXPECT_LT(two_floats.decode(0).h[0], 4e-7f);
    QuantizedCodec<2, Scb2> two_quantized;
    two_quantized.encode(std::span(&needle, 1), Vec3::Zero());
    EXPECT_LT(two_quantized.decode(0).h[1], 8e-5f) << "twice the error of a quaternion";
}

TEST(NodeCodec, BytesForEachVolume) {
    EXPECT_EQ(sizeof(FloatCodec<8>), 8 * 36u);
    EXPECT_EQ(sizeof(QuantizedCodec<8>), 8 * 18u + 8);
    EXPECT_EQ(sizeof(FloatCodec<8, Scb2>), 8 * 44u);
    EXPECT_EQ(sizeof(QuantizedCodec<8, Scb2>), 8 * 22u + 12);
}

}  // namespace
}  // namespace scb
