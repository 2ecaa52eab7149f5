#include "app/view/view_page.h"

#include <pybind11/stl.h>

#include "app/cli/console.h"
#include "app/python/binding/pictures.h"
#include "app/python/binding/source.h"
#include "app/python/binding/view.h"
#include "core/base/text_format.h"
#include "core/platform/output_file.h"

namespace scb::python {
namespace {

struct Page {
    std::string html;
};

std::string words_of(const char* option, const std::string& value, const std::string& usual) {
    return value == usual ? "" : std::string(" ") + option + " " + value;
}

/// Sets the options in the page's commands, so that they give the same results.
void tell_options(app::ViewOptions& options) {
    const app::SceneOptions& scene = options.level.scene;
    std::string pose;
    for (const double number : scene.pose) pose += (pose.empty() ? "" : ",") + exact_number(number);
    options.scene = words_of("--pose", pose, "");
    options.bodies = words_of("--bodies", options.query.bodies, "");
    const app::HierarchyOptions& hierarchy = options.level.hierarchy;
    options.hierarchies =
        words_of("--growth", std::string(ball_growth_name(hierarchy.growth)), "ritter") +
        words_of("--margin", exact_number(hierarchy.margin), "0") +
        words_of("--split", std::string(split_method_name(hierarchy.split)), "paper");
    const app::QueryOptions usual;
    options.tests = words_of("--test", options.query.test, usual.test) +
                    words_of("--threshold", exact_number(options.query.threshold),
                             exact_number(usual.threshold));
    if (options.level.color_by)
        options.levels =
            " --color-by " + std::string(render::color_by_names[*options.level.color_by]);
}

/// Puts the page into a frame, as an attribute, since a notebook's page has its own scripts and
/// styles. The frame may only run scripts and offer downloads.
std::string framed(const Page& page, int height) {
    std::string text;
    for (const char c : page.html)
        if (c == '&')
            text += "&amp;";
        else if (c == '"')
            text += "&quot;";
        else
            text += c;
    return "<iframe sandbox=\"allow-scripts allow-downloads\" style=\"width:100%;border:0;height:" +
           std::to_string(height) + "px\" srcdoc=\"" + text + "\"></iframe>";
}

Page make_page(app::ViewOptions& options) {
    const py::gil_scoped_release unlocked;
    options.check();
    tell_options(options);
    app::Console console;
    console.quiet = true;
    const std::unique_lock<std::mutex> lock = lock_drawing();
    return {app::view_page(options, console)};
}

}  // namespace

void add_view(py::module_& module) {
    py::class_<Page>(module, "View", py::is_final(),
                     "A page to turn and to ask, in one HTML file. A notebook shows it.")
        .def_readonly("html", &Page::html, "The page.")
        .def(
            "_repr_html_", [](const Page& p) { return framed(p, 700); },
            "The page in a frame, for notebooks.")
        .def(
            "save",
            [](const Page& p, const py::object& path) {
                write_file_whole(file_of(path), std::string_view(p.html));
            },
            py::arg("path"),
            "Write the page, whole or not at all. Raises OutputError where that fails.")
        .def("__repr__", [](const Page& p) {
            return "<scb.View: " + format("%.1f MB", static_cast<double>(p.html.size()) / 1e6) +
                   ">";
        });
    module.def(
        "view",
        [](const py::object& source, const std::string& volume, const py::object& level,
           std::optional<std::int64_t> frame, const std::string& queries,
           const std::string& compare, const std::string& bodies, int steps,
           const std::string& split, const std::string& growth, double margin,
           const std::string& test, double threshold, const std::optional<std::string>& color_by,
           std::optional<double> opacity, bool mesh, const PictureSize& size,
           const std::string& camera, bool orthographic, const std::string& up,
           const std::string& gl) {
            app::ViewOptions options;
            options.level.scene = source_of(source);
            options.level.scene.frames = frame_text(frame);
            options.level.hierarchy = hierarchy_options(volume, split, growth, margin);
            options.level.picture = picture_options(size, 4, "light", true, gl);
            options.level.picture.output = "view.html";
            options.level.camera = camera_options(camera, orthographic, up);
            options.level.levels = py::str(level);
            options.level.color_by = color_by_of(color_by);
            options.level.opacity = opacity;
            options.level.mesh = mesh;
            options.query = query_options(test, threshold, "radius", bodies);
            options.queries = queries;
            options.compare = compare;
            options.steps = steps;
            return make_page(options);
        },
        py::arg("source"), py::kw_only(), py::arg("volume") = "scb", py::arg("level") = "auto",
        py::arg("frame") = py::none(), py::arg("queries") = "auto", py::arg("compare") = "",
        py::arg("bodies") = "", py::arg("steps") = 1000, py::arg("split") = "paper",
        py::arg("growth") = "ritter", py::arg("margin") = 0.0, py::arg("test") = "symmetric",
        py::arg("threshold") = 0.7, py::arg("color_by") = py::none(),
        py::arg("opacity") = py::none(), py::arg("mesh") = false,
        py::arg("size") = PictureSize{1280, 720}, py::arg("camera") = "",
        py::arg("orthographic") = false, py::arg("up") = "", py::arg("gl") = "",
        R"(Make the page of `scb view`: all of a scene, a trace or a recording, for a browser.

source: as of open_queries. volume: one kind or a list, "scb,obb". level: the one that is shown first.
queries: the frames whose query is in the page, "auto", "all", "none" or a list. compare: two overlap
tests, "corrected,printed". steps: so many tests have their steps in the page. The rest is as in
draw_level; size is that of the still picture for browsers that cannot draw.

Raises InputError; GlError or DrawError where OpenGL cannot draw.)");
}

}  // namespace scb::python
