#include "scenes/meshes/isolated_mesh.h"

#include <sys/stat.h>

#include <cstdio>
#include <span>
#include <thread>

#include "scenes/meshes/left_out.h"
#include "scenes/meshes/mesh_answer.h"
#include "scenes/meshes/mesh_file.h"
#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

/// A shell script in place of scb while this exists.
struct FakeReader {
    explicit FakeReader(const std::string& script) {
        const std::string file = folder.write("reader", "#!/bin/sh\n" + script + "\n");
        ::chmod(file.c_str(), 0755);
        set_mesh_reader(file);
    }
    ~FakeReader() { set_mesh_reader({}); }

    TemporaryFolder folder;
};

constexpr const char* triangle_stl =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid a\n";

/// The error about a good file if this script is the reader.
std::string refused_by(const std::string& script) {
    const FakeReader fake(script);
    const std::string file = fake.folder.write("good.stl", triangle_stl);
    const std::string sentence = refusal([&] { load_mesh(file); });
    EXPECT_EQ(sentence.rfind(file + ": ", 0), 0u) << sentence;
    return sentence;
}

/// The whole sentence, where the script says it.
std::string refused_by_reader(const std::string& script) {
    const FakeReader fake(script);
    return refusal([&] { load_mesh(fake.folder.write("good.stl", triangle_stl)); });
}

TEST(IsolatedMesh, GivesWhatAssimpGives) {
    const TemporaryFolder folder;
    const Mesh mesh = isolated_mesh(folder.write("a.stl", triangle_stl));
    EXPECT_EQ(mesh.vertices, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(IsolatedMesh, PassesRefusalsOn) {
    const TemporaryFolder folder;
    const std::string file = folder.write("notes.xyz", "this is not a mesh\n");
    expect_in("the format is not known", refusal([&] { isolated_mesh(file); }));
}

/// What makes a reader's script write these bytes.
std::string writes(std::span<const std::byte> bytes) {
    std::string printf = "printf '";
    for (const std::byte byte : bytes) {
        char octal[5];
        std::snprintf(octal, sizeof octal, "\\%03o", std::to_integer<unsigned>(byte));
        printf += octal;
    }
    return printf + "' >&3; ";
}
std::string text(const std::string& words) { return writes(std::as_bytes(std::span(words))); }
const std::string greet = writes(std::as_bytes(std::span(mesh_greeting)));
std::string answers(const MeshAnswer& answer) {
    return greet + writes(std::as_bytes(std::span(&answer, 1)));
}
constexpr std::uint64_t huge = ~std::uint64_t{0};

TEST(IsolatedMesh, TakesWhatTheReaderSaysForWhatItIs) {
    EXPECT_EQ(refused_by_reader(answers({MeshAnswer::refusal, 9}) + text("not this.")),
              "not this.");
    expect_in("cannot be read (too soon.)",
              refused_by(answers({MeshAnswer::failure, 9}) + text("too soon.")));
}

TEST(IsolatedMesh, IsNotReadWhereItsReaderCannotBeConfined) {
    const FakeReader fake(answers({MeshAnswer::unconfined, 9}) + text("no filter"));
    const std::string file = fake.folder.write("good.stl", triangle_stl);
    try {
        load_mesh(file);
        ADD_FAILURE();
    } catch (const MeshReaderError& error) {
        expect_in("is confined, which this system does not allow (no filter)", error.what());
    }
}

TEST(IsolatedMesh, BlamesNoFileForALimitOfMemory) {
    const FakeReader fake(answers({MeshAnswer::limited, 7}) + text("limits."));
    const std::string file = fake.folder.write("good.stl", triangle_stl);
    EXPECT_THROW(load_mesh(file), MeshReaderError);
}

TEST(IsolatedMesh, ThatCrashesOrIsCutShortTakesNothingWithIt) {
    const std::string whole = answers({MeshAnswer::refusal, 9}) + text("not this.");
    for (const std::string& script :
         {greet + "kill -SEGV $$", greet + "kill -ABRT $$", greet,
          greet + text(std::string(8, '\0')), answers({MeshAnswer::refusal, 9}) + text("short"),
          answers({MeshAnswer::mesh, huge}), answers({MeshAnswer::mesh, 3, huge}),
          answers({MeshAnswer::mesh, 0, 0, huge}), answers({7}), answers({huge}),
          whole + "kill -SEGV $$", whole + "exit 1", whole + text("and more")})
        expect_in("the reader of this format crashed on the file, which may be valid; convert it",
                  refused_by(script));
    expect_in("its reader was killed", refused_by(greet + "kill -KILL $$"));
    for (const char* signal : {"ALRM", "XCPU"})
        expect_in("did not end within its time limit",
                  refused_by(greet + "kill -" + signal + " $$"));
}

TEST(IsolatedMesh, BlamesNoFileWhereTheReaderDoesNotStart) {
    for (const std::string& script : {std::string("exit 0"), std::string("kill -SEGV $$"),
                                      text("scb mesh"), text("noise noise noise")}) {
        const FakeReader fake(script);
        const std::string file = fake.folder.write("good.stl", triangle_stl);
        EXPECT_THROW(load_mesh(file), MeshReaderError) << script;
    }
}

TEST(IsolatedMesh, SaysWhatEndedItsReaderFromOutside) {
    for (const std::string& script : {std::string("kill -KILL $$"), greet + "kill -INT $$",
                                      greet + "kill -TERM $$", greet + "kill -HUP $$"}) {
        const FakeReader fake(script);
        try {
            load_mesh(fake.folder.write("good.stl", triangle_stl));
            ADD_FAILURE() << script;
        } catch (const MeshReaderError& error) {
            const bool before = script.find("KILL") != script.npos;
            expect_in(before ? ", was ended by signal 9 (Killed) before it read the file; try again"
                             : ": its reader was ended by signal ",
                      error.what());
        }
    }
}

TEST(IsolatedMesh, IsNeverReplacedByReadingInThisProcess) {
    const TemporaryFolder folder;
    const std::string file = folder.write("good.stl", triangle_stl);
    set_mesh_reader(folder / "gone");
    EXPECT_THROW(load_mesh(file), MeshReaderError);
    set_mesh_reader({});
    EXPECT_EQ(load_mesh(file).triangles.size(), 1u);
}

// Every node has the one before it twice.
TEST(IsolatedMesh, OfLessThanAPageTakesNoMoreThanItsMemory) {
#ifdef SCB_SANITIZED
    GTEST_SKIP() << "sanitized, a reader has no limit of memory";
#endif
    std::string nodes = R"({"mesh": 0})";
    for (int i = 0; i < 40; ++i) {
        const std::string below = std::to_string(i);
        nodes += R"(, {"children": [)" + below + ", " + below + "]}";
    }
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "wide.gltf",
        R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [40]}], "nodes": [)" +
            nodes + R"(], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
"bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36,
"uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
    expect_in("needs more memory than a file of its size may take (1536 MiB)",
              refusal([&] { load_mesh(file); }));
}

TEST(IsolatedMesh, NotesWhatOfAFileIsLeftOut) {
    const std::string names("\0skins\0morph\ntargets\0", 21);
    const std::string mesh(3 * 24 + 12, '\0');
    const FakeReader fake(answers({MeshAnswer::mesh, 3, 1, names.size()}) + text(mesh + names));
    const std::string file = fake.folder.write("good.stl", triangle_stl);
    take_left_out();
    load_mesh(file);
    EXPECT_EQ(take_left_out(),
              (std::vector<std::string>{
                  file + ": its skins and morph targets are left out; the mesh has the shape that "
                         "is stored before them."}));
    EXPECT_TRUE(take_left_out().empty());
}

TEST(IsolatedMesh, ServesSeveralThreads) {
    const TemporaryFolder folder;
    const std::string file = folder.write("good.stl", triangle_stl);
    std::array<std::size_t, 4> triangles{};
    {
        std::vector<std::jthread> threads;
        for (std::size_t& count : triangles)
            threads.emplace_back([&] { count = load_mesh(file).triangles.size(); });
    }
    EXPECT_EQ(triangles, (std::array<std::size_t, 4>{1, 1, 1, 1}));
}

}  // namespace
}  // namespace scb::scenes
