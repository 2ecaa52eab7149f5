#include "render/web/web_page.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace scb::render {
namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

TEST(WebPage, TakesNamesForText) {
    const std::string hostile = "</title></script><script>alert(1)</script> @BLOCKS@ & \"'";
    BlockStore store;
    store.add(std::vector<std::uint8_t>{1, 2, 3});
    const std::string plain = web_page({"name", "text", "{}", {}}, store),
                      page =
                          web_page({hostile, hostile, "{\"a\": \"" + hostile + "\"}", {}}, store);
    EXPECT_EQ(count_of(page, "<script"), count_of(plain, "<script"));
    EXPECT_EQ(count_of(page, "</script"), count_of(plain, "</script"));
    EXPECT_EQ(count_of(page, "class=\"block\""), 1u);
    EXPECT_NE(page.find("&#60;script&#62;alert(1)"), std::string::npos);
    // What is a placeholder in the template is one there alone.
    EXPECT_NE(page.find("@BLOCKS@"), std::string::npos);
    EXPECT_EQ(plain.find('@' + std::string("MANIFEST@")), std::string::npos);
}

TEST(WebPage, HasTheThemeThatWasGiven) {
    const BlockStore store;
    EXPECT_NE(web_page({"a", "b", "{}", {}, "dark"}, store).find("data-theme=\"dark\""),
              std::string::npos);
    EXPECT_NE(web_page({"a", "b", "{}", {}}, store).find("data-theme=\"\""), std::string::npos);
}

TEST(BlockStore, TakesBlocksOfOtherStoresOnce) {
    BlockStore one, other;
    one.add(std::vector<std::uint8_t>{1, 2, 3});
    other.add(std::vector<std::uint32_t>{4});
    const std::size_t same = other.add(std::vector<std::uint8_t>{1, 2, 3});
    EXPECT_EQ(one.add(other.blocks()[same]), 0u);
    EXPECT_EQ(one.add(other.blocks()[0]), 1u);
    ASSERT_EQ(one.blocks().size(), 2u);
    EXPECT_EQ(one.blocks()[1].text, other.blocks()[0].text);
    EXPECT_EQ(one.add(std::vector<std::uint32_t>{4}), 1u);
}

TEST(WebPage, HasTheFragmentShadersOfThePictures) {
    namespace fs = std::filesystem;
    const fs::path sources = fs::path(SCB_SOURCE_DIR) / "render";
    const std::string page = web_page({"a", "b", "{}", {}}, BlockStore());
    const std::set<std::string> not_there = {
        "overlay.frag",  // text is the browser's
        "planes.glsl",   // where planes are kept is another place
    };
    std::size_t count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(sources / "shaders")) {
        const std::string name = entry.path().filename().string();
        if (name.ends_with(".vert") || not_there.contains(name)) continue;
        std::ostringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        EXPECT_EQ(count_of(page, text.str()), 1u) << name;
        ++count;
    }
    EXPECT_GE(count, 10u);
    // And none of its own.
    for (const fs::directory_entry& entry : fs::directory_iterator(sources / "web"))
        EXPECT_NE(entry.path().extension(), ".frag") << entry.path();
}

TEST(WebPage, AllowsNoOtherScriptAndNoNetwork) {
    const std::string page = web_page({"a", "b", "{}", {}}, BlockStore());
    EXPECT_NE(page.find("default-src 'none'; script-src 'sha256-"), std::string::npos);
    for (const char* forbidden : {"unsafe-inline", "unsafe-eval", "http:", "https:", "eval("})
        EXPECT_EQ(page.find(forbidden), std::string::npos) << forbidden;
}

}  // namespace
}  // namespace scb::render
