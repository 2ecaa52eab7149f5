#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/cli/option_values.h"

namespace CLI {
class App;
}  // namespace CLI

namespace scb::app {

/// What a value must be, as a function: empty where it is that, else what is wrong with it.
using Check = std::string (*)(const std::string& text);

/// An option of a command, being described. A handle: copies are of the same option. Behind it is
/// CLI11, which no header includes, since it takes five seconds to compile.
class Option {
  public:
    Option(CLI::Option* option, OptionTable& table) : option_(option), table_(&table) {}

    Option check(Check accepted) const;
    /// What help shows for its value: "N".
    Option type_name(const std::string& name) const;
    /// Its value is a file with one of these endings, such as ".json", or a folder: "FILE.json",
    /// "DIR".
    Option file(const std::vector<std::string>& endings) const;
    Option folder() const;
    /// Words that it takes, among others or not.
    Option offer(const std::vector<std::string>& words) const;
    /// It takes several of these words, with commas.
    Option offer_list(const std::vector<std::string>& words) const;
    Option description(const std::string& text) const;
    /// Has help show the present value as the default.
    Option show_default() const;
    Option default_str(const std::string& text) const;
    Option required(bool is = true) const;
    /// How many values it takes.
    Option expected(int count) const;
    Option expected(int least, int most) const;
    Option delimiter(char separator) const;
    /// An environment variable that gives the value where the command line does not.
    Option envname(const std::string& name) const;
    /// No configuration file may give it: it says what is written, or what is run, and the file may
    /// be a stranger's.
    Option only_typed() const;
    /// No configuration file may give this word: `reason` is what a sentence says behind "for".
    Option only_typed(const std::string& word, const std::string& reason) const;
    /// `scb merge` takes it from the file of a shard, which may be a stranger's: it says what is
    /// drawn or counted, and neither where anything is written nor what is run.
    Option shareable() const;
    /// Leaves it out of the help.
    Option hide() const;

  private:
    CLI::Option* option_;
    OptionTable* table_;
};

/// A command of the program, being described. A handle.
class Command {
  public:
    Command(CLI::App& app, OptionTable& table) : app_(&app), table_(&table) {}

    /// `names`: "SCENE", "--size", "-o,--output", "--frames,--frame". `value` gets what is given.
    /// T: std::string, int, std::int64_t, std::size_t, double, std::optional of one, or a
    /// std::vector of texts or doubles.
    template <class T>
    Option add_option(const std::string& names, T& value, const std::string& help) const;
    Option add_option_function(const std::string& names,
                               const std::function<void(const std::string&)>& use,
                               const std::string& help) const;
    Option add_flag(const std::string& names, bool& value, const std::string& help) const;
    Option get_option(const std::string& name) const;
    void remove_option(const std::string& name) const;
    /// How often the option was given, but for a configuration file.
    std::size_t count(const std::string& name) const;

    Command add_subcommand(const std::string& name, const std::string& help) const;
    /// Makes it one that does nothing without a subcommand.
    void require_subcommand() const;
    /// Leaves it out of the help of the program.
    void hide() const;
    /// Text below the options in its help.
    void footer(const std::string& text) const;
    /// What is called once it was chosen and the whole command line was read.
    void callback(std::function<void()> chosen) const;

    const CLI::App& app() const { return *app_; }
    const OptionTable& table() const { return *table_; }

  private:
    CLI::App* app_;
    OptionTable* table_;
};

}  // namespace scb::app
