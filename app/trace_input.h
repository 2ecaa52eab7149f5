#pragma once

#include <string>

#include "scenes/trace_file.h"

namespace scb {

/// A trace file that is read frame by frame.
struct TraceInput {
    std::string bytes;
    TraceReader reader;

    /// Throws InputError where the file cannot be read or is no valid trace.
    explicit TraceInput(const std::string& path);
    TraceInput(const TraceInput&) = delete;
    TraceInput& operator=(const TraceInput&) = delete;
};

/// Whether a command that takes a scene or a trace was given a trace: by its ending `.scbtrace`, or
/// by its first bytes.
bool names_trace(const std::string& path);

}  // namespace scb
