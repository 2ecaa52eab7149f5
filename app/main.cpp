#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <new>

#include "app/commands.h"
#include "app/exit_status.h"
#include "app/version.h"
#include "core/error.h"
#include "render/context.h"
#include "render/image_file.h"

namespace scb {
namespace {

int run(int argc, char** argv) {
    CLI::App program{
        "scb: render, inspect and test hierarchies of slab cut balls, without a display."};
    program.name("scb");
    program.require_subcommand(1);
    program.set_help_all_flag("--help-all", "Help of all commands");
    program.footer(
        "Exit status: 0 done, 1 a comparison found differences, 2 bad usage or input, 3 the "
        "environment failed\n"
        "(disk full, cannot write), 77 no OpenGL context.\n\n"
        "Example:\n  scb render levels spheres-l1 --volume scb,ball --levels 5,7,9,11 -o out/");

    Console console;
    Action action;
    std::string color = "auto";
    program.add_flag("--quiet", console.quiet, "No notes and no progress");
    program.add_option("--color", color, "Color in messages")
        ->check(CLI::IsMember({"auto", "always", "never"}))
        ->capture_default_str();
    program.add_flag_callback(
        "--version",
        [] {
            print_result(version_text());
            throw CLI::Success();
        },
        "Versions of scb and of what it draws with");
    program.fallthrough();

    CLI::App* render = program.add_subcommand("render", "Draw pictures");
    render->require_subcommand(1);
    render->fallthrough();
    add_render_levels(*render, console, action);
    add_stats(program, console, action);
    add_export(program, console, action);
    add_scenes(program, action);

    try {
        try {
            program.parse(argc, argv);
        } catch (const CLI::CallForHelp&) {
            // Help of the command that was named last.
            const CLI::App* named = &program;
            while (!named->get_subcommands().empty()) named = named->get_subcommands().front();
            print_result(named->help(named == &program ? "" : "scb"));
            return exit_done;
        } catch (const CLI::CallForAllHelp&) {
            print_result(program.help("", CLI::AppFormatMode::All));
            return exit_done;
        } catch (const CLI::Success&) {
            return exit_done;
        } catch (const CLI::ParseError& error) {
            console.error(std::string(error.what()) + "; see `scb --help`.");
            return exit_bad_input;
        }
        console.color = color == "always"  ? ColorMode::always
                        : color == "never" ? ColorMode::never
                                           : ColorMode::automatic;
        return action();
    } catch (const InputError& error) {
        console.error(error.what());
        return exit_bad_input;
    } catch (const OutputError& error) {
        console.error(error.what());
        return exit_environment;
    } catch (const GlError& error) {
        console.error(error.what());
        return exit_no_gl;
    } catch (const std::filesystem::filesystem_error& error) {
        console.error(std::string(error.what()) + ".");
        return exit_environment;
    } catch (const std::bad_alloc&) {
        console.error("out of memory; use a smaller mesh, picture or number of levels.");
        return exit_environment;
    }
}

}  // namespace
}  // namespace scb

int main(int argc, char** argv) {
    // A closed pipe and a file that may not grow are reported as errors of the write, not by a
    // silent end.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    return scb::run(argc, argv);
}
