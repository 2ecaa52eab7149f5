#include "scenes/meshes/isolated_mesh.h"

#include <sys/stat.h>

#include <thread>

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

constexpr const char* triangle_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// What is said of a good file where the script reads it.
std::string refused_by(const std::string& script) {
    const FakeReader fake(script);
    const std::string file = fake.folder.write("good.obj", triangle_obj);
    const std::string sentence = refusal([&] { load_mesh(file); });
    EXPECT_EQ(sentence.rfind(file + ": ", 0), 0u) << sentence;
    return sentence;
}

/// The whole sentence, where the script says it.
std::string refused_by_reader(const std::string& script) {
    const FakeReader fake(script);
    return refusal([&] { load_mesh(fake.folder.write("good.obj", triangle_obj)); });
}

TEST(IsolatedMesh, GivesWhatAssimpGives) {
    const TemporaryFolder folder;
    const Mesh mesh = isolated_mesh(folder.write("a.obj", triangle_obj));
    EXPECT_EQ(mesh.vertices, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(IsolatedMesh, PassesRefusalsOn) {
    const TemporaryFolder folder;
    const std::string file = folder.write("notes.xyz", "this is not a mesh\n");
    expect_in("the format is not known", refusal([&] { isolated_mesh(file); }));
}

/// A reader's script that greets; and one that writes a number of 64 bits, least byte first.
const std::string greet = "printf 'scb mesh 2\\0\\0\\0\\0\\0\\0' >&3; ";
std::string number(const std::string& low_byte) {
    return "printf '\\" + low_byte + "\\0\\0\\0\\0\\0\\0\\0' >&3; ";
}
const std::string huge = "printf '\\377\\377\\377\\377\\377\\377\\377\\377' >&3; ";
std::string text(const std::string& words) { return "printf '" + words + "' >&3; "; }

TEST(IsolatedMesh, TakesWhatTheReaderSaysForWhatItIs) {
    const std::string nine = number("11");
    EXPECT_EQ(refused_by_reader(greet + number("1") + nine + number("0") + number("0") +
                                text("not this.")),
              "not this.");
    const std::string failed =
        greet + number("3") + nine + number("0") + number("0") + text("too soon.");
    expect_in("cannot be read (too soon.)", refused_by(failed));
}

TEST(IsolatedMesh, IsNotReadWhereItsReaderCannotBeConfined) {
    const FakeReader fake(greet + number("2") + number("11") + number("0") + number("0") +
                          text("no filter"));
    const std::string file = fake.folder.write("good.obj", triangle_obj);
    try {
        load_mesh(file);
        ADD_FAILURE();
    } catch (const MeshReaderError& error) {
        expect_in("is confined, which this system does not allow (no filter)", error.what());
    }
}

TEST(IsolatedMesh, ThatCrashesOrIsCutShortTakesNothingWithIt) {
    const std::string whole =
        greet + number("1") + number("11") + number("0") + number("0") + text("not this.");
    for (const std::string& script :
         {greet + "kill -SEGV $$", greet + "kill -ABRT $$", greet, greet + number("0"),
          greet + number("1") + number("11") + number("0") + number("0") + text("short"),
          greet + number("0") + huge + number("0") + number("0"),
          greet + number("0") + number("3") + huge + number("0"),
          greet + number("0") + number("0") + number("0") + huge,
          greet + number("7") + number("0") + number("0") + number("0"),
          greet + huge + number("0") + number("0") + number("0"), whole + "kill -SEGV $$",
          whole + "exit 1", whole + text("and more")})
        expect_in("its reader crashed", refused_by(script));
    expect_in("its reader was killed", refused_by(greet + "kill -KILL $$"));
    for (const char* signal : {"ALRM", "XCPU"})
        expect_in("did not come to an end", refused_by(greet + "kill -" + signal + " $$"));
}

TEST(IsolatedMesh, BlamesNoFileWhereTheReaderDoesNotStart) {
    for (const std::string& script : {std::string("exit 0"), std::string("kill -SEGV $$"),
                                      text("scb mesh"), text("noise noise noise")}) {
        const FakeReader fake(script);
        const std::string file = fake.folder.write("good.obj", triangle_obj);
        EXPECT_THROW(load_mesh(file), MeshReaderError) << script;
    }
}

TEST(IsolatedMesh, SaysWhatEndedItsReaderFromOutside) {
    for (const std::string& script : {std::string("kill -KILL $$"), greet + "kill -INT $$",
                                      greet + "kill -TERM $$", greet + "kill -HUP $$"}) {
        const FakeReader fake(script);
        try {
            load_mesh(fake.folder.write("good.obj", triangle_obj));
            ADD_FAILURE() << script;
        } catch (const MeshReaderError& error) {
            const bool before = script.find("KILL") != script.npos;
            expect_in(
                before ? "did not start (Killed); check" : "its reader was ended by a signal (",
                error.what());
        }
    }
}

TEST(IsolatedMesh, IsNeverReplacedByReadingInThisProcess) {
    const TemporaryFolder folder;
    const std::string file = folder.write("good.obj", triangle_obj);
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

TEST(IsolatedMesh, ServesSeveralThreads) {
    const TemporaryFolder folder;
    const std::string file = folder.write("good.obj", triangle_obj);
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
