#include "scb/pose.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/portable_math.h"
#include "core/base/random.h"
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

TEST(NearestRigid, TakesTheNearestRotation) {
    const Pose exact = turned_about_z(33, {5, -6, 7});
    EXPECT_EQ(nearest_rigid(exact, "B").correction, 0);
    EXPECT_EQ(nearest_rigid(exact, "B").pose.rotation, exact.rotation);
    Random random(3);
    for (const double error : {0x1p-25, 1e-6, 1e-4}) {
        Pose rough = exact;
        for (int i = 0; i < 9; ++i) rough.rotation.data()[i] += error * (2 * random.uniform() - 1);
        const NearestPose nearest = nearest_rigid(rough, "B");
        EXPECT_LT(rigidity_defect(nearest.pose), 1e-15);
        EXPECT_EQ(nearest.pose.translation, exact.translation);
        EXPECT_LE(nearest.correction, 2 * error);
        EXPECT_GT(nearest.correction, 0);
        // Of the nearest, R^T M is symmetric.
        const Mat3 product = nearest.pose.rotation.transpose() * rough.rotation;
        EXPECT_LT((product - product.transpose()).cwiseAbs().maxCoeff(), 1e-15);
    }
}

TEST(NearestRigid, RefusesWhatIsNoRotation) {
    const auto with = [](double scale, double shear) {
        Pose pose = turned_about_z(33, Vec3::Zero());
        pose.rotation *= scale;
        pose.rotation.col(0) += shear * pose.rotation.col(1);
        return pose;
    };
    EXPECT_NO_THROW(nearest_rigid(with(1.0004, 0), "B"));
    EXPECT_THROW(nearest_rigid(with(1.0006, 0), "B"), InputError);
    EXPECT_NO_THROW(nearest_rigid(with(1, 0.0009), "B"));
    EXPECT_THROW(nearest_rigid(with(1, 0.0011), "B"), InputError);
    EXPECT_THROW(nearest_rigid(with(-1, 0), "B"), InputError);
    EXPECT_THROW(nearest_rigid(with(std::nan(""), 0), "B"), InputError);
}

}  // namespace
}  // namespace scb
