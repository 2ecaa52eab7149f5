#include "scenes/traces/trace_input.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "scb/error.h"
#include "scenes/scene/scene.h"
#include "scenes/text/file_bytes.h"
#include "scenes/text/number_list.h"

namespace scb::scenes {
namespace {

std::span<const std::uint8_t> as_bytes(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

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
    std::vector<int> wanted;
    for (const std::string& part : split_list(list)) {
        const std::vector<int> numbers =
            part == "all" ? all
                          : parse_numbers(part, {"--frames " + list, "frame", "a trace may have",
                                                 most_frames - 1, "frames such as 0,250 or all"});
        wanted.insert(wanted.end(), numbers.begin(), numbers.end());
    }
    std::sort(wanted.begin(), wanted.end());
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    for (const int frame : wanted)
        if (!std::binary_search(all.begin(), all.end(), frame))
            throw InputError("--frames " + list + ": " + path + " has no frame " +
                             std::to_string(frame) + "; it has " + std::to_string(all.size()) +
                             " from " + std::to_string(all.front()) + " to " +
                             std::to_string(all.back()) + ".");
    return wanted;
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
