#pragma once

#include <string>

namespace scb::scenes {

/// Whether a path given for a scene is a recording: by its ending, `.scbrec` or `.jsonl` (JSON
/// Lines), or by its first bytes.
bool names_recording(const std::string& path);

/// The bytes of a recording. JSON Lines, which begin with a brace or are in a file `.jsonl`, are
/// converted. Throws InputError if the file cannot be read or is neither.
std::string recording_bytes(const std::string& path);

}  // namespace scb::scenes
