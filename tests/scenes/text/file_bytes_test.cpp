#include "scenes/text/file_bytes.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <functional>

#include "scb/error.h"
#include "scenes/recordings/recording_input.h"
#include "scenes/text/file_window.h"
#include "tests/temporary_folder.h"

namespace scb::scenes {
namespace {

/// What is said where this process may open no more files.
std::string refusal_without_files(const std::function<void()>& read) {
    rlimit before{};
    ::getrlimit(RLIMIT_NOFILE, &before);
    const rlimit none{0, before.rlim_max};
    ::setrlimit(RLIMIT_NOFILE, &none);
    std::string sentence;
    try {
        read();
    } catch (const InputError& error) {
        sentence = error.what();
    }
    ::setrlimit(RLIMIT_NOFILE, &before);
    return sentence;
}

TEST(FileBytes, OfAFileThatCannotBeOpenedSayWhy) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.jsonl", "{\"end\": true}"),
                      expected = file +
                                 ": cannot be opened (Too many open files); raise the limit of "
                                 "open files (ulimit -n).";
    EXPECT_EQ(refusal_without_files([&] { file_bytes(file); }), expected);
    EXPECT_EQ(refusal_without_files([&] { FileWindow{file}; }), expected);
    EXPECT_EQ(refusal_without_files([&] { recording_bytes(file); }), expected);
}

}  // namespace
}  // namespace scb::scenes
