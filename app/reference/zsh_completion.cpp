#include "app/reference/completion_scripts.h"
#include "app/reference/words.h"
#include "golden/suite/case_command.h"

namespace scb::app {
namespace {

std::string function_name(const ReferenceCommand& command) {
    std::string name = "_" + command.name;
    for (char& c : name)
        if (c == ' ' || c == '-') c = '_';
    return name;
}

/// What completes a value: an action of _arguments.
std::string action(const OptionValues& values, const std::string& shown) {
    const std::string words = joined(values.words, " ");
    if (values.is_list) return "_values -s , " + shown + " " + words;
    std::string files;
    if (values.is_folder) files = "_files -/";
    if (!values.endings.empty()) {
        std::string endings;
        for (const std::string& ending : values.endings)
            endings += (endings.empty() ? "" : "|") + ending.substr(1);
        files = "_files -g \"*.(#i)(" + endings + ")(-.)\"";
    }
    if (files.empty()) return words.empty() ? " " : "(" + words + ")";
    // Without the space, _arguments would add arguments of its own.
    return words.empty() ? files
                         : " _scb_words_or_files " + golden::shell_word(files) + " " + words;
}

/// What stands for it in a message: one word.
std::string shown_value(const ReferenceOption& option) {
    return option.value.empty() ? "VALUE" : escaped(option.value, ":[]");
}

std::string option_spec(const ReferenceOption& option) {
    std::string names;
    for (const std::string& name : option.names) {
        const char* with_value = name.starts_with("--") ? "=" : "+";
        names += (names.empty() ? "" : ",") + name + (option.takes_value ? with_value : "");
    }
    const bool one_name = option.names.size() == 1;
    const std::string excluded = option.takes_several ? "*" : "(" + joined(option.names, " ") + ")";
    std::string rest = "[" + escaped(option.help, "[]:\\") + "]";
    if (option.takes_value)
        rest += ":" + shown_value(option) + ":" +
                escaped(action(option.values, shown_value(option)), ":");
    return golden::shell_word(excluded) + (one_name ? names : "{" + names + "}") +
           golden::shell_word(rest);
}

std::string argument_spec(const ReferenceCommand& command) {
    const ReferenceOption& argument = *command.argument();
    const std::string tail = ":" + shown_value(argument) + ":" +
                             escaped(action(argument.values, shown_value(argument)), ":");
    const int most = most_arguments(command);
    if (most > 2) return " \\\n        " + golden::shell_word("*" + tail);
    std::string specs;
    for (int i = 0; i < most; ++i)
        specs += " \\\n        " + golden::shell_word((i == 0 ? ":" : "::") + tail.substr(1));
    return specs;
}

std::string function_text(const ReferenceCommand& command, const ReferenceCommand& program) {
    const bool has_commands = !command.commands.empty();
    std::string text = function_name(command) + "() {\n";
    if (has_commands)
        text +=
            "    local curcontext=$curcontext context state line\n"
            "    typeset -A opt_args\n";
    text += std::string("    _arguments -s -S") + (has_commands ? " -C" : "");
    for (const ReferenceOption* option : options_of(command, program))
        text += " \\\n        " + option_spec(*option);
    if (!has_commands)
        return text + (command.argument() != nullptr ? argument_spec(command) : "") + "\n}\n";
    text +=
        " \\\n        '1: :->command' '*:: :->rest' && return\n    case $state in\n"
        "    command)\n        local -a commands=(";
    for (const ReferenceCommand& sub : command.commands)
        text += "\n            " + golden::shell_word(sub.word() + ":" + escaped(sub.help, ":"));
    text +=
        ")\n        _describe -t commands command commands ;;\n    rest)\n        case $line[1] "
        "in\n";
    for (const ReferenceCommand& sub : command.commands)
        text += "        " + sub.word() + ") " + function_name(sub) + " ;;\n";
    return text + "        esac ;;\n    esac\n}\n";
}

}  // namespace

std::string zsh_completion(const ReferenceCommand& program) {
    std::string text =
        "#compdef scb\n# Completion of scb for zsh, written by `scb completion zsh`.\n\n"
        "# _scb_words_or_files FILES WORD...: FILES is what completes files.\n"
        "_scb_words_or_files() {\n"
        "    local files=$1\n"
        "    shift\n"
        "    local -a words=(\"${@:#*:}\") starts=(\"${(M)@:#*:}\")\n"
        "    _alternative 'words:word:compadd -a words' 'starts:word:compadd -S \"\" -a starts' "
        "\\\n"
        "        \"files:file:$files\"\n"
        "}\n";
    for (const ReferenceCommand* command : all_commands(program))
        text += function_text(*command, program);
    return text +
           "if [[ $funcstack[1] == _scb ]]; then\n    _scb \"$@\"\nelse\n    compdef _scb "
           "scb\nfi\n";
}

}  // namespace scb::app
