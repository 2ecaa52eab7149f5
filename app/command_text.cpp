#include "app/command_text.h"

#include <algorithm>

namespace scb {

std::string shell_word(const std::string& text) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789%+,-./:=@_";
    const auto is_plain = [&](char c) { return plain.find(c) != std::string_view::npos; };
    if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return text;
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
    return word + "'";
}

std::string given_text(const CLI::App& command, const std::vector<std::string>& options) {
    std::string text;
    for (const std::string& name : options) {
        const CLI::Option* option = command.get_option(name);
        if (option->count() == 0) continue;
        const bool positional = option->get_positional();
        if (!positional) text += " " + name;
        if (option->get_items_expected_max() == 0) continue;  // a flag
        std::string values;
        for (const std::string& value : option->results()) {
            const char* separator = values.empty() ? "" : positional ? " " : ",";
            // A name that begins like an option.
            const bool dashed = positional && value.starts_with('-');
            values += separator + shell_word(dashed ? "./" + value : value);
        }
        text += " " + values;
    }
    return text;
}

}  // namespace scb
