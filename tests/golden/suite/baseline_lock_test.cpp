#include "golden/suite/baseline_lock.h"

#include <gtest/gtest.h>

#include "core/platform/output_file.h"
#include "tests/temporary_folder.h"

namespace scb::golden {
namespace {

TEST(BaselineLock, IsOnesAtATime) {
    const TemporaryFolder folder;
    const std::filesystem::path baselines = folder.path / "new" / "baselines";
    {
        const BaselineLock lock(baselines);
        EXPECT_TRUE(lock.held());
        try {
            const BaselineLock second(baselines);
            FAIL();
        } catch (const OutputError& error) {
            EXPECT_NE(std::string(error.what()).find("another update"), std::string::npos);
        }
        EXPECT_TRUE(BaselineLock(folder.path).held());
    }
    EXPECT_TRUE(BaselineLock(baselines).held());
    // Nothing is left of it.
    EXPECT_TRUE(std::filesystem::is_empty(baselines));
}

TEST(BaselineLock, NeedsAFolder) {
    const TemporaryFolder folder;
    EXPECT_THROW(BaselineLock(folder.write("file", "")), OutputError);
}

}  // namespace
}  // namespace scb::golden
