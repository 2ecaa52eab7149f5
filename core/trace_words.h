#pragma once

#include <string>

#include "core/trace_diff.h"

namespace scb {

/// "rejected at slab-cylinder", "overlap: A's node was divided", "overlap: the triangles (17, 4)
/// intersect", ... What a test gave and what it led to.
std::string words_of(const TracedTest& test);

/// "the nodes (12, 33) at depths (4, 5)".
std::string words_of(const VolumeTest& test);

/// "reached from the nodes (5, 33) at depths (3, 5), where A's node was divided", or "the roots".
std::string words_of_parent(const TracedTest& test);

/// The same as three or four lines that end with line ends: the place, what A did, what B did, and
/// where they came from.
std::string words_of(const Parting& parting);

}  // namespace scb
