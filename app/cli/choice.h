#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "app/cli/command.h"
#include "core/base/enum_names.h"

namespace scb::app {

/// A value of an option, and the word for it.
template <class T>
struct Choice {
    std::string word;
    T value;
};

/// All values of an enumeration.
template <class Enum, std::size_t N>
std::vector<Choice<Enum>> choices_of(const EnumNames<Enum, N>& names) {
    std::vector<Choice<Enum>> choices;
    for (const std::string_view name : names.names)
        choices.push_back({std::string(name), *names.find(name)});
    return choices;
}
template <class Enum>
std::vector<Choice<Enum>> choices_of(std::span<const Enum> values,
                                     std::string_view (*name_of)(Enum)) {
    std::vector<Choice<Enum>> choices;
    for (const Enum value : values) choices.push_back({std::string(name_of(value)), value});
    return choices;
}

/// The words as a list for the user: "first, last, dominant or share".
std::string offered(const std::vector<std::string>& words);
template <class T>
std::vector<std::string> words_of(const std::vector<Choice<T>>& choices) {
    std::vector<std::string> words;
    for (const Choice<T>& choice : choices) words.push_back(choice.word);
    return words;
}
template <class T>
std::string offered(const std::vector<Choice<T>>& choices) {
    return offered(words_of(choices));
}

/// An option that takes one of the words; calls `use` with the word's index. For another word,
/// parsing ends with an InputError that lists the words.
Option add_word_option(const Command& command, const std::string& names,
                       const std::vector<std::string>& words,
                       const std::function<void(std::size_t)>& use, const std::string& help);

/// An option whose value is one of the choices; the present value is shown as the default.
template <class T>
Option add_choice(const Command& command, const std::string& names, T& value,
                  const std::vector<Choice<std::type_identity_t<T>>>& choices,
                  const std::string& help) {
    std::string present;
    for (const Choice<T>& choice : choices)
        if (choice.value == value) present = choice.word;
    const auto use = [&value, choices](std::size_t place) { value = choices[place].value; };
    return add_word_option(command, names, words_of(choices), use, help).default_str(present);
}

/// Words that are values themselves.
std::vector<Choice<std::string>> words_as_choices(const std::vector<std::string>& words);

/// The choices of an option that may be left open. `open`: a word for that, if there is one.
template <class T>
std::vector<Choice<std::optional<T>>> optional_choices(const std::vector<Choice<T>>& choices,
                                                       const std::string& open = "") {
    std::vector<Choice<std::optional<T>>> all;
    if (!open.empty()) all.push_back({open, std::nullopt});
    for (const Choice<T>& choice : choices) all.push_back({choice.word, choice.value});
    return all;
}

}  // namespace scb::app
