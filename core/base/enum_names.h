#pragma once

#include <cassert>
#include <cstddef>
#include <optional>
#include <string_view>

namespace scb {

/// The names of an enumeration with N values, which count up from 0, in the order of the values.
template <class Enum, std::size_t N>
struct EnumNames {
    std::string_view names[N];

    template <class... Names>
    requires(sizeof...(Names) == N) constexpr EnumNames(Names... all) : names{all...} {}

    constexpr std::string_view operator[](Enum value) const {
        assert(static_cast<std::size_t>(value) < N && "every value has a name");
        return names[static_cast<std::size_t>(value)];
    }

    /// The value of that name.
    constexpr std::optional<Enum> find(std::string_view name) const {
        for (std::size_t i = 0; i < N; ++i)
            if (names[i] == name) return static_cast<Enum>(i);
        return std::nullopt;
    }
};

}  // namespace scb
