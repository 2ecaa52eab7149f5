#include "scenes/meshes/mesh_reader.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <optional>
#include <span>

#include "core/base/exit_status.h"
#include "core/platform/file_bytes.h"
#include "scb/error.h"
#include "scenes/meshes/assimp_mesh.h"
#include "scenes/meshes/collada_plain.h"
#include "scenes/meshes/confinement.h"
#include "scenes/meshes/gltf_plain.h"
#include "scenes/meshes/mesh_answer.h"
#include "scenes/meshes/tds_check.h"
#include "scenes/meshes/three_mf_check.h"

namespace scb::scenes {
namespace {

template <class T>
bool write_all(std::span<const T> values) {
    std::span<const std::byte> bytes = std::as_bytes(values);
    while (!bytes.empty()) {
        const ssize_t written = ::write(mesh_answer_descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
}

bool write_sentence(MeshAnswer::Kind kind, const std::string& sentence) {
    const MeshAnswer answer{kind, sentence.size(), 0, 0};
    return write_all(std::span(&answer, 1)) && write_all(std::span<const char>(sentence));
}

bool write_mesh(const AssimpMesh& read) {
    const Mesh& mesh = read.mesh;
    std::string names;
    for (const std::string& name : read.side_files) names.append(name).push_back('\0');
    names.push_back('\0');
    for (const std::string& name : read.left_out) names.append(name).push_back('\0');
    const MeshAnswer answer{MeshAnswer::mesh, mesh.vertices.size(), mesh.triangles.size(),
                            names.size()};
    return write_all(std::span(&answer, 1)) && write_all(std::span<const Vec3>(mesh.vertices)) &&
           write_all(std::span<const Triangle>(mesh.triangles)) &&
           write_all(std::span<const char>(names));
}

/// Whether the word is in the text, in upper or lower case letters.
bool has_word(std::string start, std::string_view word) {
    for (char& c : start)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return start.find(word) != start.npos;
}

/// Reads a mesh after the checks that assimp's readers of these formats lack. Formats are
/// recognized by content as well as by name, as in assimp.
AssimpMesh checked_mesh(const std::string& path) {
    allow_for(std::filesystem::file_size(path));
    // assimp treats a backslash as a slash, so side files would come from another folder.
    if (path.find('\\') != path.npos)
        throw InputError(path +
                         ": a backslash in the path of a mesh is not understood; rename it.");
    const std::string start = file_bytes(path, 4096), extension = lower_case_extension(path);
    const std::size_t first = start.find_first_not_of(" \t\r\n");
    std::optional<PlainFile> plain;
    std::string ending;
    const bool is_glb = start.starts_with("glTF");
    if (extension == ".gltf" || extension == ".glb" || is_glb ||
        (first != start.npos && start[first] == '{')) {
        plain = plain_gltf(file_bytes(path), path);
        // assimp distinguishes the two by their ending.
        const std::string known = is_glb ? ".glb" : ".gltf";
        if (plain && extension != known) ending = known;
    }
    if (extension == ".zae")
        throw InputError(path + ": packed COLLADA is not read; unpack it, and give the .dae.");
    if (extension == ".dae" || has_word(start, "<collada"))
        plain = plain_collada(file_bytes(path), path);
    if (extension == ".stlb") ending = ".stl";
    if (extension == ".3ds" || extension == ".prj" || start.starts_with("MM"))
        check_3ds(file_bytes(path), path);
    if (extension == ".3mf" || start.starts_with("PK")) check_3mf(path);
    return assimp_mesh(path, plain, ending);
}

/// Whether the answer was written.
bool answer_for(const std::string& path) {
    try {
        const AssimpMesh mesh = checked_mesh(path);
        // Now it waits for the starting process, which may be stopped.
        ::alarm(0);
        return write_mesh(mesh);
    } catch (const InputError& error) {
        return write_sentence(MeshAnswer::refusal, error.what());
    } catch (const std::bad_alloc&) {
        const AddressSpace space = address_space();
        const std::string size = std::to_string(space.bytes >> 20) + " MiB";
        if (space.inherited)
            return write_sentence(MeshAnswer::limited,
                                  path + ": needs more memory than there is (" + size +
                                      "); give a smaller mesh, or a higher limit (ulimit -v).");
        return write_sentence(MeshAnswer::refusal,
                              path + ": needs more memory than a file of its size may take (" +
                                  size + "); give a smaller mesh, or repair its counts.");
    } catch (const std::exception& error) {
        return write_sentence(MeshAnswer::failure, error.what());
    }
}

}  // namespace

int run_mesh_reader(const std::string& path) {
    struct stat answers {};
    if (::fstat(mesh_answer_descriptor, &answers) != 0 || !S_ISFIFO(answers.st_mode)) {
        std::fprintf(stderr, "scb: error: %s is for scb itself; see `scb --help`.\n",
                     mesh_reader_command);
        return exit_bad_input;
    }
    const std::string unconfined = confine_this_process(mesh_answer_descriptor);
    const bool done = write_all(std::span<const char>(mesh_greeting)) &&
                      (unconfined.empty() ? answer_for(path)
                                          : write_sentence(MeshAnswer::unconfined, unconfined));
    return done ? exit_done : exit_environment;
}

}  // namespace scb::scenes
