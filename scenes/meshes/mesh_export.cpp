#include "scenes/meshes/mesh_export.h"

#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <cmath>
#include <limits>
#include <new>

#include "core/base/text_format.h"
#include "scb/error.h"

namespace scb::scenes {
namespace {

struct Format {
    const char* extension;
    const char* assimp_id;
};
// PLY as text: the binary writer of assimp 5.2 breaks files with colors.
constexpr Format formats[] = {
    {".ply", "ply"}, {".obj", "objnomtl"}, {".glb", "glb2"}, {".stl", "stlb"}};

const char* format_of(const std::filesystem::path& path) {
    for (const Format& format : formats)
        if (path.extension() == format.extension) return format.assimp_id;
    throw InputError(path.string() + ": cannot write '" + path.extension().string() +
                     "' files; name the file .ply, .obj, .glb or .stl.");
}

void check_range(const ExportPart& part, const std::string& name) {
    constexpr double most = std::numeric_limits<float>::max(),
                     least = std::numeric_limits<float>::min();
    double largest = 0;
    for (const Vec3& v : part.mesh.vertices)
        for (const double coordinate : v) {
            largest = std::max(largest, std::abs(coordinate));
            if (!(std::abs(coordinate) <= most))
                throw InputError(name + ": " + part.name + " has the coordinate " +
                                 exact_number(coordinate) +
                                 ", but mesh files hold at most 3.4e38; scale the mesh down.");
        }
    if (largest > 0 && largest < least)
        throw InputError(name + ": " + part.name + " has no coordinate above " +
                         exact_number(largest) +
                         ", but mesh files hold none below 1.2e-38; scale the mesh up.");
}

aiVector3D vector_of(const Vec3& v) {
    return {static_cast<ai_real>(v[0]), static_cast<ai_real>(v[1]), static_cast<ai_real>(v[2])};
}

// The scene owns its parts, so everything is made with new, as assimp requires.
aiMesh* mesh_of(const ExportPart& part, unsigned material) {
    auto* mesh = new aiMesh;
    mesh->mName = part.name;
    mesh->mMaterialIndex = material;
    mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    mesh->mNumVertices = static_cast<unsigned>(part.mesh.vertices.size());
    mesh->mVertices = new aiVector3D[mesh->mNumVertices];
    mesh->mColors[0] = new aiColor4D[mesh->mNumVertices];
    for (unsigned i = 0; i < mesh->mNumVertices; ++i) {
        mesh->mVertices[i] = vector_of(part.mesh.vertices[i]);
        mesh->mColors[0][i] = {part.color[0], part.color[1], part.color[2], 1};
    }
    mesh->mNumFaces = static_cast<unsigned>(part.mesh.triangles.size());
    mesh->mFaces = new aiFace[mesh->mNumFaces];
    for (unsigned i = 0; i < mesh->mNumFaces; ++i) {
        const Triangle& t = part.mesh.triangles[i];
        mesh->mFaces[i].mNumIndices = 3;
        mesh->mFaces[i].mIndices = new unsigned[3]{t[0], t[1], t[2]};
    }
    return mesh;
}

aiMaterial* material_of(const ExportPart& part) {
    auto* material = new aiMaterial;
    const aiString name(part.name);
    const aiColor3D color(part.color[0], part.color[1], part.color[2]);
    material->AddProperty(&name, AI_MATKEY_NAME);
    material->AddProperty(&color, 1, AI_MATKEY_COLOR_DIFFUSE);
    return material;
}

}  // namespace

std::vector<std::uint8_t> encode_mesh(const std::vector<ExportPart>& parts,
                                      const std::filesystem::path& path) {
    const char* format = format_of(path);
    for (const ExportPart& part : parts) check_range(part, path.string());
    aiScene scene;
    const auto count = static_cast<unsigned>(parts.size());
    scene.mNumMeshes = scene.mNumMaterials = count;
    scene.mMeshes = new aiMesh*[count];
    scene.mMaterials = new aiMaterial*[count];
    scene.mRootNode = new aiNode("scb");
    std::vector<aiNode*> nodes(count);
    for (unsigned i = 0; i < count; ++i) {
        scene.mMeshes[i] = mesh_of(parts[i], i);
        scene.mMaterials[i] = material_of(parts[i]);
        nodes[i] = new aiNode(parts[i].name);
        nodes[i]->mNumMeshes = 1;
        nodes[i]->mMeshes = new unsigned[1]{i};
    }
    // The writer of GLB joins the meshes of one node, so every part gets its own.
    scene.mRootNode->addChildren(count, nodes.data());
    Assimp::Exporter exporter;
    const aiExportDataBlob* blob = exporter.ExportToBlob(&scene, format);
    // The scene is checked, and the output is in memory, so a writer fails only if memory runs out,
    // and then gives no reason or an odd one.
    if (blob == nullptr) throw std::bad_alloc();
    const auto* bytes = static_cast<const std::uint8_t*>(blob->data);
    return {bytes, bytes + blob->size};
}

}  // namespace scb::scenes
