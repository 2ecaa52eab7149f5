#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <ostream>

#include "render/image_file.h"
#include "render/output_file.h"
#include "tests/app/program.h"

namespace scb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct BaselineCase {
    const char* name;
    const char* arguments;
};

void PrintTo(const BaselineCase& tested, std::ostream* out) { *out << tested.name; }

// Small pictures with one sample; what each is there for.
constexpr BaselineCase cases[] = {
    {"levels-spheres-scb",
     "spheres-l1 --volume scb --levels 7"},  // slab cuts, two bodies, a detail
    {"levels-cylinder-obb",
     "thin-cylinder --volume obb --levels 4 --background dark"},  // boxes, long thin triangles
    // the scales of color, one body, orthographic
    {"levels-cone-radius", "cone --volume scb --levels leaves --color-by radius --ortho"},
    {"levels-soup-thickness",
     "soup --volume scb --levels 8 --color-by thickness --camera orbit:20,30"},
    {"levels-knots-translucent",
     "knots-l1 --volume ball --levels 6 --opacity 0.5 --edges"},  // blending, meshes
};

const fs::path folder_of_baselines = fs::path(SCB_SOURCE_DIR) / "golden" / "baselines";

// The first pixels that differ, in words.
std::string difference(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height) return "the sizes differ";
    int count = 0;
    std::string first;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            if (!(pixel(a, x, y) == pixel(b, x, y)) && count++ == 0)
                first = "first at (" + std::to_string(x) + ", " + std::to_string(y) + ")";
    return count == 0 ? "" : std::to_string(count) + " pixels differ, " + first;
}

class Baseline : public testing::TestWithParam<BaselineCase> {};

TEST_P(Baseline, CountsIdsAndColorsAreUnchanged) {
    const BaselineCase& baseline = GetParam();
    const TemporaryFolder folder;
    const ProgramRun run =
        run_scb(std::string("render levels ") + baseline.arguments +
                " --size 320x240 --samples 1 --ids --no-sheet -o " + folder.path.string());
    ASSERT_EQ(run.status, 0) << run.err;
    const json index = json::parse(file_text(folder / "index.json"));
    const json& file = index["files"][0];
    const std::string counts = file["bodies"].dump(2) + "\n";
    const std::string meta =
        json{{"arguments", baseline.arguments}, {"versions", index["versions"]}}.dump(2) + "\n";
    const fs::path image = folder / file["file"].get<std::string>(),
                   ids = folder / file["ids"].get<std::string>();
    const auto stored = [&](const char* ending) {
        return folder_of_baselines / (std::string(baseline.name) + ending);
    };

    if (std::getenv("SCB_UPDATE_BASELINES") != nullptr) {
        ASSERT_EQ(std::getenv("CI"), nullptr) << "baselines are not updated where CI is set";
        write_text(stored(".counts.json"), counts);
        write_text(stored(".meta.json"), meta);
        fs::copy_file(image, stored(".png"), fs::copy_options::overwrite_existing);
        fs::copy_file(ids, stored(".ids.png"), fs::copy_options::overwrite_existing);
        return;
    }
    EXPECT_EQ(counts, file_text(stored(".counts.json")));
    EXPECT_EQ(difference(read_png(ids), read_png(stored(".ids.png"))), "") << "ids";
    const json stored_versions = json::parse(file_text(stored(".meta.json")))["versions"];
    const json versions = index["versions"];
    if (versions["mesa"] == stored_versions["mesa"] && versions["llvm"] == stored_versions["llvm"])
        EXPECT_EQ(difference(read_png(image), read_png(stored(".png"))), "") << "colors";
    else
        std::fprintf(
            stderr, "%s: colors NOT compared: drawn with Mesa %s, LLVM %s, stored with %s, %s\n",
            baseline.name, versions["mesa"].dump().c_str(), versions["llvm"].dump().c_str(),
            stored_versions["mesa"].dump().c_str(), stored_versions["llvm"].dump().c_str());
}

INSTANTIATE_TEST_SUITE_P(Levels, Baseline, testing::ValuesIn(cases),
                         [](const testing::TestParamInfo<BaselineCase>& tested) {
                             std::string name = tested.param.name;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace scb
