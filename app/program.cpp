#include "app/program.h"

#include <sys/stat.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <optional>
#include <system_error>

#include "app/cli/choice.h"
#include "app/cli/commands.h"
#include "app/cli/version.h"
#include "app/config/config.h"
#include "core/base/exit_status.h"
#include "core/platform/input_files.h"
#include "core/platform/near_word.h"
#include "core/platform/output_file.h"
#include "render/gl/context.h"
#include "scb/error.h"
#include "scenes/meshes/isolated_mesh.h"
#include "scenes/meshes/left_out.h"

namespace scb::app {
namespace {

// The last named command, and the words before it.
struct Named {
    const CLI::App* command;
    std::string parents;
};

Named named_command(const CLI::App& program) {
    Named named{&program, ""};
    while (!named.command->get_subcommands().empty()) {
        named.parents += (named.parents.empty() ? "" : " ") + named.command->get_name();
        named.command = named.command->get_subcommands().front();
    }
    return named;
}

// Which options of the command begin like the word; or else the nearest option.
std::string options_like(const std::string& word, const CLI::App& command) {
    const std::string unknown = word.substr(2);
    std::string alike;
    std::vector<std::string> names;
    for (const CLI::App* app = &command; app != nullptr; app = app->get_parent())
        for (const CLI::Option* option : app->get_options())
            for (const std::string& name : option->get_lnames()) {
                if (option->get_group().empty()) continue;
                names.push_back("--" + name);
                if (app == &command && (name.starts_with(unknown) || unknown.starts_with(name)))
                    alike += ", which has '--" + name + "'";
            }
    return alike.empty() ? did_you_mean(word, names) : alike;
}

// The word is no command of this one; empty: a command is needed.
std::string command_sentence(const std::string& word, const CLI::App& command,
                             const std::string& path) {
    std::vector<std::string> names;
    for (const CLI::App* sub :
         command.get_subcommands([](const CLI::App* app) { return !app->get_group().empty(); }))
        names.push_back(sub->get_name());
    return (word.empty()
                ? "`" + path + "` needs a command"
                : "unknown command '" + word + "' of `" + path + "`" + did_you_mean(word, names)) +
           "; give one of " + CLI::detail::join(names, ", ");
}

// Throws InputError if a word before the options names no command, though there are commands.
void check_topic(const CLI::App& program, const std::vector<std::string>& words) {
    const CLI::App* command = &program;
    std::string path = program.get_name();
    for (const std::string& word : words) {
        const std::vector<const CLI::App*> subs =
            command->get_subcommands([](const CLI::App*) { return true; });
        if (word.starts_with('-') || subs.empty()) return;
        const auto next = std::ranges::find(subs, word, &CLI::App::get_name);
        if (next == subs.end())
            throw InputError(command_sentence(word, *command, path) + "; see `" + path +
                             " --help`.");
        command = *next;
        path += " " + word;
    }
}

// One sentence that names the unknown word, unlike the parser's message.
std::string usage_sentence(const CLI::App& program, const std::vector<std::string>& words,
                           const CLI::ParseError& error) {
    const Named named = named_command(program);
    const std::string command =
        named.parents + (named.parents.empty() ? "" : " ") + named.command->get_name();
    const bool wants_command =
        !named.command->get_subcommands([](const CLI::App*) { return true; }).empty();
    std::string sentence = error.what();
    if (wants_command && dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
        // The word after the command's own name, if any.
        std::string word;
        for (auto it = words.rbegin(); it != words.rend(); ++it) {
            if (*it == named.command->get_name()) break;
            if (!it->starts_with('-')) word = *it;
        }
        sentence = command_sentence(word, *named.command, command);
    }
    // The parser does not name hidden options.
    if (sentence.starts_with(": "))
        for (auto it = words.rbegin(); it != words.rend(); ++it)
            if (it->starts_with("--")) {
                sentence.insert(0, *it);
                break;
            }
    // The parser takes the value of an unknown option for an extra argument.
    for (const std::string& given : words) {
        const std::string word = given.substr(0, given.find('='));
        if (word.size() < 3 || !word.starts_with("--")) continue;
        bool known = false;
        for (const CLI::App* app = named.command; app != nullptr && !known; app = app->get_parent())
            known = app->get_option_no_throw(word) != nullptr;
        if (!known) {
            sentence = "unknown option '" + word + "' of `" + command + "`" +
                       options_like(word, *named.command);
            break;
        }
    }
    for (const std::string& word : words) {
        if (word == "--") break;
        if (word.starts_with('-') && !word.starts_with("--") && std::filesystem::exists(word)) {
            sentence = "'" + word +
                       "' begins like an option; put -- before names like that, behind all options";
            break;
        }
    }
    for (char& c : sentence)
        if (c == '\n') c = ' ';
    return sentence + "; see `" + command + " --help`.";
}

/// Reports the files that a case has read to `scb golden`, unless a signal ends the process.
struct ToldInputs {
    static constexpr int descriptor = 3;  // of ChildProcess::output_path
    bool wanted = false;

    ~ToldInputs() {
        // A file without a name, which no other process has.
        struct stat told {};
        if (!wanted || ::fstat(descriptor, &told) != 0 || !S_ISREG(told.st_mode) ||
            told.st_nlink != 0)
            return;
        const std::string inputs = noted_inputs();
        if (::write(descriptor, inputs.data(), inputs.size()) < 0) return;
    }
};

/// The program's own options.
struct ProgramOptions {
    Console console;
    ToldInputs inputs;
    std::string color = "auto";
    bool without_files = false, json = false;
};

void add_program_options(CLI::App& program, const Command& root, ProgramOptions& options,
                         Watch& watch) {
    program.add_flag("--tell-inputs", options.inputs.wanted)->group("");
    program.add_flag("--quiet", options.console.quiet, "Print no notes and no progress");
    add_choice(root, "--color", options.color, words_as_choices({"auto", "always", "never"}),
               "Color in messages")
        .type_name("WHEN");
    program.add_flag("--watch", watch.wanted,
                     "Run again whenever a file that was read changes, until Ctrl-C");
    program.add_flag("--no-config", options.without_files,
                     "Ignore configuration files (see config)");
    program.add_flag("--json", options.json)->group("");
    program.add_flag_callback(
        "--version",
        [&json = options.json] {
            print_result(json ? version_json() : version_text());
            throw CLI::Success();
        },
        "Print the versions of scb and of its graphics libraries; with --json as JSON");
    program.fallthrough();
}

void add_commands(const Command& root, const ProgramOptions& options, const RunAgain& run_again,
                  Action& action) {
    const Console& console = options.console;
    const Command render = root.add_subcommand("render", "Draw pictures");
    render.require_subcommand();
    add_render_distance(render, console, action);
    add_render_levels(render, console, action);
    add_render_pairs(render, console, action);
    add_render_rejections(render, console, action);
    add_render_traversal(render, console, action);
    add_view(root, console, action);
    add_merge(root, console, run_again, action);
    add_inspect(root, console, action);
    add_collide(root, console, action);
    add_distance(root, console, action);
    add_inside(root, console, action);
    add_motion(root, console, action);
    add_bench(root, console, action);
    add_tune(root, console, action);
    add_trace(root, console, action);
    add_diff(root, console, action);
    add_explain(root, console, action);
    add_golden(root, console, action);
    add_stats(root, console, action);
    add_convert(root, console, action);
    add_export(root, console, action);
    add_scenes(root, action);
    add_doctor(root, action);
    add_config(root, options.without_files, action);
    add_completion(root, action);
    add_man(root, action);
    add_reference(root, action);
}

/// Reads the words after the program's name. Returns the exit status if there is no command to run:
/// help or versions were printed, or the words were refused.
std::optional<int> parse(CLI::App& program, const std::vector<std::string>& words,
                         const ConfiguredLine& line, const Console& console) {
    try {
        // The parser takes words from the end.
        program.parse(std::vector<std::string>(line.words.rbegin(), line.words.rend()));
        return std::nullopt;
    } catch (const CLI::CallForHelp&) {
        check_topic(program, words);
        // Help of the last named command.
        const Named named = named_command(program);
        print_result(named.command->help(named.parents));
        return exit_done;
    } catch (const CLI::CallForAllHelp&) {
        print_result(program.help("", CLI::AppFormatMode::All));
        return exit_done;
    } catch (const CLI::Success&) {
        return exit_done;
    } catch (const CLI::ParseError& error) {
        console.error(line.placed(usage_sentence(program, words, error)));
        return exit_bad_input;
    }
}

/// `help COMMAND` as `COMMAND --help`.
std::vector<std::string> without_help_word(std::vector<std::string> words) {
    if (words.empty() || words[0] != "help") return words;
    words.erase(words.begin());
    if (!words.empty() && words[0] == "help") words.clear();
    words.emplace_back("--help");
    return words;
}

/// Reports the current exception. Returns the exit status.
int report_exception(const ConfiguredLine& line, const Console& console) {
    try {
        throw;
    } catch (const InputError& error) {
        console.error(line.placed(error.what()));
        return exit_bad_input;
    } catch (const OutputError& error) {
        console.error(error.what());
    } catch (const render::GlError& error) {
        console.error(error.what());
        return exit_no_gl;
    } catch (const render::DrawError& error) {
        console.error(error.what());
    } catch (const scenes::MeshReaderError& error) {
        console.error(error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        console.error(std::string(error.what()) + ".");
    } catch (const std::system_error& error) {
        console.error(std::string("a thread cannot be started or a system call failed (") +
                      error.what() +
                      "); check the limits of processes and memory (ulimit -u, -v).");
    } catch (const std::bad_alloc&) {
        tell_out_of_memory();
    } catch (const std::exception& error) {
        console.error(std::string("unexpected: ") + error.what() + "; please report this.");
    }
    return exit_environment;
}

}  // namespace

void tell_out_of_memory() {
    std::fputs("scb: error: out of memory", stderr);
    const char* file = last_input();
    if (*file != '\0') std::fputs(", and the file that was read last is ", stderr);
    for (; *file != '\0'; ++file) {
        const auto c = static_cast<unsigned char>(*file);
        std::fputc(c < 0x20 || c == 0x7f ? '?' : c, stderr);
    }
    std::fputs("; use a smaller mesh or picture, fewer levels, or --max-pairs.\n", stderr);
}

int run_program(const std::vector<std::string>& given, Watch& watch) {
    const std::vector<std::string> words = without_help_word(given);
    CLI::App program{
        "scb: render, inspect and test hierarchies of slab cut balls, without a display."};
    program.name("scb");
    program.require_subcommand(1);
    program.set_help_all_flag("--help-all", "Help of all commands");
    program.footer(
        "Exit status: 0 done; 1 a comparison found differences, or a test rejected volumes that "
        "overlap; 2 bad usage or\n"
        "input; 3 the environment failed (disk full, cannot write); 4 nothing is wrong in what "
        "could be judged of a\n"
        "recording; 77 no OpenGL context; 130, 143 and 129 interrupted by Ctrl-C, SIGTERM and "
        "SIGHUP; 141 the reader of\n"
        "the output has ended. `scb help COMMAND` is `scb COMMAND --help`.\n\n"
        "Example:\n  scb render levels spheres-l1 --volume scb,ball --levels 5,7,9,11 -o out/");

    OptionTable table;
    const Command root(program, table);
    ProgramOptions options;
    Action action;
    const RunAgain run_again = [&watch](const auto& others) { return run_program(others, watch); };
    add_program_options(program, root, options, watch);
    add_commands(root, options, run_again, action);

    Console& console = options.console;
    ConfiguredLine line;
    try {
        const ReferenceCommand reference = reference_of_program(root);
        line = configured(read_command_line(words, reference), reference, table);
        if (const std::optional<int> status = parse(program, words, line, console)) return *status;
        if (options.json) {
            const Named named = named_command(program);
            const std::string command = named.parents + " " + named.command->get_name();
            throw InputError("unknown option '--json' of `" + command + "`; see `" + command +
                             " --help`.");
        }
        console.color = options.color == "always"  ? ColorMode::always
                        : options.color == "never" ? ColorMode::never
                                                   : ColorMode::automatic;
        if (const std::string note = line.note(); !note.empty()) console.note(note);
        watch.quiet = console.quiet;
        const int status = action();
        for (const std::string& sentence : scenes::take_left_out())
            console.note("scb: " + sentence);
        return status;
    } catch (const std::exception&) {
        return report_exception(line, console);
    }
}

}  // namespace scb::app
