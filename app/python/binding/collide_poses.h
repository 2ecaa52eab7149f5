#pragma once

#include <vector>

#include "app/python/binding/arrays.h"
#include "scb/collide.h"

namespace scb::python {

/// The pairs that queries at several poses found.
struct PairsAtPoses {
    py::array pairs;    ///< n x 2, pose after pose
    py::array offsets;  ///< the index at which each pose's pairs begin, and the end

    /// Takes the pairs of each pose.
    void set(std::vector<std::vector<IndexPair>>&& of_poses);
    /// The number of poses.
    py::ssize_t size() const { return offsets.shape(0) - 1; }
    /// The pairs of a pose; negative indices count from the end. Raises IndexError.
    py::array pairs_of(std::int64_t index) const;
};

void add_collide_poses(py::module_& module);

}  // namespace scb::python
