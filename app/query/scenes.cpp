#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/cli/commands.h"
#include "app/query/query_options.h"
#include "core/base/exit_status.h"
#include "core/platform/near_word.h"
#include "scb/error.h"
#include "scenes/scene/builtin.h"

namespace scb::app {
namespace {

int list() {
    std::string text = "Built-in scenes:\n\n";
    for (const scenes::BuiltinScene& scene : scenes::builtin_scenes()) {
        char line[64];
        std::snprintf(line, sizeof line, "  %-20s %4d frame%s  ", scene.name.c_str(), scene.frames,
                      scene.frames == 1 ? " " : "s");
        text += line + scene.description;
        for (const std::string& file : scene.mesh_files) text += " Needs " + file + ".";
        text += "\n";
    }
    text +=
        "\nA scene that needs a mesh file takes it from the folder that --models DIR or SCB_MODELS "
        "names; without it,\n"
        "the message says where such a mesh is published.\n"
        "\nA SCENE can also be a scene file (scene.json; `scb scenes NAME` prints one to start "
        "from), one mesh\n"
        "file (OBJ, PLY, STL, OFF, glTF, GLB, DAE, 3DS, FBX and more), or two mesh files with "
        "--pose or --poses.\n";
    print_result(text);
    return exit_done;
}

int show(const std::string& name) {
    const scenes::BuiltinScene* scene = scenes::find_builtin(name);
    if (scene == nullptr)
        throw InputError("'" + name + "' is not a built-in scene" +
                         did_you_mean(name, builtin_names()) + "; `scb scenes` lists them.");
    print_result(scene->json);
    return exit_done;
}

}  // namespace

void add_scenes(const Command& program, Action& action) {
    const Command command =
        program.add_subcommand("scenes", "List the built-in scenes, or print the file of one");
    const auto name = std::make_shared<std::string>();
    command.add_option("NAME", *name, "Print this built-in scene's file").offer(builtin_names());
    command.footer("Example:\n  scb scenes spheres-l1 > my-scene.json");
    command.callback(
        [&action, name] { action = [name] { return name->empty() ? list() : show(*name); }; });
}

}  // namespace scb::app
