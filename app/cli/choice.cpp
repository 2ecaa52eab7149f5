#include "app/cli/choice.h"

#include <algorithm>

#include "core/platform/near_word.h"
#include "scb/error.h"

namespace scb::app {

std::string offered(const std::vector<std::string>& words) {
    std::string text = words[0];
    for (std::size_t i = 1; i < words.size(); ++i)
        text += (i + 1 < words.size() ? ", " : " or ") + words[i];
    return text;
}

std::vector<Choice<std::string>> words_as_choices(const std::vector<std::string>& words) {
    std::vector<Choice<std::string>> choices;
    for (const std::string& word : words) choices.push_back({word, word});
    return choices;
}

Option add_word_option(const Command& command, const std::string& names,
                       const std::vector<std::string>& words,
                       const std::function<void(std::size_t)>& use, const std::string& help) {
    const std::string name = names.substr(0, names.find(','));
    const Option option = command.add_option_function(
        names,
        [words, name, use](const std::string& text) {
            const auto found = std::find(words.begin(), words.end(), text);
            if (found == words.end()) {
                const std::string near = did_you_mean(text, words);
                throw InputError(name + " " + (text.empty() ? "''" : text) + ": " +
                                 (near.empty() ? "" : "unknown" + near + "; ") + "give " +
                                 offered(words) + ".");
            }
            use(static_cast<std::size_t>(found - words.begin()));
        },
        help);
    return option.offer(words);
}

}  // namespace scb::app
