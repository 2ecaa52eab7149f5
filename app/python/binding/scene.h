#pragma once

#include <memory>

#include "app/python/binding/errors.h"
#include "app/study/scene_setup.h"

namespace scb::python {

/// A scene, and its name in commands. A scene made in Python is in `options`.
struct SharedScene {
    std::shared_ptr<const scenes::Scene> scene;
    app::SceneOptions options;
};

void add_scene(py::module_& module);

}  // namespace scb::python
