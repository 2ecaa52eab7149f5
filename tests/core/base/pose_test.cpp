#include "scb/pose.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/portable_math.h"
#include "scb/error.h"

namespace scb {
namespace {

Pose turned_about_z(double degrees, const Vec3& translation) {
    const SinCos a = sin_cos_degrees(degrees);
    Pose pose{Mat3::Identity(), translation};
    pose.rotation << a.cos, -a.sin, 0, a.sin, a.cos, 0, 0, 0, 1;
    return pose;
}

TEST(RelativePose, TakesPointsOfBToTheFrameOfA) {
    const Pose a = turned_about_z(30, {1, 2, 3}), b = turned_about_z(75, {-1, 0, 2});
    const Pose relative = relative_pose(a, b);
    const Vec3 p(0.3, -0.7, 0.2);
    const Vec3 back = transform_point(a, transform_point(relative, p));
    EXPECT_LT((back - transform_point(b, p)).norm(), 1e-15);
}

TEST(CheckRigid, RefusesScaledMirroredAndNonFinitePoses) {
    EXPECT_NO_THROW(check_rigid(turned_about_z(33, {5, 5, 5}), "body B"));
    Pose scaled = turned_about_z(33, Vec3::Zero());
    scaled.rotation *= 1.001;
    EXPECT_THROW(check_rigid(scaled, "body B"), InputError);
    Pose mirrored;
    mirrored.rotation(0, 0) = -1;
    EXPECT_THROW(check_rigid(mirrored, "body B"), InputError);
    Pose broken;
    broken.translation[1] = std::nan("");
    EXPECT_THROW(check_rigid(broken, "body B"), InputError);
    try {
        check_rigid(scaled, "body B");
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("body B: the pose is not rigid"),
                  std::string::npos);
    }
}

}  // namespace
}  // namespace scb
