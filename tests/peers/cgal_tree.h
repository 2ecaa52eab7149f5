#pragma once

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "tests/peers/relative_pose.h"

namespace scb {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalTriangle = CgalKernel::Triangle_3;
using CgalTriangles = std::vector<CgalTriangle>;
using CgalPrimitive = CGAL::AABB_triangle_primitive<CgalKernel, CgalTriangles::const_iterator>;
using CgalTraits = CGAL::AABB_traits<CgalKernel, CgalPrimitive>;
using CgalTree = CGAL::AABB_tree<CgalTraits>;
using CgalNode = CGAL::AABB_node<CgalTraits>;

/// Replaces `triangles` by the triangles of the mesh at the pose.
inline void place(const PeerMesh& mesh, const PeerPose& pose, CgalTriangles& triangles) {
    std::vector<CgalKernel::Point_3> points;
    points.reserve(mesh.vertices.size());
    for (const auto& v : mesh.vertices) {
        const auto [x, y, z] = place(pose, v);
        points.emplace_back(x, y, z);
    }
    triangles.clear();
    for (const auto& t : mesh.triangles)
        triangles.emplace_back(points[t[0]], points[t[1]], points[t[2]]);
}

}  // namespace scb
