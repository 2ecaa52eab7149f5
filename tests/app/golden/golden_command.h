#pragma once

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace scb::app {

inline constexpr const char* golden_suite_text = R"({
  "scb_golden": 1,
  "presets": {"small": {"size": "320x240", "scene": "cone"}},
  "cases": [
    {"name": "levels", "preset": "small", "run": "levels", "frames": "100", "arguments": ["--levels", "4"]},
    {"name": "rejections", "preset": "small", "run": "rejections", "frames": "100", "arguments": ["--focus", "1"]},
    {"name": "traversal", "preset": "small", "run": "traversal", "frames": "100"},
    {"name": "inspect", "preset": "small", "run": "inspect", "frames": "100"},
    {"name": "collide", "run": "collide", "scene": "cone", "frames": "0:100:10"}
  ]
})";

/// The contents of all files of a folder, by name.
inline std::map<std::string, std::string> files_of(const std::filesystem::path& folder) {
    std::map<std::string, std::string> files;
    for (const std::filesystem::directory_entry& entry :
         std::filesystem::directory_iterator(folder))
        files[entry.path().filename().string()] = file_text(entry.path());
    return files;
}

/// The baselines of the suite, made by the program itself: once for all tests, since they are the
/// same in each folder.
inline const std::map<std::string, std::string>& made_baselines() {
    static const std::map<std::string, std::string> made = [] {
        const TemporaryFolder folder;
        write_text(folder / "cases.json", golden_suite_text);
        EXPECT_EQ(run_scb("golden update --all --suite " + (folder / "cases.json")).status, 0);
        return files_of(folder.path / "baselines");
    }();
    return made;
}

/// A suite with its baselines.
class GoldenCommand : public testing::Test {
  protected:
    GoldenCommand() {
        write_text(suite, golden_suite_text);
        std::filesystem::create_directory(folder.path / "baselines");
        for (const auto& [name, text] : made_baselines()) write_text(baseline(name), text);
    }

    ProgramRun golden(const std::string& arguments, const Surroundings& surroundings = {}) {
        return run_scb("golden " + arguments + " --suite " + suite, surroundings);
    }
    ProgramRun golden_process(const std::string& arguments, const std::string& prefix) {
        return run_scb_process("golden " + arguments + " --suite " + suite, prefix);
    }
    ProgramRun check(const std::string& more = "") {
        const ProgramRun run = golden("check --report " + report.string() + " " + more);
        results = nlohmann::json();
        if (std::filesystem::exists(report / "results.json"))
            results = nlohmann::json::parse(file_text(report / "results.json"));
        return run;
    }
    nlohmann::json result(const std::string& name) const {
        for (const nlohmann::json& entry : results["cases"])
            if (entry["name"] == name) return entry;
        return {};
    }
    std::filesystem::path baseline(const std::string& file) const {
        return folder.path / "baselines" / file;
    }
    std::map<std::string, std::string> baselines() const {
        return files_of(folder.path / "baselines");
    }

    const TemporaryFolder folder;
    const std::string suite = folder / "cases.json";
    const std::filesystem::path report = folder.path / "report";
    nlohmann::json results;
};

}  // namespace scb::app
