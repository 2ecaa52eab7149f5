#include "app/cli/open_file.h"

#include <chrono>
#include <optional>
#include <string>

#include "core/platform/child_process.h"
#include "core/platform/output_file.h"
#include "core/platform/utf8.h"

namespace scb::app {
namespace {

// Most openers start another program and end. Others are that program, and keep running.
constexpr std::chrono::seconds patience{5};

}  // namespace

void open_file(const std::filesystem::path& file, const Console& console) {
    std::string opener;
    for (const char* name : {"open", "xdg-open"})
        if (is_on_path(name)) opener = name;
    if (opener.empty()) {
        console.note("scb: --open: there is neither xdg-open nor open on PATH; open " +
                     printable(file.string()) + " yourself.");
        return;
    }
    // A name that begins with "-" would be taken for an option.
    const std::string name = file.string(), shown = printable(name);
    const UnnamedFile unused;
    try {
        ChildProcess child({opener, name.starts_with('-') ? "./" + name : name}, unused, patience);
        const std::optional<ProcessEnd> end = child.wait_or_leave(patience);
        if (!end || *end == ProcessEnd{}) return;
        const std::string said = printable(child.last_line());
        console.note("scb: --open: " + opener + " could not open " + shown +
                     (said.empty() ? "" : " (" + said + ")") + "; open it yourself.");
    } catch (const OutputError& error) {
        console.note("scb: --open: " + std::string(error.what()));
    }
}

}  // namespace scb::app
