#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace scb::app {
namespace {

using nlohmann::json;

json finding(const json& report, const std::string& name) {
    for (const json& entry : report["findings"])
        if (entry["name"] == name) return entry;
    return {};
}

TEST(Doctor, WhatDrawsHereWorks) {
    const ProgramRun run = run_scb("doctor --json");
    EXPECT_EQ(run.status, 0) << run.out;
    const json report = json::parse(run.out);
    EXPECT_TRUE(report["draws"]);
    EXPECT_EQ(finding(report, "meshes")["state"], "works");
    EXPECT_TRUE(finding(report, "osmesa")["state"] == "works" ||
                finding(report, "egl")["state"] == "works");
    EXPECT_NE(run_scb("doctor").out.find("Pictures can be drawn."), std::string::npos);
}

TEST(Doctor, WhatIsMissingIsNamedWithALineThatInstallsIt) {
    const TemporaryFolder empty;
    const std::string none = empty / "none";
    const ProgramRun run =
        run_scb("doctor --json", {"", {"PATH=" + empty.path.string(), "SCB_MODELS=" + none}});
    EXPECT_EQ(run.status, 0) << run.out;
    const json report = json::parse(run.out);
    EXPECT_EQ(finding(report, "ffmpeg")["state"], "missing");
    EXPECT_EQ(finding(report, "ffmpeg")["remedy"], "apt-get install ffmpeg");
    EXPECT_EQ(finding(report, "models")["text"], none + " is no folder");
}

TEST(Doctor, VersionsAreThereAsJson) {
    const ProgramRun run = run_scb("--version --json");
    EXPECT_EQ(run.status, 0);
    const json versions = json::parse(run.out);
    for (const auto& [name, version] : versions.items()) {
        const std::string line = name + std::string(name.size() < 6 ? 6 - name.size() : 0, ' ') +
                                 " " + version.get<std::string>() + "\n";
        EXPECT_NE(run_scb("--version").out.find(line), std::string::npos) << line;
    }
    EXPECT_EQ(run_scb("--json --version").out, run.out);
    // Of other commands it is not.
    const ProgramRun refused = run_scb("scenes --json");
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("unknown option '--json' of `scb scenes`"), std::string::npos);
}

#ifndef SCB_SANITIZED
TEST(Doctor, WithoutOpenGLItSaysWhy) {
    // Too little memory for any context.
    const ProgramRun run = run_scb_process("doctor", "ulimit -v 600000;");
    EXPECT_EQ(run.status, 77) << run.out << run.err;
    EXPECT_NE(run.out.find("No picture can be drawn"), std::string::npos) << run.out;
}
#endif

}  // namespace
}  // namespace scb::app
