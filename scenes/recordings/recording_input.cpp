#include "scenes/recordings/recording_input.h"

#include <cerrno>
#include <filesystem>
#include <fstream>

#include "core/platform/file_bytes.h"
#include "core/platform/input_files.h"
#include "scb/error.h"
#include "scenes/recordings/recording_file.h"
#include "scenes/recordings/recording_json.h"
#include "scenes/recordings/trace_file.h"

namespace scb::scenes {
namespace {

/// The first bytes, which tell the kinds of files apart; empty if there is no such file.
std::string start_of(const std::string& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return "";
    std::ifstream file(path, std::ios::binary);
    std::string start(compact_start, '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(file.gcount()));
    return start;
}

std::string json_bytes(const std::string& path) {
    check_is_file(path);
    std::ifstream lines(path, std::ios::binary);
    if (!lines) refuse_to_open(path, errno);
    // Else a stream keeps the error to itself, also that memory ran out.
    lines.exceptions(std::ios::badbit);
    try {
        return recording_of_json(lines, path);
    } catch (const std::ios_base::failure&) {
        throw InputError(path + ": cannot be read; check its permissions and the disk.");
    }
}

}  // namespace

bool names_trace(const std::string& path) {
    return path.ends_with(".scbtrace") || starts_as_trace(as_bytes(start_of(path)));
}

bool names_recording(const std::string& path) {
    if (names_trace(path)) return false;
    return path.ends_with(".scbrec") || path.ends_with(".jsonl") ||
           starts_as_recording(start_of(path));
}

std::string trace_bytes(const std::string& path) {
    // The first bytes show whether this is a trace, so that other long files are not read.
    const std::string start = file_bytes(path, compact_start);
    return starts_as_trace(as_bytes(start)) || starts_as_recording(start) ? file_bytes(path)
                                                                          : start;
}

RecordingBytes recording_bytes(const std::string& path) {
    note_input(path);
    // The first bytes show whether this is a recording, so that other long files are not read.
    std::string start = file_bytes(path, compact_start);
    if (starts_as_recording(start)) return RecordingBytes::of_file(path);
    const std::size_t first = start.find_first_not_of(" \t\r\n");
    if (path.ends_with(".jsonl") || (first != std::string::npos && start[first] == '{'))
        return RecordingBytes(json_bytes(path));
    RecordingReader(start, path);  // throws, and says why
    return RecordingBytes(std::move(start));
}

}  // namespace scb::scenes
