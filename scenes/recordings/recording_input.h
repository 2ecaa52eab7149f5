#pragma once

#include <string>

namespace scb::scenes {

/// Whether a command that takes a scene was given a recording: by its ending (`.scbrec`), by its
/// first bytes, or as its twin in JSON Lines by the ending `.jsonl`.
bool names_recording(const std::string& path);

/// The bytes of a recording; its twin in JSON Lines, which begins with a brace or is called
/// `.jsonl`, becomes such. Throws InputError where the file cannot be read or is neither.
std::string recording_bytes(const std::string& path);

}  // namespace scb::scenes
