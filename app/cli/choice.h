#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "app/cli/command.h"

namespace scb::app {

/// The words, to be offered: "first, last, dominant or share".
std::string choices(std::span<const std::string_view> words);

/// An option that takes one of the words; calls `use` with the word's place among them. Another
/// word ends the command line with an InputError that offers them.
Option add_word_option(const Command& command, const std::string& names,
                       std::span<const std::string_view> words,
                       const std::function<void(std::size_t)>& use, const std::string& help);

/// An option that takes the name of a value of an enumeration. `words` are the names of the values
/// from 0 on, such as EnumNames::names. T: the enumeration, whose present value is shown as the
/// default, or a std::optional of it.
template <class T>
Option add_choice(const Command& command, const std::string& names, T& value,
                  std::span<const std::string_view> words, const std::string& help) {
    if constexpr (std::is_enum_v<T>) {
        const auto use = [&value](std::size_t place) { value = static_cast<T>(place); };
        return add_word_option(command, names, words, use, help)
            .default_str(std::string(words[static_cast<std::size_t>(value)]));
    } else {
        const auto use = [&value](std::size_t place) {
            value = static_cast<typename T::value_type>(place);
        };
        return add_word_option(command, names, words, use, help);
    }
}

/// The names of an enumeration's values.
template <class Enum>
std::vector<std::string_view> words_of(std::span<const Enum> values,
                                       std::string_view (*name_of)(Enum)) {
    std::vector<std::string_view> words;
    for (const Enum value : values) words.push_back(name_of(value));
    return words;
}

}  // namespace scb::app
