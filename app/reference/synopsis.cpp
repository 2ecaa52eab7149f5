#include "app/reference/synopsis.h"

#include <vector>

#include "app/reference/words.h"

namespace scb::app {

std::string option_heading(const ReferenceOption& option, Face typed, Face value) {
    if (option.names.empty()) return value(option.value);
    std::vector<std::string> names;
    for (const std::string& name : option.names) names.push_back(typed(name));
    const std::string text = joined(names, ", ");
    return option.takes_value && !option.value.empty() ? text + " " + value(option.value) : text;
}

std::string synopsis(const ReferenceCommand& command, Face typed, Face value) {
    std::string text = typed(command.name);
    if (!command.options.empty()) text += " [" + value("OPTION") + "...]";
    if (!command.commands.empty()) text += " " + value("COMMAND") + " ...";
    for (const ReferenceOption& option : command.options)
        if (option.is_required) text += " " + option_heading(option, typed, value);
    for (const ReferenceOption& argument : command.arguments) {
        const std::string shown = value(argument.value);
        text += argument.is_required ? " " + shown : " [" + shown + "]";
        if (argument.takes_several)
            text += command.most_arguments == 2 ? " [" + shown + "]" : "...";
    }
    return text;
}

}  // namespace scb::app
