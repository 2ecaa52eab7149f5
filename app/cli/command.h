#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/cli/option_values.h"

namespace CLI {
class App;
}  // namespace CLI

namespace scb::app {

/// Checks a value: returns an empty text, or what is wrong with the value.
using Check = std::string (*)(const std::string& text);

/// An option of a command, being described. A handle: copies refer to the same option. It wraps
/// CLI11, which no header includes, since it takes five seconds to compile.
class Option {
  public:
    Option(CLI::Option* option, OptionTable& table) : option_(option), table_(&table) {}

    Option check(Check accepted) const;
    /// The name of its value in help: "N".
    Option type_name(const std::string& name) const;
    /// The value is a file with one of these endings, such as ".json", or a folder: "FILE.json",
    /// "DIR".
    Option file(const std::vector<std::string>& endings) const;
    Option folder() const;
    /// Reads the value in lower case.
    Option any_case() const;
    /// Words to offer; other values may be valid, too.
    Option offer(const std::vector<std::string>& words) const;
    /// The value is a list of these words, with commas.
    Option offer_list(const std::vector<std::string>& words) const;
    Option description(const std::string& text) const;
    /// Shows the present value as the default in help.
    Option show_default() const;
    Option default_str(const std::string& text) const;
    Option required(bool is = true) const;
    /// The number of values.
    Option expected(int count) const;
    Option expected(int least, int most) const;
    Option delimiter(char separator) const;
    /// An environment variable for the value, if the command line has none.
    Option envname(const std::string& name) const;
    /// No configuration file may set the option: it controls what is written or run, and the file
    /// may be a stranger's.
    Option only_typed() const;
    /// No configuration file may set this word. `reason` follows "for" in the message.
    Option only_typed(const std::string& word, const std::string& reason) const;
    /// `scb merge` takes the option from a shard's file, which may be a stranger's. So the option
    /// must only affect what is drawn or counted, not where files are written or what is run.
    Option shareable() const;
    /// Hides the option in help.
    Option hide() const;

  private:
    CLI::Option* option_;
    OptionTable* table_;
};

/// A command of the program, being described. A handle.
class Command {
  public:
    Command(CLI::App& app, OptionTable& table) : app_(&app), table_(&table) {}

    /// `names`: "SCENE", "--size", "-o,--output", "--frames,--frame". `value` is set to the given
    /// value. T: std::string, int, std::int64_t, std::size_t, double, std::optional of one of
    /// these, or a std::vector of texts or doubles.
    template <class T>
    Option add_option(const std::string& names, T& value, const std::string& help) const;
    Option add_option_function(const std::string& names,
                               const std::function<void(const std::string&)>& use,
                               const std::string& help) const;
    Option add_flag(const std::string& names, bool& value, const std::string& help) const;
    Option get_option(const std::string& name) const;
    void remove_option(const std::string& name) const;
    /// How often the option was given, not counting configuration files.
    std::size_t count(const std::string& name) const;

    Command add_subcommand(const std::string& name, const std::string& help) const;
    /// The command needs a subcommand.
    void require_subcommand() const;
    /// Hides the command in the program's help.
    void hide() const;
    /// Text below the options in the command's help.
    void footer(const std::string& text) const;
    /// Called if the command was chosen, after the whole command line was read.
    void callback(std::function<void()> chosen) const;

    const CLI::App& app() const { return *app_; }
    const OptionTable& table() const { return *table_; }

  private:
    CLI::App* app_;
    OptionTable* table_;
};

}  // namespace scb::app
