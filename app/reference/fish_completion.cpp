#include "app/reference/completion_scripts.h"
#include "app/reference/words.h"

namespace scb::app {
namespace {

constexpr const char* fish_engine = R"(
# The word that is being completed, without the name of its option.
function __scb_current
    commandline -ct | string replace -r -- '^--[^=]*=' ''
end

# __scb_list WORD...: a list with commas, and one word more that is not in it.
function __scb_list
    set -l before (__scb_current | string match -r -- '.*,')
    for word in $argv
        string match -q -- "*,$word,*" ",$before"; or echo -- $before$word
    end
end

# __scb_files ENDING...: files with these endings, and folders.
function __scb_files
    set -l endings (string join '|' -- (string escape --style=regex -- $argv))
    __fish_complete_path (__scb_current) | string match -ri -- "^[^\t]*(?:/|$endings)(?:\t.*)?\$"
end

# Whether the command line, up to its last word, is of this command and can have an option, or one
# more of so many arguments.
function __scb_at -a wanted most
    set -l command scb
    set -l given 0
    set -l skipped 0
    set -l words (commandline -opc)
    for word in $words[2..-1]
        if test $skipped = 1
            set skipped 0
        else if string match -q -- '-*' $word
            contains -- $word (__scb_valued $command); and set skipped 1
        else if contains -- $word (__scb_commands $command)
            set command "$command $word"
        else
            set given (math $given + 1)
        end
    end
    test "$command" = "$wanted"; and begin
        test -z "$most"; or test $given -lt $most
    end
end

complete -c scb -f
)";

std::string fish_word(const std::string& text) { return "'" + escaped(text, "\\'") + "'"; }

/// What completes a value: an argument of `complete -a`, or nothing.
std::string offered_values(const OptionValues& values) {
    const std::string words = joined(values.words, " ");
    std::string text = values.is_list ? "(__scb_list " + words + ")" : words;
    if (values.is_folder) text += " (__fish_complete_directories (__scb_current))";
    if (!values.endings.empty()) text += " (__scb_files " + joined(values.endings, " ") + ")";
    return text.empty() ? "" : " -a " + fish_word(text);
}

std::string option_line(const ReferenceCommand& command, const ReferenceOption& option) {
    std::string text = "complete -c scb -n " + fish_word("__scb_at \"" + command.name + "\"");
    for (const std::string& name : option.names)
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    if (option.takes_value) text += " -x" + offered_values(option.values);
    return text + " -d " + fish_word(option.help) + "\n";
}

/// A function that prints, for each command, some words.
template <class WordsOf>
std::string words_function(const std::string& name, const ReferenceCommand& program,
                           WordsOf words_of) {
    std::string text = "function " + name + " -a command\n    switch $command\n";
    for (const ReferenceCommand* command : all_commands(program))
        if (const std::vector<std::string> words = words_of(*command); !words.empty())
            text += "        case " + fish_word(command->name) +
                    "\n            string split ' ' -- " + fish_word(joined(words, " ")) + "\n";
    return text + "    end\nend\n\n";
}

}  // namespace

std::string fish_completion(const ReferenceCommand& program) {
    std::string text = "# Completion of scb for fish, written by `scb completion fish`.\n\n";
    text += "# The commands below one.\n";
    text += words_function("__scb_commands", program, [](const ReferenceCommand& command) {
        std::vector<std::string> words;
        for (const ReferenceCommand& sub : command.commands) words.push_back(sub.word());
        return words;
    });
    text += "# The options whose value is the next word.\n";
    text += words_function("__scb_valued", program, [&](const ReferenceCommand& command) {
        std::vector<std::string> words;
        for (const ReferenceOption* option : options_of(command, program))
            if (option->takes_value)
                words.insert(words.end(), option->names.begin(), option->names.end());
        return words;
    });
    text.pop_back();
    text += fish_engine;
    for (const ReferenceCommand* command : all_commands(program)) {
        for (const ReferenceCommand& sub : command->commands)
            text += "complete -c scb -n " + fish_word("__scb_at \"" + command->name + "\" 1") +
                    " -a " + sub.word() + " -d " + fish_word(sub.help) + "\n";
        for (const ReferenceOption* option : options_of(*command, program))
            text += option_line(*command, *option);
        if (const ReferenceOption* argument = command->argument()) {
            const std::string values = offered_values(argument->values);
            if (!values.empty())
                text += "complete -c scb -n " +
                        fish_word("__scb_at \"" + command->name + "\" " +
                                  std::to_string(most_arguments(*command))) +
                        values + "\n";
        }
    }
    return text;
}

}  // namespace scb::app
