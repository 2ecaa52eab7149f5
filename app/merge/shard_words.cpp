#include "app/merge/shard_words.h"

#include <algorithm>

#include "core/platform/tokens.h"
#include "scb/error.h"

namespace scb::app {
namespace {

bool may_have(const ReferenceCommand& command, const std::string& word) {
    const std::size_t equal = word.find('=');
    const std::string name = word.substr(0, equal);
    return name.starts_with("--") &&
           std::any_of(command.options.begin(), command.options.end(),
                       [&](const ReferenceOption& option) {
                           return option.is_shareable && option.has_name(name) &&
                                  (!option.takes_value || equal != std::string::npos);
                       });
}

}  // namespace

void check_shard_words(const std::filesystem::path& file, const std::vector<std::string>& words,
                       const ReferenceCommand& program) {
    const ReferenceCommand* command = &program;
    auto word = words.begin();
    for (; word != words.end(); ++word) {
        const auto& commands = command->commands;
        const auto sub =
            std::find_if(commands.begin(), commands.end(),
                         [&](const ReferenceCommand& known) { return known.word() == *word; });
        if (sub == commands.end()) break;
        command = &*sub;
    }
    for (; word != words.end(); ++word)
        if (word->starts_with('-') && !may_have(*command, *word))
            throw InputError(file.string() + ": its command has '" + excerpt(*word) +
                             "', which no shard of `" + command->name +
                             "` leaves to `scb merge`; give what `--shard` has written.");
}

}  // namespace scb::app
