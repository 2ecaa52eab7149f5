#include "scenes/scene/model_json.h"

#include <algorithm>
#include <array>
#include <limits>

#include "scb/error.h"
#include "scenes/scene/model_file.h"
#include "scenes/shapes/procedural.h"
#include "scenes/shapes/torus_knot.h"

namespace scb::scenes {
namespace {

/// Optional fields; the functions that make meshes check the ranges of their parameters.
void read_if(const JsonPlace& place, const char* name, int& value) {
    constexpr std::int64_t low = std::numeric_limits<int>::min(),
                           high = std::numeric_limits<int>::max();
    if (has(place, name)) value = static_cast<int>(read_integer(field(place, name), low, high));
}

void read_if(const JsonPlace& place, const char* name, double& value) {
    if (has(place, name)) value = read_number(field(place, name));
}

void read_if(const JsonPlace& place, const char* name, bool& value) {
    if (has(place, name)) value = read_bool(field(place, name));
}

Mesh read_icosphere(const JsonPlace& place) {
    check_fields(place, {"subdivisions", "radius"});
    int subdivisions = 0;
    double radius = 1;
    field(place, "subdivisions");
    read_if(place, "subdivisions", subdivisions);
    read_if(place, "radius", radius);
    return icosphere(subdivisions, radius);
}

Mesh read_torus_knot(const JsonPlace& place) {
    check_fields(place, {"p", "q", "major_radius", "minor_radius", "tube_radius", "sides", "rings",
                         "offset", "offset_turns"});
    TorusKnot knot;
    read_if(place, "p", knot.p);
    read_if(place, "q", knot.q);
    read_if(place, "major_radius", knot.major_radius);
    read_if(place, "minor_radius", knot.minor_radius);
    read_if(place, "tube_radius", knot.tube_radius);
    read_if(place, "sides", knot.sides);
    read_if(place, "rings", knot.rings);
    read_if(place, "offset", knot.offset);
    read_if(place, "offset_turns", knot.offset_turns);
    return torus_knot_mesh(knot);
}

Mesh read_box(const JsonPlace& place) {
    check_fields(place, {"size", "subdivisions"});
    BoxShape shape;
    if (has(place, "size")) shape.size = read_vec3(field(place, "size"));
    read_if(place, "subdivisions", shape.subdivisions);
    return box_mesh(shape);
}

Mesh read_plane(const JsonPlace& place) {
    check_fields(place, {"size", "cells"});
    PlaneShape shape;
    if (has(place, "size")) {
        const JsonPlace size = field(place, "size");
        if (array_size(size, "two numbers") != 2) refuse_value(size, "two numbers");
        shape.size_x = read_number(element(size, 0));
        shape.size_y = read_number(element(size, 1));
    }
    if (has(place, "cells")) {
        const JsonPlace cells = field(place, "cells");
        if (array_size(cells, "two whole numbers") != 2) refuse_value(cells, "two whole numbers");
        shape.cells_x =
            static_cast<int>(read_integer(element(cells, 0), 1, max_procedural_triangles));
        shape.cells_y =
            static_cast<int>(read_integer(element(cells, 1), 1, max_procedural_triangles));
    }
    return plane_mesh(shape);
}

template <class Shape>
Shape read_round(const JsonPlace& place) {
    check_fields(place, {"radius", "height", "sides", "segments", "capped"});
    Shape shape;
    read_if(place, "radius", shape.radius);
    read_if(place, "height", shape.height);
    read_if(place, "sides", shape.sides);
    read_if(place, "segments", shape.segments);
    read_if(place, "capped", shape.capped);
    return shape;
}

Mesh read_cone(const JsonPlace& place) { return cone_mesh(read_round<ConeShape>(place)); }
Mesh read_cylinder(const JsonPlace& place) {
    return cylinder_mesh(read_round<CylinderShape>(place));
}

Mesh read_soup(const JsonPlace& place) {
    check_fields(place, {"count", "size", "triangle_size", "seed"});
    SoupShape shape;
    read_if(place, "count", shape.count);
    read_if(place, "size", shape.size);
    read_if(place, "triangle_size", shape.triangle_size);
    // Up to 2^53, all readers of JSON read the same number.
    if (has(place, "seed"))
        shape.seed = static_cast<std::uint64_t>(
            read_integer(field(place, "seed"), 0, std::int64_t{1} << 53));
    return soup_mesh(shape);
}

struct Shape {
    const char* field;
    Mesh (*read)(const JsonPlace&);
};

constexpr Shape shapes[] = {
    {"icosphere", read_icosphere},
    {"torus_knot", read_torus_knot},
    {"box", read_box},
    {"plane", read_plane},
    {"cone", read_cone},
    {"cylinder", read_cylinder},
    {"soup", read_soup},
};

/// Vertices that no triangle uses do not count for the box.
void fit_unit_box(Mesh& mesh, const JsonPlace& place) {
    const Box box = bounding_box(mesh);
    const Vec3 size = box.upper - box.lower, center = 0.5 * (box.lower + box.upper);
    const double longest = size.maxCoeff();
    if (!(longest > 0))
        refuse(place, "the mesh is a single point, which has no box to normalize; leave this out.");
    for (Vec3& v : mesh.vertices) v = (v - center) / longest;
}

void store_rotated(Mesh& mesh, const JsonPlace& place) {
    check_fields(place, {"axis", "degrees"});
    const Mat3 turn = rotation_about(read_direction(field(place, "axis")),
                                     read_number(field(place, "degrees"), -1e6, 1e6));
    const Mat3 back = turn.transpose();
    for (Vec3& v : mesh.vertices) v = rotate(back, v);
}

/// The mesh, repeated along the axes; copies share no vertex.
void repeat(Mesh& mesh, const JsonPlace& place) {
    check_fields(place, {"count", "step"});
    const JsonPlace counts = field(place, "count");
    if (array_size(counts, "three whole numbers") != 3) refuse_value(counts, "three whole numbers");
    const Vec3 step = read_vec3(field(place, "step"));
    std::array<std::int64_t, 3> count;
    std::int64_t all = 1;
    for (std::size_t i = 0; i < 3; ++i) {
        count[i] = read_integer(element(counts, i), 1, max_procedural_triangles);
        all = std::min<std::int64_t>(all * count[i], max_procedural_triangles + 1);
    }
    const auto most = static_cast<std::size_t>(max_procedural_triangles);
    const std::size_t largest = std::max(mesh.triangles.size(), mesh.vertices.size());
    if (largest > most / static_cast<std::size_t>(all))
        refuse(counts, "more than " + std::to_string(most) +
                           " triangles or vertices; give smaller numbers.");
    const Mesh one = std::move(mesh);
    mesh = {};
    for (std::int64_t z = 0; z < count[2]; ++z)
        for (std::int64_t y = 0; y < count[1]; ++y)
            for (std::int64_t x = 0; x < count[0]; ++x) {
                const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
                const Vec3 by(static_cast<double>(x) * step[0], static_cast<double>(y) * step[1],
                              static_cast<double>(z) * step[2]);
                for (const Vec3& v : one.vertices) mesh.vertices.push_back(v + by);
                for (const Triangle& t : one.triangles)
                    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
            }
}

NamedMesh read_source(const JsonPlace& place, const SceneContext& context) {
    const Shape* chosen = nullptr;
    int sources = has(place, "file") ? 1 : 0;
    for (const Shape& shape : shapes) {
        if (!has(place, shape.field)) continue;
        chosen = &shape;
        ++sources;
    }
    if (sources != 1)
        refuse(place,
               "expected exactly one of file, icosphere, torus_knot, box, plane, cone, cylinder, "
               "soup, found " +
                   std::to_string(sources) + ".");
    if (!chosen) return read_model_file(place, context);
    for (const char* name : model_file_fields)
        if (has(place, name))
            refuse(field(place, name),
                   "this describes a mesh file, but the model is made by formula; leave it out.");
    const JsonPlace shape = field(place, chosen->field);
    // Errors of readers already begin with the place, but not errors of the functions that make
    // meshes.
    try {
        return {"", chosen->read(shape)};
    } catch (const InputError& error) {
        const std::string sentence = error.what();
        if (sentence.rfind(shape.file + ": ", 0) == 0) throw;
        refuse(shape, sentence);
    }
}

}  // namespace

NamedMesh read_model(const JsonPlace& place, const SceneContext& context) {
    check_fields(place, {"name", "file", "vertices", "triangles", "published", "icosphere",
                         "torus_knot", "box", "plane", "cone", "cylinder", "soup", "normalize",
                         "scale", "copies", "stored_rotation"});
    std::string name = read_plain_text(field(place, "name"));
    NamedMesh model = read_source(place, context);
    model.name = std::move(name);
    if (has(place, "normalize")) {
        const JsonPlace normalize = field(place, "normalize");
        if (read_text(normalize) != "unit-box") refuse_value(normalize, "\"unit-box\"");
        fit_unit_box(model.mesh, normalize);
    }
    if (has(place, "scale")) {
        const double scale = read_positive(field(place, "scale"));
        for (Vec3& v : model.mesh.vertices) v *= scale;
    }
    if (has(place, "copies")) repeat(model.mesh, field(place, "copies"));
    if (has(place, "stored_rotation")) store_rotated(model.mesh, field(place, "stored_rotation"));
    check_mesh(model.mesh, place.file + ": " + place.path);
    return model;
}

}  // namespace scb::scenes
