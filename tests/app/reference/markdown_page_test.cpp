#include <gtest/gtest.h>

#include "app/reference/markdown_page.h"
#include "tests/app/program.h"

namespace scb::app {
namespace {

TEST(MarkdownPage, IsTheOneInTheManual) {
    const ProgramRun run = run_scb("reference");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.out,
              file_text(std::filesystem::path(SCB_SOURCE_DIR) / "app/reference/options.md"))
        << "The help has changed: scb reference > app/reference/options.md";
}

TEST(MarkdownPage, IsTheSameOnEachMachine) {
    EXPECT_EQ(run_scb("reference").out,
              run_scb("reference", {"", {"TZ=Asia/Tokyo", "LC_ALL=C", "COLUMNS=40"}}).out);
}

TEST(MarkdownPage, HasEachOptionAsItIsTyped) {
    ReferenceOption option;
    option.names = {"-x", "--exact"};
    option.value = "A|B";
    option.takes_value = true;
    option.help = "Whether a < b, as `a|b` says";
    option.default_text = "A";
    option.environment = "EXACT";
    ReferenceOption argument;
    argument.value = "SCENE";
    argument.help = "A scene.";
    argument.is_required = true;
    ReferenceCommand command;
    command.name = "scb try";
    command.help = "Try [it]";
    command.footer = "More.\n\nExit status: 0 done.\n\nExample:\n  scb try spheres-l1";
    command.options = {option};
    command.arguments = {argument};
    ReferenceCommand program;
    program.name = "scb";
    program.commands = {command};
    const std::string page = markdown_page(program);
    EXPECT_NE(page.find("| [`scb try`](#scb-try) | Try \\[it\\]. |\n"), std::string::npos) << page;
    const std::string section =
        "\n## scb try\n\nTry \\[it\\].\n\n`scb try [OPTION...] SCENE`\n\nMore.\n"
        "\n| argument | meaning |\n|---|---|\n| `SCENE` | A scene. |\n"
        "\n| option | meaning |\n|---|---|\n"
        "| `-x, --exact A\\|B` | Whether a \\< b, as `a\\|b` says. Default: `A`. The environment "
        "variable `EXACT` does the same. |\n"
        "\nExit status: 0 done.\n";
    EXPECT_TRUE(page.ends_with(section)) << page;
}

}  // namespace
}  // namespace scb::app
