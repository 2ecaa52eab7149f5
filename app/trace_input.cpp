#include "app/trace_input.h"

#include <filesystem>
#include <fstream>

#include "scenes/file_bytes.h"

namespace scb {
namespace {

std::span<const std::uint8_t> as_bytes(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

namespace {

// A file that is no trace is refused by its first bytes, however long it is.
std::string trace_bytes(const std::string& path) {
    const std::string start = file_bytes(path, 8);
    return starts_as_trace(as_bytes(start)) ? file_bytes(path) : start;
}

}  // namespace

TraceInput::TraceInput(const std::string& path)
    : bytes(trace_bytes(path)), reader(as_bytes(bytes), path) {}

bool names_trace(const std::string& path) {
    if (path.ends_with(".scbtrace")) return true;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return false;
    std::ifstream file(path, std::ios::binary);
    std::string start(8, '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    return file && starts_as_trace(as_bytes(start));
}

}  // namespace scb
