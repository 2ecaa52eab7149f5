#include "tests/peers/gnuplot.h"

#include "core/base/text_format.h"
#include "core/platform/child_process.h"
#include "core/platform/output_file.h"

namespace scb {

std::string gnuplot_color(render::Rgba8 color) {
    return format("#%02X%02X%02X", color.r, color.g, color.b);
}

std::string gnuplot_text(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
    return result + "'";
}

std::string draw_plot(const std::filesystem::path& folder, const std::string& name,
                      const std::string& script) {
    const std::string file = (folder / name).string();
    write_file_whole(file, script);
    if (!is_on_path("gnuplot"))
        return "there is no plot: gnuplot is missing; install gnuplot-nox, and run it on " + file +
               ".";
    const UnnamedFile output;
    ChildProcess gnuplot({"gnuplot", name}, output, std::chrono::seconds(10), folder.string());
    const std::optional<ProcessEnd> end = gnuplot.wait(std::chrono::seconds(60));
    if (!end || *end != ProcessEnd{})
        throw OutputError("gnuplot failed on " + file + ": " + gnuplot.last_line() +
                          "; run it there to see more.");
    return {};
}

}  // namespace scb
