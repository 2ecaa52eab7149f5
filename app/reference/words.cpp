#include "app/reference/words.h"

#include <algorithm>

namespace scb::app {

std::string joined(const std::vector<std::string>& parts, const std::string& separator) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : separator) + part;
    return text;
}

std::string escaped(const std::string& text, const std::string& characters) {
    std::string result;
    for (const char c : text) {
        if (characters.find(c) != std::string::npos) result += '\\';
        result += c;
    }
    return result;
}

std::vector<const ReferenceOption*> options_of(const ReferenceCommand& command,
                                               const ReferenceCommand& program) {
    std::vector<const ReferenceOption*> options;
    const auto add = [&options](const ReferenceCommand& from) {
        for (const ReferenceOption& option : from.options)
            if (std::none_of(options.begin(), options.end(), [&](const ReferenceOption* known) {
                    return known->names == option.names;
                }))
                options.push_back(&option);
    };
    add(command);
    add(program);
    return options;
}

int most_arguments(const ReferenceCommand& command) {
    constexpr int endless = 1000;
    const bool has_own = !command.arguments.empty();
    return has_own                         ? std::min(command.most_arguments, endless)
           : command.argument() != nullptr ? endless
                                           : 0;
}

}  // namespace scb::app
