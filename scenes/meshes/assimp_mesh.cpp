#include "scenes/meshes/assimp_mesh.h"

#include <assimp/config.h>
#include <assimp/scene.h>

#include <Eigen/Geometry>
#include <assimp/Importer.hpp>
#include <filesystem>
#include <vector>

#include "core/platform/tokens.h"
#include "scb/error.h"
#include "scb/pose.h"
#include "scenes/meshes/mesh_folder.h"
#include "scenes/meshes/polygon.h"

namespace scb::scenes {
namespace {

/// assimp's message on one line of plain characters, without a dot at the end.
std::string plain_message(std::string message) {
    for (char& c : message)
        if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = ' ';
    const std::size_t first = message.find_first_not_of(' '), last = message.find_last_not_of(" .");
    message = first == std::string::npos || last == std::string::npos
                  ? "no reason given"
                  : message.substr(first, last + 1 - first);
    if (message.size() > 200) message = message.substr(0, 197) + "...";
    return message;
}

/// A node's transform to the world, in double: column-vector convention, last row (0, 0, 0, 1).
struct Affine {
    Mat3 linear = Mat3::Identity();
    Vec3 offset = Vec3::Zero();

    Vec3 operator()(const Vec3& point) const {
        // A product with the identity would spread one NaN to all three coordinates.
        if (linear == Mat3::Identity()) return point + offset;
        return rotate(linear, point) + offset;
    }
};

Affine followed_by(const Affine& parent, const aiMatrix4x4& m) {
    Mat3 linear;
    linear << m.a1, m.a2, m.a3, m.b1, m.b2, m.b3, m.c1, m.c2, m.c3;
    const Vec3 offset(m.a4, m.b4, m.c4);
    Affine result;
    for (int j = 0; j < 3; ++j) result.linear.col(j) = rotate(parent.linear, Vec3(linear.col(j)));
    result.offset = parent(offset);
    return result;
}

struct Placed {
    unsigned mesh = 0;
    Affine to_world;
};

/// Every mesh without a transform, for RAW files. assimp 5.2 keeps only one node of their groups,
/// which have no transforms, and null pointers for the others.
std::vector<Placed> meshes_as_they_are(const aiScene& scene) {
    std::vector<Placed> placed(scene.mNumMeshes);
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) placed[i].mesh = i;
    return placed;
}

/// The meshes of the scene's nodes in the order of a walk from the root; a loop, since files may
/// nest nodes deeply.
std::vector<Placed> placed_meshes(const aiScene& scene, const std::string& name) {
    struct Visit {
        const aiNode* node;
        Affine parent;
    };
    std::vector<Placed> placed;
    std::vector<Visit> stack;
    if (scene.mRootNode) stack.push_back({scene.mRootNode, {}});
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        const Affine to_world = followed_by(visit.parent, visit.node->mTransformation);
        for (unsigned i = 0; i < visit.node->mNumMeshes; ++i) {
            const unsigned mesh = visit.node->mMeshes[i];
            if (mesh >= scene.mNumMeshes)
                throw InputError(name + ": node \"" + plain_message(visit.node->mName.C_Str()) +
                                 "\" names a mesh that does not exist; repair the file.");
            placed.push_back({mesh, to_world});
        }
        for (unsigned i = visit.node->mNumChildren; i > 0; --i) {
            if (!visit.node->mChildren[i - 1]) return meshes_as_they_are(scene);
            stack.push_back({visit.node->mChildren[i - 1], to_world});
        }
    }
    return placed;
}

void append(const aiMesh& source, const Affine& to_world, const std::string& name,
            PolygonCutter& cutter, Mesh& mesh) {
    const std::size_t first_vertex = mesh.vertices.size(), first_triangle = mesh.triangles.size();
    for (unsigned i = 0; i < source.mNumVertices; ++i) {
        const aiVector3D& v = source.mVertices[i];
        mesh.vertices.push_back(to_world(Vec3(v.x, v.y, v.z)));
    }
    std::vector<std::uint32_t> corners;
    for (unsigned f = 0; f < source.mNumFaces; ++f) {
        const aiFace& face = source.mFaces[f];
        if (face.mNumIndices < 3) continue;
        corners.clear();
        for (unsigned i = 0; i < face.mNumIndices; ++i) {
            if (face.mIndices[i] >= source.mNumVertices)
                throw InputError(name + ": face " + std::to_string(f) + " names vertex " +
                                 std::to_string(face.mIndices[i]) + ", but there are " +
                                 std::to_string(source.mNumVertices) +
                                 " vertices; repair the index.");
            corners.push_back(static_cast<std::uint32_t>(first_vertex + face.mIndices[i]));
        }
        if (corners.size() == 3)  // for speed: no name is made
            mesh.triangles.push_back({corners[0], corners[1], corners[2]});
        else
            cutter.append(corners, mesh.vertices, name + ": face " + std::to_string(f),
                          mesh.triangles);
    }
    const Mat3& m = to_world.linear;
    const bool mirrored = dot(Vec3(m.col(0).cross(m.col(1))), Vec3(m.col(2))) < 0;
    if (mirrored)
        for (std::size_t t = first_triangle; t < mesh.triangles.size(); ++t)
            std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
}

/// An instance takes a few bytes in a file, but a whole mesh in this program, so the sum is checked
/// before any allocation.
void check_sums(const aiScene& scene, const std::vector<Placed>& placed, const std::string& name) {
    constexpr std::size_t most = std::size_t{1} << 28;
    std::vector<std::size_t> corners_of(scene.mNumMeshes, 0);
    for (unsigned m = 0; m < scene.mNumMeshes; ++m)
        for (unsigned f = 0; f < scene.mMeshes[m]->mNumFaces; ++f)
            corners_of[m] += scene.mMeshes[m]->mFaces[f].mNumIndices;
    std::size_t vertices = 0, corners = 0;
    for (const Placed& p : placed) {
        vertices += scene.mMeshes[p.mesh]->mNumVertices;
        corners += corners_of[p.mesh];
        if (vertices > most || corners > most)
            throw InputError(name + ": the instances of its meshes add up to more than " +
                             std::to_string(most) +
                             " vertices or corners of faces; give a smaller part of it.");
    }
}

Mesh joined(const aiScene& scene, const std::string& name) {
    const std::vector<Placed> placed = placed_meshes(scene, name);
    check_sums(scene, placed, name);
    Mesh mesh;
    PolygonCutter cutter;
    for (const Placed& p : placed) append(*scene.mMeshes[p.mesh], p.to_world, name, cutter, mesh);
    return mesh;
}

/// The parts of the scene that are not in its mesh.
std::vector<std::string> left_out_of(const aiScene& scene) {
    bool skins = false, targets = false;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        skins = skins || scene.mMeshes[m]->mNumBones > 0;
        targets = targets || scene.mMeshes[m]->mNumAnimMeshes > 0;
    }
    std::vector<std::string> left_out;
    if (skins) left_out.emplace_back("skins");
    if (targets) left_out.emplace_back("morph targets");
    return left_out;
}

}  // namespace

AssimpMesh assimp_mesh(const std::string& path, const std::optional<PlainFile>& plain,
                       const std::string& ending) {
    // Never freed: assimp frees the scenes of some files twice.
    static std::vector<Assimp::Importer*> kept;
    auto* const made = new Assimp::Importer;
    kept.push_back(made);
    Assimp::Importer& importer = *made;
    // assimp's readers of the first three drop vertices with some numbers, and trust counts. Its
    // readers of scenes read meshes named in these with all other readers, unchecked.
    for (const char* extension : {"obj", "ply", "off", "lws", "irr"})
        if (Assimp::BaseImporter* own = importer.GetImporter(extension))
            importer.UnregisterLoader(own);
    const std::string name = path + ending;
    auto* const folder = new MeshFolder(
        path, name, plain ? std::optional<std::string_view>(plain->bytes) : std::nullopt);
    importer.SetIOHandler(folder);  // the importer deletes it
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_ANIMATIONS, false);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_MD3_HANDLE_MULTIPART, false);
    // No post-processing: it reorders, welds, drops and repairs, which would change the counts.
    const aiScene* scene = importer.ReadFile(name, 0);
    if (!scene) {
        const std::string reason = importer.GetErrorString();
        if (reason.rfind("No suitable reader", 0) == 0)
            throw InputError(path + ": the format is not known; give a mesh as " + mesh_formats +
                             ".");
        std::string refused = folder->refused();
        const std::string missed = std::filesystem::path(folder->missed()).filename().string();
        if (refused.empty() && !missed.empty() && reason.find(missed) != reason.npos)
            refused = folder->missed();
        if (!refused.empty()) refuse_side_file(path, refused);
        if (reason == std::bad_alloc().what()) throw std::bad_alloc();
        throw InputError(path + ": cannot be read (" + plain_message(reason) +
                         "); export it again, or convert it to PLY or STL.");
    }
    if (!folder->refused().empty()) refuse_side_file(path, folder->refused());
    return {joined(*scene, path),
            {folder->opened().begin(), folder->opened().end()},
            plain ? plain->left_out : left_out_of(*scene)};
}

}  // namespace scb::scenes
