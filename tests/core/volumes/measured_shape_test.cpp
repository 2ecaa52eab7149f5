#include "core/volumes/measured_shape.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/core/fit/point_sets.h"
#include "tests/core/hierarchy/built_mesh.h"
#include "tests/unless_sanitized.h"

namespace scb {
namespace {

/// A volume of every type about the same points.
const BuiltMesh& soup() {
    static const BuiltMesh built(random_soup(1, 40, 0.4));
    return built;
}

/// Calls `check(volume)` with every volume of every kind.
template <class Check>
void for_each_volume(Check&& check) {
    for (const AnyHierarchy& any : soup().hierarchies)
        std::visit(
            [&](const auto& h) {
                for (const auto& v : h.volumes) check(v);
            },
            any);
}

TEST(MeasuredShape, BoxHoldsAndTouchesItsVolume) {
    Random random(2);
    for_each_volume([&](const auto& v) {
        const Obb box = box_about(v);
        const double slack = 1e-12 * diameter(v);
        for (int i = 0; i < 3; ++i) {
            const Vec3 axis = box.axes.col(i);
            const double middle = dot(axis, box.center - support_center(v));
            EXPECT_NEAR(support(v, axis), middle + box.half[i], slack);
            EXPECT_NEAR(support(v, Vec3(-axis)), box.half[i] - middle, slack);
        }
    });
}

TEST(MeasuredShape, GrownVolumesHoldWhatTheyHeld) {
    Random random(3);
    for_each_volume([&](const auto& v) {
        const auto larger = enlarged(v, 0.01);
        for (int i = 0; i < 20; ++i) {
            const Vec3 p = 1.2 * random_point(random);
            EXPECT_TRUE(!contains(v, p) || contains(larger, p));
        }
    });
}

// Slab cut balls have no formula here: points of the line say it, where the volume is thick enough
// for their steps.
TEST(MeasuredShape, LinesMeetAVolumeWhereOneOfTheirPointsIsInIt) {
    Random random(4);
    constexpr int lines = unless_sanitized(100, 10);
    int met = 0, missed = 0;
    for_each_volume([&](const auto& v) {
        if constexpr (requires { v.c; }) {
            if (thickness(v) < 0.05 * diameter(v)) return;
            const auto larger = enlarged(v, 1e-3 * diameter(v));
            for (int i = 0; i < lines; ++i) {
                const Vec3 along = random_unit_vector(random);
                const Vec3 point =
                    v.c + diameter(v) * random.uniform() / 2 * random_unit_vector(random);
                bool in_it = false, near_it = false;
                for (int step = -1000; step <= 1000; ++step) {
                    const Vec3 p = point + along * (step * diameter(v) / 1000);
                    in_it |= contains(v, p);
                    near_it |= contains(larger, p);
                }
                const bool meets = line_meets(v, point, along);
                EXPECT_TRUE(meets || !in_it);
                EXPECT_TRUE(near_it || !meets);
                ++(meets ? met : missed);
            }
        }
    });
    EXPECT_GT(met, 10 * lines);
    EXPECT_GT(missed, 10 * lines);
}

/// Whether the line meets the box, by slabs.
bool meets_box(const Obb& box, const Vec3& point, const Vec3& along) {
    double first = -std::numeric_limits<double>::infinity(), last = -first;
    for (int i = 0; i < 3; ++i) {
        const Vec3 axis = box.axes.col(i);
        const double p = dot(axis, point - box.center), d = dot(axis, along);
        const double t0 = (-box.half[i] - p) / d, t1 = (box.half[i] - p) / d;
        first = std::max(first, std::min(t0, t1));
        last = std::min(last, std::max(t0, t1));
    }
    return first <= last;
}

TEST(MeasuredShape, LinesMeetBoxesAndBallsAsTheirFormulasSay) {
    Random random(5);
    int different = 0, met = 0, lines = 0;
    for_each_volume([&](const auto& v) {
        for (int i = 0; i < 100; ++i) {
            const Vec3 along = random_unit_vector(random);
            const Vec3 point =
                support_center(v) + diameter(v) * random.uniform() * random_unit_vector(random);
            const auto& shape = shape_of(v);
            bool meets;
            if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Obb>)
                meets = meets_box(shape, point, along);
            else if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Ball>)
                meets =
                    squared_norm(cross(along, point - shape.center)) <= shape.radius * shape.radius;
            else
                return;
            ++lines;
            met += meets;
            different += meets != line_meets(v, point, along);
        }
    });
    EXPECT_GT(lines, 30000);
    EXPECT_GT(met, lines / 10);
    // Those that pass by less than the search resolves.
    EXPECT_LE(different, lines / 10000);
}

}  // namespace
}  // namespace scb
