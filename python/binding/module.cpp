#include "python/binding/collide.h"
#include "python/binding/collide_poses.h"
#include "python/binding/errors.h"
#include "python/binding/explain.h"
#include "python/binding/hierarchy.h"
#include "python/binding/image.h"
#include "python/binding/instances.h"
#include "python/binding/mesh.h"
#include "python/binding/pictures.h"
#include "python/binding/queries.h"
#include "python/binding/scene.h"
#include "python/binding/source.h"
#include "python/binding/view.h"
#include "python/binding/volumes.h"
#include "scenes/meshes/isolated_mesh.h"

namespace scb::python {

PYBIND11_MODULE(_scb, module) {
    module.doc() = "The binding of scb: see the package scb.";
    module.attr("__version__") = SCB_VERSION;
    add_errors();
    add_mesh(module);
    add_scene(module);
    add_volumes(module);
    add_hierarchy(module);
    add_collide(module);
    add_collide_poses(module);
    add_explain(module);
    add_queries(module);
    add_image(module);
    add_pictures(module);
    add_view(module);
    refuse_bare_instances(module);
    module.def(
        "_set_mesh_reader",
        [](const py::object& program) { scenes::set_mesh_reader(file_of(program)); },
        py::arg("program"), "Says which program reads mesh files: for the package itself.");
}

}  // namespace scb::python
