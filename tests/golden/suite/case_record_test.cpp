#include "golden/suite/case_record.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "scb/error.h"
#include "tests/temporary_folder.h"

namespace scb::golden {
namespace {

using nlohmann::json;

const json of_a_case = json::parse(R"({
    "scene": "spheres", "test": "corrected", "threshold": 0.7, "level": null, "frames": [],
    "options": {"volume": ["scb", "obb"], "opacity": 1},
    "bodies": [{"name": "A", "triangles": 20, "vertices": 12, "hash": "00000000000000aa"}],
    "poses": {"90": {"A": [1, 0, 0, 0.1, 0, 1, 0, -2.5, 0, 0, 1, 1e-7]}}})");

TEST(CaseRecord, IsReadAsItWasWritten) {
    const TemporaryFolder folder;
    const json written = record_json("scb collide", of_a_case);
    EXPECT_EQ(written["poses"]["90"]["A"], "1 0 0 0.1 0 1 0 -2.5 0 0 1 1e-07");
    EXPECT_FALSE(written.contains("frames"));
    const CaseRecord record = read_record(folder.write("case.meta.json", written.dump()));
    EXPECT_EQ(record.command, "scb collide");
    EXPECT_EQ(record.meshes.at("A"), (RecordedMesh{20, 12, "00000000000000aa"}));
    EXPECT_EQ(record.poses.at(90).at("A").translation, Vec3(0.1, -2.5, 1e-7));
    EXPECT_EQ(record.poses.at(90).at("A").rotation, Mat3::Identity());
    EXPECT_EQ(record.settings, (std::map<std::string, std::string>{{"scene", "spheres"},
                                                                   {"volume", "scb, obb"},
                                                                   {"test", "corrected"},
                                                                   {"threshold", "0.7"},
                                                                   {"level", "none"}}));
}

TEST(CaseRecord, SaysNothingOfWhatOlderOnesDoNotHave) {
    const TemporaryFolder folder;
    EXPECT_TRUE(read_record(folder / "none.json").meshes.empty());
    const CaseRecord record = read_record(folder.write("case.meta.json", R"({"command": "scb"})"));
    EXPECT_EQ(record.command, "scb");
    EXPECT_TRUE(record.meshes.empty() && record.poses.empty() && record.settings.empty());
}

TEST(CaseRecord, IsRefusedWhereItIsNone) {
    const TemporaryFolder folder;
    for (const char* text :
         {"{", "[]", R"({"bodies": 5})", R"({"bodies": [{"name": "A"}]})", R"({"poses": [1]})",
          R"({"poses": {"x": {}}})", R"({"poses": {"0": {"A": "1 2 3"}}})",
          R"({"poses": {"0": {"A": "1 0 0 0 0 1 0 0 0 0 1 zero"}}})",
          R"({"poses": {"0": {"A": "1 0 0 0 0 1 0 0 0 0 1 0 0"}}})",
          R"({"settings": {"test": 5}})"})
        EXPECT_THROW(read_record(folder.write("case.meta.json", text)), InputError) << text;
}

}  // namespace
}  // namespace scb::golden
