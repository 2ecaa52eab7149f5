#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include "tests/app/golden/golden_command.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

using GoldenCommandUpdate = GoldenCommand;

TEST_F(GoldenCommandUpdate, IsOnlyWhereAPersonAsks) {
    const auto before = baselines();
    write_text(baseline("collide.counts.json"), "{}");
    using Environment = std::vector<std::string>;
    for (const auto& [arguments, environment] :
         {std::pair<std::string, Environment>{"update --all", {"CI=true"}},
          {"update", {}},
          {"update --all --failing", {}},
          {"update nonsense", {}},
          {"check nonsense", {}}}) {
        const ProgramRun run = golden(arguments, {"", environment});
        EXPECT_EQ(run.status, 2) << arguments;
        EXPECT_EQ(file_text(baseline("collide.counts.json")), "{}") << arguments;
    }
    EXPECT_EQ(golden("update --failing").out, "collide.counts.json\n1 of 5 cases updated\n");
    EXPECT_EQ(baselines(), before);
    // Where it cannot write, the old baseline stays.
    const ProgramRun full = golden("update --all --baselines " + suite);
    EXPECT_EQ(full.status, 3) << full.err;
    EXPECT_EQ(baselines(), before);
}

// Killed later and later, until one comes to its end.
TEST_F(GoldenCommandUpdate, ThatIsKilledLeavesEveryFileOldOrNew) {
    const auto before = baselines();
    json other = json::parse(golden_suite_text);
    other["presets"]["small"]["scene"] = "soup";
    write_text(suite, other.dump());
    ASSERT_EQ(golden("update --all --baselines " + (folder / "after")).status, 0);
    std::map<std::string, std::string> after;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / "after"))
        after[entry.path().filename().string()] = file_text(entry.path());
    int status = -1;
    for (double after_seconds = 0.01; status != 0 && after_seconds < 100; after_seconds *= 1.25) {
        const std::string limit = std::to_string(after_seconds);
        status = golden_process("update --all", "env timeout -s KILL " + limit).status;
        for (const auto& [name, text] : before) {
            ASSERT_TRUE(fs::is_regular_file(baseline(name))) << name << " after " << limit;
            const std::string now = file_text(baseline(name));
            EXPECT_TRUE(now == text || now == after.at(name)) << name << " after " << limit;
        }
    }
    // It has cleaned up too.
    EXPECT_EQ(status, 0);
    EXPECT_EQ(baselines(), after);
}

TEST_F(GoldenCommandUpdate, KeepsAcceptedPicturesWhereOnlyCountsChange) {
    fs::copy_file(baseline("levels.png"), baseline("rejections.2.png"));
    write_text(baseline("rejections.counts.json"), "{}");
    EXPECT_EQ(golden("update --failing").out, "rejections.counts.json\n1 of 5 cases updated\n");
    EXPECT_EQ(file_text(baseline("rejections.2.png")), file_text(baseline("levels.png")));
    fs::copy_file(baseline("levels.png"), baseline("rejections.png"),
                  fs::copy_options::overwrite_existing);
    EXPECT_EQ(golden("update --failing").out,
              "rejections.png\nrejections.2.png (removed)\n1 of 5 cases updated\n");
}

// A folder that has something in it cannot be replaced by a file.
TEST_F(GoldenCommandUpdate, ThatFailsHalfWaySaysWhatItDidAndLeavesTheRest) {
    write_text(baseline("rejections.counts.json"), "{}");
    write_text(baseline("traversal.counts.json"), "{}");
    write_text(baseline("collide.counts.json"), "{}");
    fs::remove(baseline("traversal.png"));
    fs::create_directory(baseline("traversal.png"));
    write_text(baseline("traversal.png") / "inside", "");
    const ProgramRun run = golden("update --all");
    EXPECT_EQ(run.status, 3);
    EXPECT_EQ(run.out, "rejections.counts.json\n1 of 5 cases updated\n");
    EXPECT_NE(run.err.find("traversal.png: it cannot be replaced"), std::string::npos) << run.err;
    EXPECT_NE(file_text(baseline("rejections.counts.json")), "{}");
    EXPECT_EQ(file_text(baseline("traversal.counts.json")), "{}");
    EXPECT_EQ(file_text(baseline("collide.counts.json")), "{}");
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / "baselines"))
        EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << entry.path();
}

TEST_F(GoldenCommandUpdate, IsOneAtATime) {
    const fs::path staging = baseline(".update-abcdef");
    fs::create_directory(staging);
    write_text(staging / "levels.png", "half");
    const int first = ::open((folder / "baselines").c_str(), O_RDONLY | O_DIRECTORY);
    ASSERT_EQ(::flock(first, LOCK_EX), 0);
    const ProgramRun second = golden("update --all");
    EXPECT_EQ(second.status, 3);
    EXPECT_NE(second.err.find("another update is changing these baselines"), std::string::npos)
        << second.err;
    EXPECT_TRUE(fs::exists(staging / "levels.png"));
    // A check changes nothing, so it need not wait.
    EXPECT_EQ(check().status, 0);
    ::close(first);
    EXPECT_EQ(golden("update --all").status, 0);
    EXPECT_FALSE(fs::exists(staging));
}

TEST_F(GoldenCommandUpdate, KeepsATraceThatCannotBeRecordedAnew) {
    const std::string runner = folder / "runner";
    write_text(runner,
               "#!/bin/sh\ncase \"$*\" in *\" trace \"*) echo scb: error: No trace. >&2; exit 2;; "
               "esac\nexec \"$@\"\n");
    fs::permissions(runner, fs::perms::owner_all);
    const std::string trace = file_text(baseline("rejections.trace.scbrec"));
    write_text(baseline("rejections.counts.json"), "{}");
    check("--runner " + runner);
    EXPECT_NE(result("rejections")["lines"].dump().find("could not be recorded: No trace."),
              std::string::npos)
        << result("rejections");
    const ProgramRun run = golden("update --failing --runner " + runner);
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(run.out,
              "rejections: its trace could not be recorded, and the old one stays as it is. No "
              "trace.\nrejections.counts.json\n1 of 5 cases updated\n");
    EXPECT_EQ(file_text(baseline("rejections.trace.scbrec")), trace);
}

TEST_F(GoldenCommandUpdate, RestoresARecordThatACheckFoundDamaged) {
    write_text(baseline("collide.meta.json"), "{");
    const ProgramRun run = golden("check collide");
    EXPECT_EQ(run.status, 0) << run.out << run.err;
    EXPECT_EQ(run.out.find("collide: same. " + baseline("collide.meta.json").string()), 0u)
        << run.out;
    EXPECT_EQ(golden("update collide").status, 0);
    EXPECT_EQ(golden("check collide").out, "1 case: 1 same\n");
}

}  // namespace
}  // namespace scb::app
