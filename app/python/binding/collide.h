#pragma once

#include "app/python/binding/arrays.h"
#include "app/python/binding/hierarchy.h"
#include "scb/any_collide.h"

namespace scb::python {

/// The result of a query, for Python.
struct FoundPairs {
    py::array pairs;
    std::uint64_t n_v = 0, n_p = 0, n_u = 0;
    py::dict stages;
    int depth = 0;
    bool complete = true;
};

/// Moves the pairs out of `found`.
FoundPairs found_pairs(Collision&& found, VolumeKind kind, const OverlapOptions& options);
/// The stages at which tests of these volumes end, "overlapping" first.
std::vector<Stage> endings_of(VolumeKind kind, const OverlapOptions& options);

void add_collide(py::module_& module);

}  // namespace scb::python
