#include "scb/scb2.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "core/volumes/scb2_reach.h"
#include "scb/scb.h"
#include "tests/core/overlap/scb2_pairs.h"

namespace scb {
namespace {

/// What is left of the sphere of radius r, and of the volume, by a sum over heights along the first
/// normal: of each circle the arc, of each disc the strip, that is within the second slab.
struct Sums {
    double sphere = 0, volume = 0;
};
Sums sums_of(const Scb2& s) {
    const Slab &first = s.slabs[0], &second = s.slabs[1];
    const auto in_strip = [&](double radius) {
        const auto part = [radius](double k) {
            return std::acos(std::clamp(k / radius, -1.0, 1.0));
        };
        const auto segment = [&](double k) {
            const double half_chord = std::sqrt(std::max(0.0, radius * radius - k * k));
            return radius * radius * part(k) - k * half_chord;
        };
        return std::pair(
            2 * (std::numbers::pi - part(second.e) - part(-second.f)),
            std::numbers::pi * radius * radius - segment(second.e) - segment(-second.f));
    };
    Sums sums;
    constexpr int n = 400000;
    const double step = (first.e - first.f) / n;
    for (int i = 0; i < n; ++i) {
        const double h = first.f + (i + 0.5) * step;
        const auto [arc, area] = in_strip(std::sqrt(s.r * s.r - h * h));
        sums.sphere += s.r * arc * step;
        sums.volume += area * step;
    }
    return sums;
}

TEST(Scb2, FacesAndVolumeAreThoseOfSums) {
    Random random(11);
    for (int i = 0; i < 40; ++i) {
        const Scb2 s = random_scb2(random);
        const Sums sums = sums_of(s);
        EXPECT_NEAR(faces(s).sphere, sums.sphere, 1e-6 * s.r * s.r) << i;
        EXPECT_NEAR(volume(s), sums.volume, 1e-9 * s.r * s.r * s.r) << i;
        // Either slab may be the first.
        Scb2 exchanged = s;
        std::swap(exchanged.slabs[0], exchanged.slabs[1]);
        EXPECT_NEAR(surface_area(exchanged), surface_area(s), 1e-13 * s.r * s.r);
        EXPECT_NEAR(volume(exchanged), volume(s), 1e-13 * s.r * s.r * s.r);
    }
}

TEST(Scb2, FacesAndVolumeOfSlabsBesideTheCenterAreThoseOfSums) {
    Random random(13);
    for (int i = 0; i < 40; ++i) {
        Scb2 s = random_scb2(random);
        for (Slab& slab : s.slabs) {
            const double p = random.uniform(-s.r, s.r), q = random.uniform(-s.r, s.r);
            slab.f = std::min(p, q);
            slab.e = std::max(p, q);
        }
        const Sums sums = sums_of(s);
        EXPECT_NEAR(faces(s).sphere, sums.sphere, 1e-6 * s.r * s.r) << i;
        EXPECT_NEAR(volume(s), sums.volume, 1e-8 * s.r * s.r * s.r) << i;
    }
}

TEST(Scb2, WithASlabThatDoesNotCutIsAnScb) {
    Random random(12);
    for (int i = 0; i < 200; ++i) {
        Scb2 s = random_scb2(random);
        s.slabs[1].e = s.r;
        s.slabs[1].f = -s.r;
        const Scb one{s.c, s.r, s.slabs[0].n, s.slabs[0].e, s.slabs[0].f};
        EXPECT_NEAR(surface_area(s), surface_area(one), 1e-13 * s.r * s.r);
        EXPECT_NEAR(volume(s), volume(one), 1e-13 * s.r * s.r * s.r);
        for (int k = 0; k < 20; ++k) {
            const Vec3 d = random_unit_vector(random);
            EXPECT_NEAR(support(s, d), support(one, d), 1e-14 * s.r);
            std::swap(s.slabs[0], s.slabs[1]);
        }
    }
}

TEST(Scb2, ContainsItsSupportPointsAndNothingBeyond) {
    Random random(13);
    for (int i = 0; i < 2000; ++i) {
        const Scb2 s = random_scb2(random);
        ASSERT_TRUE(is_well_formed(s));
        const Vec3 d = random_unit_vector(random);
        const double reach = support(s, d);
        // No point of it is farther, and one is as far.
        for (int k = 0; k < 300; ++k) {
            const Vec3 point =
                pulled_into(s, s.c + s.r * (k == 0 ? d : random_unit_vector(random)));
            if (!contains(s, point)) continue;
            EXPECT_LE(dot(d, point - s.c), reach * (1 + 1e-15) + 1e-15 * s.r);
        }
        const Vec3 best = farthest_point(s, d);
        EXPECT_NEAR(dot(d, best), reach, 1e-14 * s.r);
        Scb2 grown = s;
        grown.r *= 1 + 1e-13;
        for (Slab& slab : grown.slabs) {
            slab.e += 1e-13 * s.r;
            slab.f -= 1e-13 * s.r;
        }
        EXPECT_TRUE(contains(grown, s.c + best));
    }
}

TEST(Scb2, IsNotWellFormedWithoutItsInvariants) {
    Random random(14);
    const Scb2 s = random_scb2(random);
    ASSERT_TRUE(is_well_formed(s));
    const auto broken = [&](auto change) {
        Scb2 copy = s;
        change(copy);
        return is_well_formed(copy);
    };
    EXPECT_FALSE(broken([](Scb2& c) { c.slabs[0].e = -1e-300; }));
    EXPECT_FALSE(broken([](Scb2& c) { c.slabs[1].f = 1e-300; }));
    EXPECT_FALSE(broken([](Scb2& c) { c.slabs[1].e = c.r * (1 + 1e-15); }));
    EXPECT_FALSE(broken([](Scb2& c) { c.slabs[0].f = -c.r * (1 + 1e-15); }));
    EXPECT_FALSE(broken([](Scb2& c) { c.slabs[1].n *= 1 + 1e-14; }));
    EXPECT_FALSE(broken([](Scb2& c) {
        c.slabs[1].n += 1e-14 * c.slabs[0].n;
        c.slabs[1].n.normalize();
    }));
    EXPECT_FALSE(broken([](Scb2& c) { c.slabs[0].e = NAN; }));
    EXPECT_FALSE(broken([](Scb2& c) { c.c[1] = HUGE_VAL; }));
    EXPECT_FALSE(broken([](Scb2& c) { c.r = -1; }));
}

}  // namespace
}  // namespace scb
