#include "scenes/meshes/tds_check.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "scb/error.h"
#include "scenes/meshes/little_endian.h"

namespace scb::scenes {
namespace {

/// A file is nested chunks: an id of 16 bits, the size of the whole chunk in 32 bits, and its
/// content (the ids of Autodesk's 3D Studio).
constexpr std::uint32_t file_id = 0x4d4d, scene_id = 0x3d3d, object_id = 0x4000, mesh_id = 0x4100,
                        vertices_id = 0x4110, faces_id = 0x4120;

class Check {
  public:
    explicit Check(const std::string& name) : name_(name) {}

    void run(std::string_view chunks) {
        constexpr std::size_t head = 6;
        while (chunks.size() >= head) {
            const std::uint32_t id = little_endian(chunks, 0, 2),
                                size = little_endian(chunks, 2, 4);
            if (size < head) return;
            check_chunk(id, chunks.substr(head, size - head));
            chunks.remove_prefix(std::min<std::size_t>(size, chunks.size()));
        }
    }

  private:
    void check_chunk(std::uint32_t id, std::string_view inside) {
        if (id == file_id || id == scene_id) return run(inside);
        if (id == object_id && inside.find('\0') != inside.npos)
            return run(inside.substr(inside.find('\0') + 1));
        if (id == mesh_id) {
            // The vertices may be behind the faces.
            vertices_ = 0;
            faces_ = {};
            run(inside);
            for (const std::string_view faces : faces_) check_faces(faces);
            ++meshes_;
        }
        if (id == vertices_id) vertices_ += little_endian(inside, 0, 2);
        if (id == faces_id) faces_.push_back(inside);
    }

    void check_faces(std::string_view faces) const {
        constexpr std::size_t start = 2, face_size = 8;
        const std::size_t count = little_endian(faces, 0, 2);
        for (std::size_t f = 0; f < count && start + (f + 1) * face_size <= faces.size(); ++f)
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const std::uint32_t vertex =
                    little_endian(faces, start + f * face_size + 2 * corner, 2);
                if (vertex >= vertices_)
                    throw InputError(name_ + ": mesh " + std::to_string(meshes_) + ", face " +
                                     std::to_string(f) + " names vertex " + std::to_string(vertex) +
                                     ", but there are " + std::to_string(vertices_) +
                                     " vertices, numbered from 0; repair the index.");
            }
    }

    const std::string& name_;
    std::vector<std::string_view> faces_;  ///< of the current mesh
    std::uint32_t vertices_ = 0;
    std::size_t meshes_ = 0;
};

}  // namespace

void check_3ds(std::string_view bytes, const std::string& name) { Check(name).run(bytes); }

}  // namespace scb::scenes
