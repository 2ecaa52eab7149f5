#include <gtest/gtest.h>

#include "tests/app/program.h"
#include "tests/app/reference/shell.h"

namespace scb::app {
namespace {

using Words = std::set<std::string>;

struct Case {
    std::string line;
    Words offered;
};

class Completion : public testing::TestWithParam<const char*> {
  protected:
    void SetUp() override {
        if (!Shell::is_installed(GetParam()))
            GTEST_SKIP() << GetParam() << " is not installed; install it to test its completion.";
        for (const char* name : {"part.stl", "part.txt", "part.json", "lift.scbrec", "pump.scbrec",
                                 "my gear.ply", "page.html"})
            folder.write(name, "");
        std::filesystem::create_directory(folder.path / "parts");
        shell.emplace(GetParam(), folder.path.string());
    }

    void check(const std::vector<Case>& cases) {
        for (const auto& [line, offered] : cases) EXPECT_EQ(shell->offers(line), offered) << line;
    }

    TemporaryFolder folder;
    std::optional<Shell> shell;
};

TEST_P(Completion, OffersCommands) {
    check({{"scb ren", {"render"}},
           {"scb render ", {"distance", "levels", "pairs", "rejections", "traversal"}},
           {"scb golden se", {"selftest"}},
           // Neither an option nor its value is a command.
           {"scb --quiet --color always ren", {"render"}},
           {"scb golden check --suite list --ju", {"--junit"}}});
}

TEST_P(Completion, OffersTheOptionsOfTheCommand) {
    check({{"scb collide cone --thr", {"--threshold"}},
           {"scb export cone --seg", {"--segments"}},
           {"scb render levels cone --qui", {"--quiet"}},
           {"scb export cone --thr", {}},
           {"scb render levels --mut", {}}});
}

TEST_P(Completion, OffersValues) {
    check({{"scb --color ", {"auto", "always", "never"}},
           {"scb collide cone --descent ", {"radius", "area", "volume", "alternating"}},
           {"scb render levels cone --camera orb", {"orbit:"}},
           {"scb render levels cone --samples ", {"1", "4"}},
           {"scb completion ", {"bash", "zsh", "fish"}}});
}

TEST_P(Completion, OffersTheWordBehindTheLastComma) {
    check({{"scb stats cone --volume scb,cap", {"scb,capsule"}},
           {"scb stats cone --volume scb2,dop14,rit", {"scb2,dop14,ritter"}},
           {"scb bench --layout reference,refe", {}},
           // No list.
           {"scb collide cone --volume scb,cap", {}}});
    const std::string equal = "scb stats cone --volume=scb,cap";
    const Words completed = shell->offers(equal);
    EXPECT_TRUE(completed == Words{"--volume=scb,capsule"} || completed == Words{"scb,capsule"})
        << testing::PrintToString(completed);
}

TEST_P(Completion, OffersScenesAndFilesOfTheirKind) {
    check({{"scb stats spheres-l", {"spheres-l1", "spheres-l2"}},
           {"scb stats par", {"part.stl", "part.json", "parts"}},
           {"scb scenes cone", {"cone"}},
           {"scb diff p", {"pump.scbrec", "parts"}},
           {"scb diff lift.scbrec pum", {"pump.scbrec"}},
           {"scb stats cone --models p", {"parts"}},
           {"scb explain --pairs pa", {"part.json", "parts"}},
           {"scb view cone -o pag", {"page.html"}},
           {"scb golden report --from part.json pa", {"part.json", "parts"}},
           {"scb stats my", {"my gear.ply"}}});
}

INSTANTIATE_TEST_SUITE_P(Shells, Completion, testing::Values("bash", "zsh", "fish"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace scb::app
