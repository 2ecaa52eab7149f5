#pragma once

#include <string>
#include <vector>

#include "scenes/traces/trace_file.h"

namespace scb::scenes {

/// A trace file that is read frame by frame.
struct TraceInput {
    std::string bytes;
    TraceReader reader;

    /// Throws InputError if the file cannot be read or is not a valid trace.
    explicit TraceInput(const std::string& path);
    TraceInput(const TraceInput&) = delete;
    TraceInput& operator=(const TraceInput&) = delete;
};

/// The frames of a trace that the list names, see parse_frames; all frames if the list asks for
/// all. Throws InputError if the file is not a valid trace or has no such frame.
std::vector<int> frames_in_trace(const std::string& path, const std::string& list);

/// Whether a command that takes a scene or a trace was given a trace: by its ending `.scbtrace`, or
/// by its first bytes.
bool names_trace(const std::string& path);

}  // namespace scb::scenes
