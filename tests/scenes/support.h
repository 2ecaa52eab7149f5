#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>

#include "scb/error.h"
#include "scb/mesh.h"
#include "tests/temporary_folder.h"

namespace scb::scenes {

/// The sentence of the InputError that `action` throws; empty, and a failure, where it throws none.
template <class Action>
std::string refusal(Action action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    ADD_FAILURE() << "nothing was refused";
    return {};
}

inline void expect_in(const std::string& part, const std::string& whole) {
    EXPECT_NE(whole.find(part), std::string::npos)
        << "\"" << part << "\" is not in \"" << whole << "\"";
}

/// Expects that every edge is used exactly twice, in opposite directions.
inline void expect_closed(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    std::size_t bad = 0;
    for (const auto& [edge, count] : edges) {
        const auto opposite = edges.find({edge.second, edge.first});
        if (count != 1 || opposite == edges.end()) ++bad;
    }
    EXPECT_EQ(bad, 0u) << "edges that are not used once in each direction";
}

/// Twice the triangle's area seen from +z, negative where it is clockwise from there.
inline double area2_from_above(const Mesh& mesh, const Triangle& t) {
    const Vec3 u = mesh.vertices[t[1]] - mesh.vertices[t[0]],
               v = mesh.vertices[t[2]] - mesh.vertices[t[0]];
    return u[0] * v[1] - u[1] * v[0];
}

/// Six times the volume that a closed mesh encloses, positive where triangles are counterclockwise
/// from outside.
inline double signed_volume6(const Mesh& mesh) {
    double sum = 0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return sum;
}

}  // namespace scb::scenes
