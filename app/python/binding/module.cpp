#include "app/python/binding/collide.h"
#include "app/python/binding/collide_poses.h"
#include "app/python/binding/contacts.h"
#include "app/python/binding/distance.h"
#include "app/python/binding/errors.h"
#include "app/python/binding/explain.h"
#include "app/python/binding/hierarchy.h"
#include "app/python/binding/image.h"
#include "app/python/binding/instances.h"
#include "app/python/binding/mesh.h"
#include "app/python/binding/packed.h"
#include "app/python/binding/pictures.h"
#include "app/python/binding/queries.h"
#include "app/python/binding/scene.h"
#include "app/python/binding/source.h"
#include "app/python/binding/view.h"
#include "app/python/binding/volumes.h"
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
    add_packed(module);
    add_distance(module);
    add_contacts(module);
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
