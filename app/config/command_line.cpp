#include "app/config/command_line.h"

#include <algorithm>

#include "app/reference/words.h"

namespace scb::app {

bool CommandLine::has(const std::string& option) const {
    return std::any_of(command->options.begin(), command->options.end(),
                       [&](const ReferenceOption& known) {
                           return known.has_name(option) && given.contains(known.parsed);
                       });
}

CommandLine read_command_line(const std::vector<std::string>& words,
                              const ReferenceCommand& program) {
    CommandLine line{words, &program, 0, {}, {}};
    bool is_value = false, are_arguments = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (is_value) {
            is_value = false;
        } else if (!are_arguments && word == "--") {
            are_arguments = true;
        } else if (!are_arguments && word.size() > 1 && word.starts_with('-')) {
            const std::size_t equal = word.find('=');
            const bool is_long = word.starts_with("--");
            const std::string name = is_long ? word.substr(0, equal) : word.substr(0, 2);
            for (const ReferenceOption* option : options_of(*line.command, program))
                if (option->has_name(name)) {
                    line.given.insert(option->parsed);
                    const bool has_value = is_long ? equal != word.npos : word.size() > 2;
                    is_value = option->takes_value && !has_value;
                    break;
                }
        } else {
            const auto& commands = line.command->commands;
            const auto sub =
                std::find_if(commands.begin(), commands.end(),
                             [&](const ReferenceCommand& known) { return known.word() == word; });
            if (sub == commands.end()) {
                line.arguments.push_back(word);
                continue;
            }
            line.command = &*sub;
            line.options_begin = i + 1;
        }
    }
    return line;
}

}  // namespace scb::app
