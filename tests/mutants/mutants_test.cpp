#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace scb {
namespace {

std::string text_of(const std::string& file) {
    std::ifstream in(SCB_SOURCE_DIR "/" + file);
    return {std::istreambuf_iterator<char>(in), {}};
}

// tests/mutants/run takes too long to be run often; what it breaks must be there when it is.
TEST(Mutants, AreOfTextsThatTheirFilesHaveOnce) {
    std::ifstream list(SCB_SOURCE_DIR "/tests/mutants/mutants.txt");
    std::string file, text;
    std::size_t mutants = 0;
    for (std::string line; std::getline(list, line);) {
        if (line.starts_with("core/") || line.starts_with("scenes/")) {
            file = line;
            text = text_of(file);
            EXPECT_NE(text, "") << file;
        } else if (line.starts_with("- ")) {
            const std::string from = line.substr(2);
            const std::size_t at = text.find(from);
            EXPECT_NE(at, std::string::npos) << file << " has not: " << from;
            EXPECT_EQ(text.rfind(from), at) << file << " has more than once: " << from;
        } else if (line.starts_with("+ ")) {
            ++mutants;
        } else {
            EXPECT_TRUE(line.empty() || line.starts_with("#")) << line;
        }
    }
    EXPECT_GT(mutants, 150u);
}

}  // namespace
}  // namespace scb
