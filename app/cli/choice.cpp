#include "app/cli/choice.h"

#include <algorithm>

#include "scb/error.h"

namespace scb::app {

std::string choices(std::span<const std::string_view> words) {
    std::string text(words[0]);
    for (std::size_t i = 1; i < words.size(); ++i)
        text += (i + 1 < words.size() ? ", " : " or ") + std::string(words[i]);
    return text;
}

Option add_word_option(const Command& command, const std::string& names,
                       std::span<const std::string_view> words,
                       const std::function<void(std::size_t)>& use, const std::string& help) {
    const std::vector<std::string> known(words.begin(), words.end());
    const std::string name = names.substr(0, names.find(',')), offered = choices(words);
    return command.add_option_function(
        names,
        [known, name, offered, use](const std::string& text) {
            const auto found = std::find(known.begin(), known.end(), text);
            if (found == known.end())
                throw InputError(name + " " + (text.empty() ? "''" : text) + ": give " + offered +
                                 ".");
            use(static_cast<std::size_t>(found - known.begin()));
        },
        help);
}

}  // namespace scb::app
