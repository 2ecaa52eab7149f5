#include "golden/suite/case_command.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "tests/temporary_folder.h"

namespace scb::golden {
namespace {

using Words = std::vector<std::string>;

GoldenCase sample() {
    GoldenCase golden;
    golden.name = "sample";
    golden.run = GoldenRun::rejections;
    golden.own_scene = {"a.ply", "b.ply"};
    golden.own_arguments = {"--camera", "front.json", "--margin=0.5",           "--by",
                            "first",    "--pose",     "1,0,0,0,0,1,0,0,0,0,1,0"};
    golden.volume = "scb";
    golden.test = "extents";
    return golden;
}

TEST(CaseCommand, DrawsOnePictureWithIdsOrPrintsJson) {
    GoldenCase golden = in_own_folder(sample());
    golden.frames = "3";
    EXPECT_EQ(command_of(golden, "DIR"), (Words{"render",
                                                "rejections",
                                                "a.ply",
                                                "b.ply",
                                                "--frames",
                                                "3",
                                                "--volume",
                                                "scb",
                                                "--test",
                                                "extents",
                                                "--camera",
                                                "front.json",
                                                "--margin=0.5",
                                                "--by",
                                                "first",
                                                "--pose",
                                                "1,0,0,0,0,1,0,0,0,0,1,0",
                                                "--size",
                                                "320x240",
                                                "--samples",
                                                "1",
                                                "--ids",
                                                "--usual-direction",
                                                "--jobs",
                                                "1",
                                                "-o",
                                                "DIR"}));
    golden.run = GoldenRun::collide;
    const Words command = command_of(golden, "DIR");
    EXPECT_EQ(command.front(), "collide");
    EXPECT_EQ(command.back(), "--json");
}

TEST(CaseCommand, ATraceIsOfTheQueryAlone) {
    EXPECT_EQ(
        trace_command_of(in_own_folder(sample()), "7", "t.scbrec"),
        (Words{"trace", "a.ply", "b.ply", "--frames", "7", "--volume", "scb", "--test", "extents",
               "--margin=0.5", "--pose", "1,0,0,0,0,1,0,0,0,0,1,0", "-o", "t.scbrec"}));
}

TEST(CaseCommand, ATraceOfADistanceHasItsKindAndLimits) {
    GoldenCase golden = sample();
    golden.run = GoldenRun::distance;
    golden.volume = golden.test = "";
    golden.own_arguments = {"--within", "0.5", "--first", "--order=nearest", "--prove"};
    EXPECT_EQ(trace_command_of(in_own_folder(golden), "7", "t.scbrec"),
              (Words{"trace", "a.ply", "b.ply", "--frames", "7", "--kind", "distance", "--within",
                     "0.5", "--first", "--order=nearest", "-o", "t.scbrec"}));
    golden.run = GoldenRun::traversal;
    golden.own_arguments = {"--kind", "distance", "--show", "both", "--limit", "2"};
    EXPECT_EQ(trace_command_of(in_own_folder(golden), "7", "t.scbrec"),
              (Words{"trace", "a.ply", "b.ply", "--frames", "7", "--kind", "distance", "--limit",
                     "2", "-o", "t.scbrec"}));
}

TEST(CaseCommand, FilesAreBesideTheSuiteOrElseAmongTheModels) {
    const TemporaryFolder suite, models;
    suite.write("a.ply", "");
    suite.write("front.json", "");
    models.write("a.ply", "");
    models.write("b.ply", "");
    const GoldenCase here = seen_from_here(sample(), suite.path, models.path);
    EXPECT_EQ(here.scene, (Words{suite / "a.ply", models / "b.ply"}));
    EXPECT_EQ(here.arguments[1], suite / "front.json");
    EXPECT_EQ(here.arguments[4], "first");
    EXPECT_EQ(in_own_folder(here).scene, sample().own_scene);
    EXPECT_EQ(in_own_folder(here).arguments, sample().own_arguments);
    // What is nowhere is beside the suite, where it is missed.
    EXPECT_EQ(seen_from_here(sample(), suite.path, "").scene,
              (Words{suite / "a.ply", suite / "b.ply"}));
}

TEST(CaseCommand, ABuiltInSceneIsNoFile) {
    GoldenCase golden = sample();
    golden.own_scene = {"cone"};
    EXPECT_EQ(seen_from_here(golden, "my", "models").scene, Words{"cone"});
}

TEST(CaseCommand, AFileThatLooksLikeAnOptionIsNone) {
    GoldenCase golden = sample();
    golden.own_scene = {"-o.ply"};
    EXPECT_EQ(seen_from_here(golden, "", "").scene, Words{"./-o.ply"});
}

std::string said_by_shell(const std::string& word) {
    std::FILE* pipe = ::popen(("printf %s " + word).c_str(), "r");
    std::string text;
    for (int c; pipe != nullptr && (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
    if (pipe != nullptr) ::pclose(pipe);
    return text;
}

TEST(ShellWord, IsTakenByAShellForTheText) {
    for (const char* text : {"plain", "two words", "it's", "''", "$HOME `ls` \"x\" \\n",
                             "*?[a]~#;&|<>()!", "line\nbreak", "\xc3\xa9", "-x", "a=b", "~"})
        EXPECT_EQ(said_by_shell(shell_word(text)), text);
}

TEST(ShellWord, IsQuotedOnlyWhereItMustBe) {
    for (const char* text : {"levels", "320x240", "golden/scenes/a_b.json", "0:499:10", "1,0,-0.5",
                             "--margin=0.01", "a@b+c%d"})
        EXPECT_EQ(shell_word(text), text);
    EXPECT_EQ(shell_word(""), "''");
    EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
}

}  // namespace

}  // namespace scb::golden
