#include "scenes/meshes/mesh_file.h"

#include <exception>
#include <new>
#include <string>

#include "core/platform/file_bytes.h"
#include "core/platform/input_files.h"
#include "scb/error.h"
#include "scenes/meshes/assimp_mesh.h"
#include "scenes/meshes/isolated_mesh.h"
#include "scenes/meshes/obj_mesh.h"
#include "scenes/meshes/off_mesh.h"
#include "scenes/meshes/ply_mesh.h"

namespace scb::scenes {
namespace {

namespace fs = std::filesystem;

void check_file(const fs::path& path) {
    const std::string name = path.string();
    check_is_file(name);
    std::error_code error;
    if (fs::file_size(path, error) == 0 && !error)
        throw InputError(name + ": the file is empty; give a mesh as " + mesh_formats + ".");
}

/// By content as well as by name.
bool is_ply(const std::string& path) {
    if (lower_case_extension(path) == ".ply") return true;
    std::string start = file_bytes(path, 4);
    for (char& c : start)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return start.starts_with("ply") && start.find_first_of(" \t\r\n", 3) == 3;
}

/// By content only if the name has no known format.
bool is_off_file(const std::string& path, const std::string& extension) {
    return extension == ".off" || (extension != ".obj" && is_off(file_bytes(path, 4096)));
}

/// Refuses formats of CAD programs, whose surfaces are not triangles, and which this program cannot
/// read.
void refuse_cad(const std::string& path, const std::string& extension) {
    struct CadFormat {
        const char *extension, *name;
    };
    constexpr CadFormat cad_formats[] = {{".step", "STEP"},
                                         {".stp", "STEP"},
                                         {".p21", "STEP"},
                                         {".iges", "IGES"},
                                         {".igs", "IGES"},
                                         {".brep", "BREP"},
                                         {".brp", "BREP"},
                                         {".x_t", "Parasolid"},
                                         {".x_b", "Parasolid"},
                                         {".xmt_txt", "Parasolid"},
                                         {".sat", "ACIS"},
                                         {".sab", "ACIS"},
                                         {".jt", "JT"},
                                         {".sldprt", "SolidWorks"},
                                         {".sldasm", "SolidWorks"},
                                         {".catpart", "CATIA"},
                                         {".catproduct", "CATIA"},
                                         {".cgr", "CATIA"},
                                         {".ipt", "Inventor"},
                                         {".iam", "Inventor"},
                                         {".prt", "NX and Creo"},
                                         {".par", "Solid Edge"},
                                         {".fcstd", "FreeCAD"},
                                         {".3dm", "Rhino"},
                                         {".dwg", "DWG"},
                                         {".skp", "SketchUp"},
                                         {".f3d", "Fusion"}};
    for (const CadFormat& format : cad_formats)
        if (extension == format.extension)
            throw InputError(path + ": " + format.name +
                             " is a CAD format, which is not read; export a mesh as STL, PLY or "
                             "OBJ from the CAD program.");
}

Mesh read_mesh(const std::string& name) {
    const std::string extension = lower_case_extension(name);
    if (is_ply(name)) return ply_mesh(name);
    if (file_bytes(name, 4) == "glTF") return isolated_mesh(name);
    if (is_off_file(name, extension)) return off_mesh(name);
    if (extension == ".obj") return obj_mesh(name);
    refuse_cad(name, extension);
    return isolated_mesh(name);
}

}  // namespace

Mesh load_mesh(const fs::path& path) {
    const std::string name = path.string();
    check_file(path);
    note_input(path);
    try {
        // assimp's readers may crash on broken files.
        Mesh mesh = read_mesh(name);
        check_mesh(mesh, name);
        return mesh;
    } catch (const InputError&) {
        throw;
    } catch (const MeshReaderError&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw MeshReaderError(name +
                              ": needs more memory than there is; give a smaller mesh, or a higher "
                              "limit (ulimit -v).");
    } catch (const std::exception& error) {
        throw InputError(name + ": cannot be read (" + error.what() +
                         "); repair the file or export it again.");
    }
}

}  // namespace scb::scenes
