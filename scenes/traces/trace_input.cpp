#include "scenes/traces/trace_input.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/platform/file_bytes.h"
#include "core/platform/number_list.h"
#include "scb/error.h"
#include "scenes/traces/byte_stream.h"

namespace scb::scenes {
namespace {

// A file that is not a trace is refused by its first bytes, however long it is.
std::string trace_bytes(const std::string& path) {
    const std::string start = file_bytes(path, 8);
    return starts_as_trace(as_bytes(start)) ? file_bytes(path) : start;
}

}  // namespace

TraceInput::TraceInput(const std::string& path)
    : bytes(trace_bytes(path)), reader(as_bytes(bytes), path) {}

std::vector<int> frames_in_trace(const std::string& path, const std::string& list) {
    TraceInput input(path);
    std::vector<int> all;
    while (const TraceFrame* frame = input.reader.next()) all.push_back(frame->frame);
    if (all.empty()) throw InputError(path + " has no frames; record it again.");
    return frames_among(all, list, path, "a trace may have");
}

bool names_trace(const std::string& path) {
    if (path.ends_with(".scbtrace")) return true;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return false;
    std::ifstream file(path, std::ios::binary);
    std::string start(8, '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    return file && starts_as_trace(as_bytes(start));
}

}  // namespace scb::scenes
