#include "scenes/recordings/recording_input.h"

#include <filesystem>
#include <fstream>

#include "core/platform/file_bytes.h"
#include "core/platform/input_files.h"
#include "scenes/recordings/recording_file.h"
#include "scenes/recordings/recording_json.h"

namespace scb::scenes {
namespace {

constexpr std::size_t start_bytes = 8;

}  // namespace

bool names_recording(const std::string& path) {
    if (path.ends_with(".scbrec") || path.ends_with(".jsonl")) return true;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return false;
    std::ifstream file(path, std::ios::binary);
    std::string start(start_bytes, '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    return file && starts_as_recording(start);
}

std::string recording_bytes(const std::string& path) {
    note_input(path);
    // The first bytes show whether this is a recording, so that other long files are not read.
    std::string start = file_bytes(path, start_bytes);
    if (starts_as_recording(start)) return file_bytes(path);
    const std::size_t first = start.find_first_not_of(" \t\r\n");
    if (path.ends_with(".jsonl") || (first != std::string::npos && start[first] == '{'))
        return recording_of_json(file_bytes(path), path);
    RecordingReader(start, path);  // throws, and says why
    return start;
}

}  // namespace scb::scenes
