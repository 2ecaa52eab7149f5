#include "app/python/binding/image.h"

#include "app/python/binding/arrays.h"
#include "app/python/binding/source.h"
#include "core/platform/output_file.h"
#include "render/files/image_file.h"

namespace scb::python {
namespace {

py::array pixels_of(const SharedImage& i) {
    const py::ssize_t width = i.image->width, height = i.image->height;
    return view_of(py::dtype::of<std::uint8_t>(), i.image->rgba.data(), {height, width, 4},
                   {4 * width, 4, 1}, i.image);
}

std::vector<std::uint8_t> encoded(const SharedImage& i) {
    const py::gil_scoped_release unlocked;
    return render::encode_png(*i.image);
}

py::bytes png_of(const SharedImage& i) {
    const std::vector<std::uint8_t> bytes = encoded(i);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

void add_image(py::module_& module) {
    py::class_<SharedImage>(module, "Image", py::is_final(), "A picture. A notebook shows it.")
        .def_property_readonly(
            "array", pixels_of,
            "height x width x 4 uint8: red, green, blue, alpha; the top row first; no copy.")
        .def("png", png_of, "The picture as a PNG file.")
        .def("_repr_png_", png_of, "The same, for notebooks.")
        .def(
            "save",
            [](const SharedImage& i, const py::object& path) {
                write_file_whole(file_of(path), encoded(i));
            },
            py::arg("path"),
            "Write a PNG file, whole or not at all. Raises OutputError where that fails.")
        .def("__repr__", [](const SharedImage& i) {
            return "<scb.Image: " + std::to_string(i.image->width) + " x " +
                   std::to_string(i.image->height) + ">";
        });
}

}  // namespace scb::python
