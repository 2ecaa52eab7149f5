#pragma once

#include <string>

#include "core/analysis/trace.h"
#include "scenes/recordings/byte_stream.h"

namespace scb::scenes {

// The answer of a traced query for the smallest distance: the distance, its triangles and points.

/// A frame with `nearest` must have its pair of triangles.
void write_answer(ByteWriter& out, const QueryTrace& frame);

/// Reads the answer into the frame, which must have its tests of triangles. Adds the test of the
/// seed to its count of tests of triangles. Returns the error as a clause, or an empty text.
std::string read_answer(ByteReader& in, const TraceHeader& header, QueryTrace& frame);

}  // namespace scb::scenes
