#include "app/cli/command.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace scb::app {

namespace {

/// An option that refuses empty values. An empty value comes from an unset variable of the shell,
/// and would count as an option that was not given.
CLI::Option* with_value(CLI::Option* option) {
    option->check(CLI::Validator(
        [](std::string& text) { return text.empty() ? "the value is empty; give one" : ""; }, ""));
    return option;
}

}  // namespace

Option Option::check(Check accepted) const {
    option_->check(CLI::Validator([accepted](std::string& text) { return accepted(text); }, ""));
    return *this;
}
Option Option::type_name(const std::string& name) const {
    option_->type_name(name);
    return *this;
}
Option Option::file(const std::vector<std::string>& endings) const {
    table_->values[option_] = {.endings = endings};
    return type_name(endings.size() == 1 ? "FILE" + endings[0] : "FILE");
}
Option Option::folder() const {
    table_->values[option_] = {.is_folder = true};
    return type_name("DIR");
}
Option Option::any_case() const {
    option_->transform(CLI::Validator(
        [](std::string& text) {
            text = CLI::detail::to_lower(text);
            return "";
        },
        ""));
    return *this;
}
Option Option::offer(const std::vector<std::string>& words) const {
    table_->values[option_].words = words;
    return *this;
}
Option Option::offer_list(const std::vector<std::string>& words) const {
    table_->values[option_].is_list = true;
    return offer(words);
}
Option Option::description(const std::string& text) const {
    option_->description(text);
    return *this;
}
Option Option::show_default() const {
    option_->capture_default_str();
    return *this;
}
Option Option::default_str(const std::string& text) const {
    option_->default_str(text);
    return *this;
}
Option Option::required(bool is) const {
    option_->required(is);
    return *this;
}
Option Option::expected(int count) const {
    option_->expected(count);
    return *this;
}
Option Option::expected(int least, int most) const {
    option_->expected(least, most);
    return *this;
}
Option Option::delimiter(char separator) const {
    option_->delimiter(separator);
    return *this;
}
Option Option::envname(const std::string& name) const {
    option_->envname(name);
    return *this;
}
Option Option::only_typed() const {
    table_->only_typed.insert(option_);
    return *this;
}

Option Option::only_typed(const std::string& word, const std::string& reason) const {
    table_->values[option_].only_typed.emplace(word, reason);
    return *this;
}
Option Option::shareable() const {
    table_->shareable.insert(option_);
    return *this;
}
Option Option::hide() const {
    option_->group("");
    return *this;
}

template <class T>
Option Command::add_option(const std::string& names, T& value, const std::string& help) const {
    return Option(with_value(app_->add_option(names, value, help)), *table_);
}
template Option Command::add_option(const std::string&, std::string&, const std::string&) const;
template Option Command::add_option(const std::string&, int&, const std::string&) const;
template Option Command::add_option(const std::string&, std::int64_t&, const std::string&) const;
template Option Command::add_option(const std::string&, std::size_t&, const std::string&) const;
template Option Command::add_option(const std::string&, double&, const std::string&) const;
template Option Command::add_option(const std::string&, std::optional<int>&,
                                    const std::string&) const;
template Option Command::add_option(const std::string&, std::optional<std::int64_t>&,
                                    const std::string&) const;
template Option Command::add_option(const std::string&, std::optional<double>&,
                                    const std::string&) const;
template Option Command::add_option(const std::string&, std::vector<std::string>&,
                                    const std::string&) const;
template Option Command::add_option(const std::string&, std::vector<double>&,
                                    const std::string&) const;

Option Command::add_option_function(const std::string& names,
                                    const std::function<void(const std::string&)>& use,
                                    const std::string& help) const {
    return Option(app_->add_option_function<std::string>(names, use, help), *table_);
}

Option Command::add_flag(const std::string& names, bool& value, const std::string& help) const {
    return Option(app_->add_flag(names, value, help), *table_);
}

Option Command::get_option(const std::string& name) const {
    return Option(app_->get_option(name), *table_);
}

void Command::remove_option(const std::string& name) const {
    CLI::Option* option = app_->get_option(name);
    table_->values.erase(option);
    table_->only_typed.erase(option);
    table_->shareable.erase(option);
    app_->remove_option(option);
}

std::size_t Command::count(const std::string& name) const {
    const CLI::Option* option = app_->get_option(name);
    return table_->from_file.contains(option) ? 0 : option->count();
}

Command Command::add_subcommand(const std::string& name, const std::string& help) const {
    return Command(*app_->add_subcommand(name, help), *table_);
}

void Command::require_subcommand() const {
    app_->require_subcommand(1);
    app_->fallthrough();
}

void Command::hide() const { app_->group(""); }

void Command::footer(const std::string& text) const { app_->footer(text); }

void Command::callback(std::function<void()> chosen) const { app_->callback(std::move(chosen)); }

}  // namespace scb::app
