#pragma once

#include <memory>

#include "app/python/binding/errors.h"
#include "render/files/image.h"

namespace scb::python {

struct SharedImage {
    std::shared_ptr<const render::Image> image;
};

void add_image(py::module_& module);

}  // namespace scb::python
