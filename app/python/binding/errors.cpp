#include "app/python/binding/errors.h"

#include <filesystem>
#include <system_error>

#include "core/platform/output_file.h"
#include "core/platform/utf8.h"
#include "render/gl/context.h"
#include "scb/error.h"
#include "scenes/meshes/isolated_mesh.h"

namespace scb::python {
namespace {

void raise(const char* name, const std::string& sentence) {
    // The sentence may contain a file's name, which need not be UTF-8.
    const std::string text = as_utf8(sentence);
    const py::object type = py::module_::import("scb.errors").attr(name);
    PyErr_SetObject(type.ptr(), py::str(text).ptr());
}

void translate(std::exception_ptr thrown) {
    try {
        if (thrown) std::rethrow_exception(thrown);
    } catch (const InputError& error) {
        raise("InputError", error.what());
    } catch (const OutputError& error) {
        raise("OutputError", error.what());
    } catch (const render::GlError& error) {
        raise("GlError", error.what());
    } catch (const render::DrawError& error) {
        raise("DrawError", error.what());
    } catch (const scenes::MeshReaderError& error) {
        raise("MeshReaderError", error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        raise("OutputError", std::string(error.what()) + ".");
    } catch (const std::system_error& error) {
        raise("SystemLimitError",
              std::string("a thread cannot be started or a system call failed (") + error.what() +
                  "); check the limits of processes and memory (ulimit -u, -v).");
    }
}

}  // namespace

void add_errors() { py::register_exception_translator(translate); }

void refuse(const std::string& name, const std::string& what) {
    throw InputError(name + ": " + what);
}

}  // namespace scb::python
