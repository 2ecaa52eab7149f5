#include "app/python/binding/pictures.h"

#include <pybind11/stl.h>

#include <mutex>

#include "app/pictures/level_figures.h"
#include "app/pictures/pairs_figure.h"
#include "app/python/binding/image.h"
#include "app/python/binding/source.h"
#include "core/base/text_format.h"
#include "render/draw/renderer.h"
#include "render/overlay/overlay.h"

namespace scb::python {
namespace {

/// The objects that draw one picture.
struct Drawing {
    std::unique_lock<std::mutex> lock = lock_drawing();
    render::Context context;
    render::Renderer renderer{context};
    render::Overlay overlay;

    explicit Drawing(const app::PictureOptions& options) : context(options.backend()) {}

    template <class Figure>
    SharedImage draw(Figure figure, const app::PictureOptions& options) {
        const render::Picture picture = render::compose(std::move(figure), options.width(),
                                                        options.height(), options.samples, overlay);
        return {std::make_shared<render::Image>(renderer.draw(picture, &overlay).image)};
    }
};

SharedImage draw_level(const app::LevelOptions& options) {
    const py::gil_scoped_release unlocked;
    options.check();
    const auto no_notes = [](const std::string&) {};
    const app::LevelSubject subject = app::level_subject(
        options.scene, options.hierarchy, options.levels, options.recording, no_notes);
    if (subject.levels.size() != 1 || subject.trees.size() != 1)
        refuse("level " + options.levels, "a picture has one level of one kind of volumes.");
    Drawing drawing(options.picture);
    const app::LevelFigures figures(options, subject, drawing.renderer);
    return drawing.draw(figures.figure(0, subject.levels[0]), options.picture);
}

SharedImage draw_pairs(app::QueryViewOptions& options, bool leaves, bool recorded) {
    const py::gil_scoped_release unlocked;
    options.check();
    if (leaves) options.shown = app::Shown::leaves;
    app::QuerySources sources;
    sources.emplace_back(options.scene, options.hierarchy, options.query, options.limits, recorded);
    app::QuerySource& source = sources[0];
    if (source.frames().size() != 1)
        refuse("frame " + options.query.frames, "a picture has one frame.");
    const QueryTrace& frame = source.frame(source.frames()[0]);
    Drawing drawing(options.picture);
    const app::QueryView view(options, sources, drawing.renderer);
    const render::PairsStyle style{.leaves = leaves, .theme = options.picture.theme()};
    return drawing.draw(app::pairs_figure(view, source, frame, view.bodies(frame.frame), style),
                        options.picture);
}

}  // namespace

std::unique_lock<std::mutex> lock_drawing() {
    static std::mutex only;
    return std::unique_lock(only);
}

app::PictureOptions picture_options(const PictureSize& size, int samples,
                                    const std::string& background, bool panel,
                                    const std::string& gl) {
    app::PictureOptions options;
    options.size = std::to_string(size.first) + "x" + std::to_string(size.second);
    options.samples = samples;
    options.background = background;
    options.no_panel = !panel;
    if (!gl.empty()) options.gl = gl;
    options.check();
    return options;
}

app::CameraOptions camera_options(const std::string& camera, bool orthographic,
                                  const std::string& up) {
    app::CameraOptions options;
    options.camera = camera;
    options.orthographic = orthographic;
    options.up = up;
    options.check();
    return options;
}

std::optional<render::ColorBy> color_by_of(const std::optional<std::string>& name) {
    if (!name) return std::nullopt;
    const std::optional<render::ColorBy> color_by = render::color_by_names.find(*name);
    if (!color_by)
        refuse("--color-by " + *name,
               "give one of " + name_list(render::color_by_names.names, [](std::string_view n) {
                   return n;
               }) + ".");
    return color_by;
}

std::string frame_text(std::optional<std::int64_t> frame) {
    return frame ? std::to_string(*frame) : "";
}

void add_pictures(py::module_& module) {
    module.def(
        "draw_level",
        [](const py::object& source, const py::object& level, const std::string& volume,
           std::optional<std::int64_t> frame, const std::string& split, const std::string& growth,
           double margin, const std::optional<std::string>& color_by, std::optional<double> opacity,
           bool mesh, bool edges, const PictureSize& size, const std::string& camera,
           bool orthographic, const std::string& up, int samples, const std::string& background,
           bool panel, const std::string& gl) {
            app::LevelOptions options;
            options.scene = source_of(source);
            options.scene.frames = frame_text(frame);
            options.hierarchy = hierarchy_options(volume, split, growth, margin);
            options.picture = picture_options(size, samples, background, panel, gl);
            options.camera = camera_options(camera, orthographic, up);
            options.levels = py::str(level);
            options.color_by = color_by_of(color_by);
            options.opacity = opacity;
            options.mesh = mesh;
            options.edges = edges;
            return draw_level(options);
        },
        py::arg("source"), py::arg("level"), py::kw_only(), py::arg("volume") = "scb",
        py::arg("frame") = py::none(), py::arg("split") = "paper", py::arg("growth") = "ritter",
        py::arg("margin") = 0.0, py::arg("color_by") = py::none(), py::arg("opacity") = py::none(),
        py::arg("mesh") = false, py::arg("edges") = false, py::arg("size") = PictureSize{960, 640},
        py::arg("camera") = "", py::arg("orthographic") = false, py::arg("up") = "",
        py::arg("samples") = 4, py::arg("background") = "light", py::arg("panel") = true,
        py::arg("gl") = "",
        R"(Draw a level of the hierarchies of all bodies: the picture of `scb render levels`.

source: a Scene, a built-in name, a path, or two mesh files; of a recording its own trees. level: a
number or "leaves". color_by: "body", "depth", "radius", "thickness", "subtree" or "surface". opacity:
of volumes, 0 to 1. mesh, edges: show the mesh through them. size: width and height in pixels. camera:
"fit", "orbit:AZIMUTH,ELEVATION[,DISTANCE]" or a JSON file. up: "x", "y" or "z". samples: 1 or 4 a
pixel. background: "light" or "dark". panel: whether numbers stand beside the view. gl: "osmesa" or
"egl".

Raises InputError; GlError or DrawError where OpenGL cannot draw. One picture is drawn at a time.)");
    module.def(
        "draw_pairs",
        [](const py::object& source, std::optional<std::int64_t> frame, bool leaves, bool recorded,
           const std::string& bodies, const std::string& volume, const std::string& split,
           const std::string& growth, double margin, const std::string& test, double threshold,
           const std::string& descent, const PictureSize& size, const std::string& camera,
           bool orthographic, const std::string& up, int samples, const std::string& background,
           bool panel, const std::string& gl) {
            app::QueryViewOptions options;
            options.scene = source_of(source);
            options.hierarchy = hierarchy_options(volume, split, growth, margin);
            options.query = query_options(test, threshold, descent, bodies,
                                          frame ? frame_text(frame) : auto_frames);
            options.picture = picture_options(size, samples, background, panel, gl);
            options.camera = camera_options(camera, orthographic, up);
            return draw_pairs(options, leaves, recorded);
        },
        py::arg("source"), py::arg("frame") = py::none(), py::kw_only(), py::arg("leaves") = false,
        py::arg("recorded") = true, py::arg("bodies") = "", py::arg("volume") = "scb",
        py::arg("split") = "paper", py::arg("growth") = "ritter", py::arg("margin") = 0.0,
        py::arg("test") = "symmetric", py::arg("threshold") = 0.7, py::arg("descent") = "radius",
        py::arg("size") = PictureSize{960, 640}, py::arg("camera") = "",
        py::arg("orthographic") = false, py::arg("up") = "", py::arg("samples") = 4,
        py::arg("background") = "light", py::arg("panel") = true, py::arg("gl") = "",
        R"(Draw the triangles that intersect: the picture of `scb render pairs`.

source: as of open_queries. leaves: also the volumes of leaves that overlap while their triangles do
not. camera: "contact" too. The rest is as in draw_level and open_queries.

Raises InputError; GlError or DrawError where OpenGL cannot draw. One picture is drawn at a time.)");
}

}  // namespace scb::python
