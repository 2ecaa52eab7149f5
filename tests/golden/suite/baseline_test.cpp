#include "golden/suite/baseline.h"

#include <gtest/gtest.h>

#include <map>

#include "core/platform/file_bytes.h"
#include "core/platform/output_file.h"
#include "tests/temporary_folder.h"

namespace scb::golden {
namespace {

namespace fs = std::filesystem;

using Names = std::vector<std::string>;

/// A baseline with an accepted picture beside its own, and what a run made: the same.
class Baseline : public testing::Test {
  protected:
    Baseline() {
        for (const TemporaryFolder* folder : {&baselines, &candidates}) {
            folder->write("case.counts.json", "counts");
            folder->write("case.ids.png", "ids");
            folder->write("case.png", "picture");
            folder->write("case.meta.json", "meta");
            folder->write("case.trace.scbrec", "trace");
        }
        baselines.write("case.2.png", "accepted");
        baselines.write("case-2.png", "another case's");
    }
    Names replace(OldTrace old_trace = OldTrace::removed) const {
        return replace_baseline(baselines.path, candidates.path, "case", old_trace);
    }
    std::map<std::string, std::string> files() const {
        std::map<std::string, std::string> files;
        for (const fs::directory_entry& entry : fs::directory_iterator(baselines.path))
            files[entry.path().filename().string()] =
                entry.is_directory() ? "a folder" : file_bytes(entry.path().string());
        return files;
    }

    const TemporaryFolder baselines, candidates;
};

TEST_F(Baseline, ThatIsTheSameStays) {
    const auto before = files();
    EXPECT_EQ(replace(), Names{});
    EXPECT_EQ(files(), before);
}

TEST_F(Baseline, KeepsAcceptedPicturesWhereThePictureDoesNotChange) {
    candidates.write("case.counts.json", "new counts");
    EXPECT_EQ(replace(), Names{"case.counts.json"});
    EXPECT_EQ(files().at("case.2.png"), "accepted");
    EXPECT_EQ(files().at("case.counts.json"), "new counts");
}

TEST_F(Baseline, KeepsAcceptedPicturesWhereTheRunDrawsOneOfThem) {
    candidates.write("case.png", "accepted");
    candidates.write("case.counts.json", "new counts");
    EXPECT_EQ(replace(), Names{"case.counts.json"});
    EXPECT_EQ(files().at("case.png"), "picture");
    EXPECT_EQ(files().at("case.2.png"), "accepted");
}

TEST_F(Baseline, DropsAcceptedPicturesWhereThePictureChanges) {
    baselines.write("case.3.png", "accepted too");
    candidates.write("case.png", "new picture");
    EXPECT_EQ(replace(), (Names{"case.png", "case.2.png (removed)", "case.3.png (removed)"}));
    EXPECT_EQ(files().at("case.png"), "new picture");
    EXPECT_EQ(files().count("case.2.png"), 0u);
    EXPECT_EQ(files().at("case-2.png"), "another case's");
}

TEST_F(Baseline, LosesWhatTheRunDoesNotMakeAnyMore) {
    for (const char* name : {"case.ids.png", "case.png", "case.trace.scbrec"})
        fs::remove(candidates.path / name);
    EXPECT_EQ(replace(), (Names{"case.ids.png (removed)", "case.png (removed)",
                                "case.trace.scbrec (removed)", "case.2.png (removed)"}));
}

TEST_F(Baseline, KeepsItsTraceWhereThatIsAskedFor) {
    fs::remove(candidates.path / "case.trace.scbrec");
    EXPECT_EQ(replace(OldTrace::kept), Names{});
    EXPECT_EQ(files().at("case.trace.scbrec"), "trace");
}

TEST_F(Baseline, TheTraceOfVersion10IsUsedUntilItIsReplaced) {
    fs::remove(baselines.path / "case.trace.scbrec");
    EXPECT_TRUE(trace_of(case_files(baselines.path, "case")).empty());
    baselines.write("case.scbtrace", "old trace");
    EXPECT_EQ(trace_of(case_files(baselines.path, "case")), baselines.path / "case.scbtrace");
    fs::rename(candidates.path / "case.trace.scbrec", candidates.path / "later");
    EXPECT_EQ(replace(OldTrace::kept), Names{});
    fs::rename(candidates.path / "later", candidates.path / "case.trace.scbrec");
    EXPECT_EQ(replace(), (Names{"case.trace.scbrec", "case.scbtrace (removed)"}));
    EXPECT_EQ(files().count("case.scbtrace"), 0u);
    EXPECT_EQ(trace_of(case_files(baselines.path, "case")), baselines.path / "case.trace.scbrec");
}

TEST_F(Baseline, ThatCannotBeReplacedStaysWhole) {
    fs::remove(baselines.path / "case.png");
    fs::create_directory(baselines.path / "case.png");
    baselines.write("case.png/inside", "kept");
    candidates.write("case.counts.json", "new counts");
    candidates.write("case.ids.png", "new ids");
    candidates.write("case.meta.json", "new meta");
    const auto before = files();
    EXPECT_THROW(replace(), OutputError);
    EXPECT_EQ(files(), before);
    EXPECT_TRUE(fs::exists(baselines.path / "case.png" / "inside"));
}

TEST_F(Baseline, AFolderIsNoAcceptedPicture) {
    fs::create_directory(baselines.path / "case.3.png");
    baselines.write("case.4.png", "behind a gap");
    EXPECT_EQ(accepted_images(baselines.path, "case"),
              (std::vector<fs::path>{baselines.path / "case.png", baselines.path / "case.2.png"}));
    EXPECT_TRUE(accepted_images(baselines.path, "none").empty());
}

TEST_F(Baseline, WhatAKilledUpdateHasLeftIsRemoved) {
    const auto before = files();
    fs::create_directory(baselines.path / ".update-abcdef");
    baselines.write(".update-abcdef/case.png", "half");
    remove_unfinished(baselines.path);
    EXPECT_EQ(files(), before);
}

TEST_F(Baseline, FilesOfNoCaseAreStray) {
    baselines.write("README.md", "for people");
    Suite suite;
    suite.cases.emplace_back().name = "case";
    EXPECT_EQ(stray_files(baselines.path, suite), Names{"case-2.png"});
    suite.cases.emplace_back().name = "case-2";
    EXPECT_EQ(stray_files(baselines.path, suite), Names{});
    suite.cases.erase(suite.cases.begin());
    EXPECT_EQ(stray_files(baselines.path, suite),
              (Names{"case.2.png", "case.counts.json", "case.ids.png", "case.meta.json", "case.png",
                     "case.trace.scbrec"}));
}

}  // namespace
}  // namespace scb::golden
