#include "scenes/meshes/mesh_reader.h"

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

TEST(MeshReader, GivesWhatAssimpGives) {
    const TemporaryFolder folder;
    const Mesh mesh = isolated_mesh(folder.write("a.obj", triangle_obj));
    EXPECT_EQ(mesh.vertices, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(MeshReader, PassesRefusalsOn) {
    const TemporaryFolder folder;
    const std::string file = folder.write("notes.xyz", "this is not a mesh\n");
    expect_in("the format is not known", refusal([&] { isolated_mesh(file); }));
}

TEST(MeshReader, ThatCrashesOrIsCutShortTakesNothingWithIt) {
    // The head of an answer: 13 characters, or three vertices and a triangle.
    const std::string magic = "printf 'scb-mesh-1\\0\\0'", to = " >&3; ";
    const std::string sentence = magic + to + "printf '\\1\\0\\0\\0'" + to +
                                 "printf '\\15\\0\\0\\0\\0\\0\\0\\0'" + to +
                                 "printf '\\0\\0\\0\\0\\0\\0\\0\\0'" + to;
    const std::string huge = magic + to + "printf '\\0\\0\\0\\0'" + to +
                             "printf '\\377\\377\\377\\377\\377\\377\\377\\377'" + to +
                             "printf '\\0\\0\\0\\0\\0\\0\\0\\0'" + to;
    const std::string good = sentence + "printf 'not this one.'" + to;
    EXPECT_THROW(
        {
            const FakeReader fake(good);
            isolated_mesh(fake.folder.write("good.obj", triangle_obj));
        },
        InputError);
    for (const std::string& script :
         {std::string("kill -SEGV $$"), std::string("kill -ABRT $$"), std::string("exit 0"),
          std::string("printf 'scb-mesh-1'") + to, std::string("printf 'noise %1000d' 1") + to,
          sentence + "printf 'too short'" + to, huge, good + "kill -SEGV $$", good + "exit 1",
          good + "printf 'and more'" + to})
        expect_in("its reader crashed", refused_by(script));
}

TEST(MeshReader, IsNeverReplacedByReadingInThisProcess) {
    const TemporaryFolder folder;
    const std::string file = folder.write("good.obj", triangle_obj);
    set_mesh_reader(folder / "gone");
    EXPECT_THROW(load_mesh(file), std::filesystem::filesystem_error);
    set_mesh_reader({});
    EXPECT_EQ(load_mesh(file).triangles.size(), 1u);
}

TEST(MeshReader, ServesSeveralThreads) {
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
