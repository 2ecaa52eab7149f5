#pragma once

#include <string>

#include "scenes/recordings/recording_block.h"

namespace scb::scenes {

/// Whether a path given for a scene is a trace, which is a compact recording: by its first bytes,
/// or by the ending of scb 1.0, `.scbtrace`.
bool names_trace(const std::string& path);

/// Whether a path given for a scene is a recording with meshes and hierarchies: by its ending,
/// `.scbrec` or `.jsonl` (JSON Lines), or by its first bytes. Never both this and a trace.
bool names_recording(const std::string& path);

/// The bytes of a recording. JSON Lines, which begin with a brace or are in a file `.jsonl`, are
/// converted, in memory. Throws InputError if the file cannot be read or is neither.
RecordingBytes recording_bytes(const std::string& path);

/// The bytes of a trace. Of a file that is no trace, only the first bytes. Throws InputError if the
/// file cannot be read.
std::string trace_bytes(const std::string& path);

}  // namespace scb::scenes
