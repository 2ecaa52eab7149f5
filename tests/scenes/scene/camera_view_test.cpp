#include "scenes/scene/camera_view.h"

#include <nlohmann/json.hpp>

#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

TEST(CameraOption, ReadsFitAndOrbit) {
    EXPECT_EQ(parse_camera("fit").azimuth, 30);
    EXPECT_FALSE(parse_camera("fit").distance);
    const CameraView camera = parse_camera("orbit:-45.5,10");
    EXPECT_EQ(camera.azimuth, -45.5);
    EXPECT_EQ(camera.elevation, 10);
    EXPECT_FALSE(camera.distance);
    EXPECT_EQ(parse_camera("orbit:0,90,2.5").distance, 2.5);
    EXPECT_EQ(parse_camera("orbit:0,90,2.5,1,-2,3e2").target, Vec3(1, -2, 300));
}

TEST(CameraOption, RefusesWhatIsNotACamera) {
    expect_in("two, three or six numbers", refusal([] { parse_camera("orbit:1"); }));
    expect_in("two, three or six numbers", refusal([] { parse_camera("orbit:1,2,3,4"); }));
    expect_in("number 2 cannot be read", refusal([] { parse_camera("orbit:1,x"); }));
    expect_in("number 1 cannot be read", refusal([] { parse_camera("orbit:"); }));
    expect_in("number 1 cannot be read", refusal([] { parse_camera("orbit:nan,2"); }));
    expect_in("comma is expected after number 2", refusal([] { parse_camera("orbit:1,2deg"); }));
    expect_in("elevation must be", refusal([] { parse_camera("orbit:1,91"); }));
    expect_in("distance must be", refusal([] { parse_camera("orbit:1,2,-3"); }));
    expect_in("target must be", refusal([] { parse_camera("orbit:1,2,3,4,5,1e300"); }));
    expect_in("distance must be above 0 and at most 1e+",
              refusal([] { parse_camera("orbit:1,2,1e300"); }));
    expect_in("this is not a camera", refusal([] { parse_camera("frnot"); }));
    expect_in("there is no such file", refusal([] { parse_camera("gone/camera.json"); }));
}

TEST(CameraJson, ComesBackAsItWasWritten) {
    CameraView camera;
    camera.azimuth = 0.1;
    camera.distance = 1.0 / 3;
    camera.target = Vec3(1, 2, 3);
    camera.up = Vec3(0, 1, 0);
    camera.orthographic = true;
    camera.view_height = 4;
    camera.inset = Inset{{-0.025, 0, 0}, 0.12};
    camera.clip = FacePlane{{0, 1, -2}, 0.1};
    const CameraView again = parse_camera_json(camera_json(camera).dump(), "again");
    EXPECT_EQ(camera_json(again), camera_json(camera));
    EXPECT_EQ(again.azimuth, 0.1);
    EXPECT_EQ(again.distance, 1.0 / 3);
    EXPECT_EQ(*again.target, Vec3(1, 2, 3));
    EXPECT_EQ(again.inset->center, Vec3(-0.025, 0, 0));
    EXPECT_EQ(again.inset->radius, 0.12);
    EXPECT_EQ(again.clip->normal, Vec3(0, 1, -2));
    EXPECT_EQ(again.clip->offset, 0.1);
}

TEST(CameraJson, IsReadFromAFileWithPlacesInErrors) {
    const TemporaryFolder folder;
    const std::string good = folder.write("camera.json", R"({"azimuth": 10, "field_of_view": 50})");
    EXPECT_EQ(parse_camera(good).azimuth, 10);
    EXPECT_EQ(parse_camera(good).field_of_view, 50);
    const std::string bad = folder.write("bad.json", R"({"up": [0, 0, 0]})");
    expect_in(bad + ": up: expected three numbers that are not all zero, found [0,0,0].",
              refusal([&] { parse_camera(bad); }));
    expect_in("field_of_view: expected a number from 1 to 170",
              refusal([] { parse_camera_json(R"({"field_of_view": 180})", "c"); }));
    expect_in("clip.normal: expected three numbers that are not all zero", refusal([] {
                  parse_camera_json(R"({"clip": {"normal": [0, 0, 0], "offset": 1}})", "c");
              }));
    expect_in("clip: the field \"offset\" is missing",
              refusal([] { parse_camera_json(R"({"clip": {"normal": [0, 0, 1]}})", "c"); }));
    expect_in("inset: the field \"radius\" is missing",
              refusal([] { parse_camera_json(R"({"inset": {"center": [0, 0, 0]}})", "c"); }));
}

TEST(CameraJson, IsTakenOutOfAnIndex) {
    const TemporaryFolder folder;
    const std::string good = folder.write(
        "index.json",
        R"({"program": "scb", "camera": {"azimuth": 10, "distance": 2}, "levels": [1]})");
    EXPECT_EQ(parse_camera(good).azimuth, 10);
    EXPECT_EQ(parse_camera(good).distance, 2);
    expect_in("i.json: camera.azimuth: expected a number, found \"x\".",
              refusal([] { parse_camera_json(R"({"camera": {"azimuth": "x"}})", "i.json"); }));
    expect_in("i.json: camera: unknown field \"camera\"",
              refusal([] { parse_camera_json(R"({"camera": {"camera": {}}})", "i.json"); }));
    expect_in("i.json: camera: expected an object, found 3.",
              refusal([] { parse_camera_json(R"({"camera": 3})", "i.json"); }));
    expect_in("i.json: unknown field \"levels\"",
              refusal([] { parse_camera_json(R"({"levels": [1]})", "i.json"); }));
}

}  // namespace
}  // namespace scb::scenes
