#pragma once

#include "scb/fit.h"
#include "scb/topology.h"

namespace scb {

/// How a hierarchy is built.
struct BuildOptions {
    /// How its volumes are fitted.
    FitOptions fit{};
    /// How its nodes are divided.
    SplitMethod split = SplitMethod::section_3;
    /// How many threads build it; it is the same for any number.
    int threads = 1;

    TopologyOptions topology() const { return {split, threads}; }
};

}  // namespace scb
