#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace CLI {
class Option;
}  // namespace CLI

namespace scb::app {

/// What can be offered for the value of an option, for who completes a command line.
struct OptionValues {
    std::vector<std::string> words{};
    bool is_list = false;                ///< several of the words, with commas
    std::vector<std::string> endings{};  ///< of files: ".json"
    bool is_folder = false;
    std::map<std::string, std::string> only_typed{};  ///< by word: why, see Option::only_typed
};

/// What is known of options beside what the parser knows.
struct OptionTable {
    std::map<const CLI::Option*, OptionValues> values{};
    std::set<const CLI::Option*> only_typed{};  ///< see Option::only_typed
    std::set<const CLI::Option*> shareable{};   ///< see Option::shareable
    std::set<const CLI::Option*> from_file{};   ///< those that a configuration file has given
};

}  // namespace scb::app
