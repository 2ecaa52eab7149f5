#include "golden/compare/mesh_difference.h"

#include <gtest/gtest.h>

#include "scb/error.h"
#include "tests/temporary_folder.h"

namespace scb::golden {
namespace {

std::string meta(int triangles, const std::string& hash) {
    return R"({"command": "scb", "bodies": [
        {"name": "spider", "triangles": )" +
           std::to_string(triangles) + R"(, "vertices": 762, "hash": ")" + hash + R"("},
        {"name": "wall", "triangles": 2, "vertices": 4, "hash": "00000000000000aa"}]})";
}

struct MeshSentences : testing::Test {
    std::string sentences(const std::string& before, const std::string& after) const {
        return mesh_sentences(folder.write("before.json", before),
                              folder.write("after.json", after));
    }
    const TemporaryFolder folder;
};

TEST_F(MeshSentences, NameWhatIsAnother) {
    const std::string a(16, 'a'), b(16, 'b');
    EXPECT_EQ(sentences(meta(1368, a), meta(1368, a)), "");
    EXPECT_EQ(sentences(meta(1368, a), meta(1368, b)),
              "The mesh of spider is another: 1,368 triangles, 762 vertices, hash " + b +
                  " instead of 1,368 triangles, 762 vertices, hash " + a + ".");
    const std::string two = R"({"bodies": [
        {"name": "A", "triangles": 1, "vertices": 3, "hash": "@"},
        {"name": "B", "triangles": 1, "vertices": 3, "hash": "@"}]})";
    std::string before = two, after = two;
    for (const char* hash : {"x", "x"}) before.replace(before.find('@'), 1, hash);
    for (const char* hash : {"y", "y"}) after.replace(after.find('@'), 1, hash);
    EXPECT_EQ(
        sentences(before, after),
        "The mesh of A and B is another: 1 triangle, 3 vertices, hash y instead of 1 triangle, "
        "3 vertices, hash x.");
}

TEST_F(MeshSentences, AreNoneWhereNothingIsKnown) {
    EXPECT_EQ(sentences("{}", meta(1, "a")), "");
    EXPECT_EQ(sentences(R"({"bodies": []})", meta(1, "a")), "");
    EXPECT_EQ(mesh_sentences(folder / "none.json", folder.write("after.json", meta(1, "a"))), "");
    EXPECT_THROW(sentences("{", meta(1, "a")), InputError);
    EXPECT_THROW(sentences(R"({"bodies": 5})", meta(1, "a")), InputError);
    EXPECT_THROW(sentences("[]", meta(1, "a")), InputError);
}

}  // namespace
}  // namespace scb::golden
