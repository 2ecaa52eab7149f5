#pragma once

#include <map>
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
};

/// By option, of those that say it.
using OptionTable = std::map<const CLI::Option*, OptionValues>;

}  // namespace scb::app
