#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace CLI {
class Option;
}  // namespace CLI

namespace scb::app {

/// Values to offer for an option, for shell completion.
struct OptionValues {
    std::vector<std::string> words{};
    bool is_list = false;                ///< several of the words, with commas
    std::vector<std::string> endings{};  ///< of files: ".json"
    bool is_folder = false;
    std::map<std::string, std::string>
        only_typed{};  ///< by word: the reason, see Option::only_typed
};

/// Properties of options that the parser does not have.
struct OptionTable {
    std::map<const CLI::Option*, OptionValues> values{};
    std::set<const CLI::Option*> only_typed{};  ///< see Option::only_typed
    std::set<const CLI::Option*> shareable{};   ///< see Option::shareable
    std::set<const CLI::Option*> from_file{};   ///< set by a configuration file
};

}  // namespace scb::app
