#pragma once

#include <array>
#include <memory>

#include "tests/peers/peer.h"

namespace scb {

/// A library with the tree of a mesh, ready for distances of points to its nearest triangle.
class PointPeer {
  public:
    virtual ~PointPeer() = default;
    virtual double distance(const std::array<double, 3>& point) = 0;
};

std::unique_ptr<PointPeer> cgal_point_peer(const PeerMesh& mesh);
/// Embree finds the triangles near a point in floats; their distances are computed in doubles, for
/// corners that are rounded to floats.
std::unique_ptr<PointPeer> embree_point_peer(const PeerMesh& mesh);

}  // namespace scb
