#include <gtest/gtest.h>

#include <array>

#include "tests/app/program.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;

struct ConvertCommand : testing::Test {
    TemporaryFolder folder;

    std::string record(const std::string& arguments, const std::string& name) const {
        const ProgramRun run = run_scb("trace --records " + arguments + " -o " + (folder / name));
        EXPECT_EQ(run.status, 0) << run.err;
        return folder / name;
    }
    ProgramRun convert(const std::string& inputs, const std::string& output) const {
        return run_scb("convert " + inputs + " -o " + (folder / output));
    }
};

TEST_F(ConvertCommand, LosesNothingOnTheWayToJsonLinesAndBack) {
    const std::string recording = record("cone --frames 0", "a.scbrec");
    const ProgramRun there = convert(recording, "a.jsonl");
    EXPECT_EQ(there.status, 0) << there.err;
    EXPECT_EQ(there.out, "");
    EXPECT_EQ(lines_of(there.err), 1u) << there.err;
    EXPECT_TRUE(file_text(folder / "a.jsonl").starts_with("{\"setting\":\"engine\""));
    EXPECT_TRUE(file_text(folder / "a.jsonl").ends_with("{\"end\":true}\n"));
    // Recognized by what it is, not by its name.
    fs::rename(folder / "a.jsonl", folder / "a.txt");
    EXPECT_EQ(convert(folder / "a.txt", "b.scbrec").status, 0);
    EXPECT_EQ(file_text(folder / "b.scbrec"), file_text(recording));
    EXPECT_EQ(convert(folder / "a.txt", "b.jsonl").status, 0);
    EXPECT_EQ(file_text(folder / "b.jsonl"), file_text(folder / "a.txt"));
}

TEST_F(ConvertCommand, JoinsFramesAsIfTheyWereRecordedByOne) {
    const std::string a = record("spheres-l1 --frames 100,250", "a.scbrec"),
                      b = record("spheres-l1 --frames 200", "b.scbrec"),
                      all = record("spheres-l1 --frames 100,200,250", "all.scbrec");
    EXPECT_EQ(convert(b, "b.jsonl").status, 0);
    const ProgramRun run = convert(a + " " + (folder / "b.jsonl"), "c.scbrec");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(file_text(folder / "c.scbrec"), file_text(all));
}

TEST_F(ConvertCommand, ConvertsWhatCanBeReadAndSaysWhatCannot) {
    const std::string whole = file_text(record("cone --frames 0", "a.scbrec"));
    const std::string cut = folder.write("cut.scbrec", whole.substr(0, whole.size() - 1));
    for (const char* quiet : {"", "--quiet "}) {
        const ProgramRun run =
            run_scb(std::string(quiet) + "convert " + cut + " -o " + (folder / "cut.jsonl"));
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_NE(run.err.find("cut.scbrec is damaged or cut off at byte "), std::string::npos)
            << run.err;
    }
    EXPECT_EQ(convert(folder / "a.scbrec", "a.jsonl").status, 0);
    const std::string read = file_text(folder / "cut.jsonl");
    EXPECT_GT(lines_of(read), 1000u);
    EXPECT_EQ(read, file_text(folder / "a.jsonl").substr(0, read.size()));
}

TEST_F(ConvertCommand, RefusesWithASentenceAndWritesNothing) {
    const std::string a = record("cone --frames 0", "a.scbrec"),
                      b = record("soup --frames 0", "b.scbrec"),
                      text = folder.write("text.scbrec", "no recording"),
                      broken = folder.write("broken.jsonl", "{\"frame\": 0}\n{\"frame\": -1}\n");
    fs::create_hard_link(a, folder / "same.scbrec");
    const std::size_t files = files_in(folder.path);
    for (const auto& [inputs, output, sentence] :
         std::vector<std::array<std::string, 3>>{{a, "c.json", "name a file .scbrec or .jsonl."},
                                                 {text, "c.scbrec", "is no recording"},
                                                 {broken, "c.scbrec", "broken.jsonl: line 2"},
                                                 {a + " " + b, "c.scbrec", "b.scbrec: mesh 0"},
                                                 {a, "same.scbrec", "would replace"},
                                                 {b + " " + a, "a.scbrec", "would replace"},
                                                 {folder / "none", "c.scbrec", "none"}}) {
        const ProgramRun run = convert(inputs, output);
        EXPECT_EQ(run.status, 2) << inputs << output;
        EXPECT_EQ(lines_of(run.err), 1u) << run.err;
        EXPECT_NE(run.err.find(sentence), std::string::npos) << run.err;
    }
    EXPECT_EQ(convert(a, "gone/c.scbrec").status, 3);
    EXPECT_EQ(files_in(folder.path), files);
}

}  // namespace
}  // namespace scb::app
