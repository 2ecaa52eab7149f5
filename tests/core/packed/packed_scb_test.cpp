#include "scb/packed_scb.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/packed/grown_scb.h"
#include "scb/node_codec.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {
namespace {

TEST(FloatAbove, IsTheSmallestThatIsNoLess) {
    EXPECT_EQ(float_above(1.0), 1.0f);
    EXPECT_EQ(float_above(1 + 0x1p-52), 1 + 0x1p-23f);
    EXPECT_EQ(float_above(-1 - 0x1p-52), -1.0f);
    EXPECT_EQ(float_above(0), 0.0f);
    EXPECT_EQ(float_above(1e-300), std::numeric_limits<float>::denorm_min());
}

Scb some_scb(Random& random, double size) {
    Scb scb;
    scb.c = size * random_point(random);
    scb.r = size * random.uniform(0.01, 1);
    scb.n = random_unit_vector(random);
    // Thin ones too.
    const double thin = random.below(2) == 0 ? 1 : 1e-5;
    scb.e = thin * scb.r * random.uniform();
    scb.f = -thin * scb.r * random.uniform();
    return scb;
}

/// A point in the volume, most often on its surface.
Vec3 point_of(const Scb& scb, Random& random) {
    const double along = random.below(3) == 0   ? scb.e
                         : random.below(2) == 0 ? scb.f
                                                : scb.f + (scb.e - scb.f) * random.uniform();
    Vec3 side = cross(scb.n, random_unit_vector(random));
    side /= std::sqrt(squared_norm(side));
    const double far = std::sqrt(std::max(0.0, scb.r * scb.r - along * along));
    return scb.c + along * scb.n + (1 - 1e-15) * far * side;
}

TEST(PackedScb, HoldsTheWholeVolume) {
    Random random(81);
    for (int i = 0; i < 20'000; ++i) {
        const Scb scb = some_scb(random, std::ldexp(1.0, static_cast<int>(random.below(40)) - 20));
        const Vec3 origin = scb.c + scb.r * random_point(random);
        const PackedScb small = packed(scb, origin);
        for (int k = 0; k < 8; ++k)
            ASSERT_TRUE(contains(small, point_of(scb, random) - origin)) << i;
        ASSERT_LT(static_cast<double>(small.r), scb.r * (1 + 1e-6));
        ASSERT_LT(2 * static_cast<double>(small.h), scb.e - scb.f + 1e-6 * scb.r);
    }
}

template <class Codec>
void expect_that_children_hold(double growth) {
    Random random(82);
    for (int i = 0; i < 3'000; ++i) {
        const double size = std::ldexp(1.0, static_cast<int>(random.below(40)) - 20);
        std::vector<Scb> children(1 + random.below(Codec::width));
        double reach = 0;
        const Vec3 origin = size * random_point(random);
        for (Scb& scb : children) {
            scb = some_scb(random, size);
            reach = std::max(reach, scb.r + (scb.c - origin).cwiseAbs().maxCoeff());
        }
        Codec codec;
        codec.encode(children, origin);
        for (std::size_t k = 0; k < children.size(); ++k) {
            const PackedScb decoded = codec.decode(k);
            for (int sample = 0; sample < 8; ++sample)
                ASSERT_TRUE(contains(decoded, point_of(children[k], random) - origin)) << i;
            ASSERT_LT(static_cast<double>(decoded.r), children[k].r + growth * reach);
        }
    }
}

TEST(NodeCodec, FloatsHoldTheVolumes) { expect_that_children_hold<FloatCodec<8>>(1e-6); }
TEST(NodeCodec, QuantizedOnesHoldTheVolumes) { expect_that_children_hold<QuantizedCodec<4>>(2e-4); }

TEST(NodeCodec, ThinSlabsStayThin) {
    const Scb scb{{0.3, 0.1, 0.2}, 0.5, {0, 0.6, 0.8}, 1e-7, -1e-7};
    FloatCodec<2> floats;
    floats.encode(std::span(&scb, 1), Vec3::Zero());
    EXPECT_LT(floats.decode(0).h, 2e-7f);
    QuantizedCodec<2> quantized;
    quantized.encode(std::span(&scb, 1), Vec3::Zero());
    EXPECT_LT(quantized.decode(0).h, 4e-5f) << "a normal is off by some 2^-16";
}

TEST(NodeCodec, BytesForEachVolume) {
    EXPECT_EQ(sizeof(FloatCodec<8>), 8 * 36u);
    EXPECT_EQ(sizeof(QuantizedCodec<8>), 8 * 18u + 8);
}

}  // namespace
}  // namespace scb
