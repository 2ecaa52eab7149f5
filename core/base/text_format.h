#pragma once

#include <locale.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>

namespace scb {

/// The output of printf as a string.
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);

/// For "%llu" of format: on some systems std::uint64_t is an `unsigned long`.
constexpr unsigned long long wide(std::uint64_t value) { return value; }

/// The number of characters; a character of UTF-8 counts once.
std::size_t character_count(std::string_view text);

/// The text, with blanks after it up to that width in characters.
std::string left_aligned(const std::string& text, std::size_t width);

/// The text, with blanks before it up to that width in characters.
std::string right_aligned(const std::string& text, std::size_t width);

/// The shortest decimal text that reads back as the same double; "inf" or "nan" if not finite.
std::string exact_number(double value);

/// "20,480"
std::string count_text(std::uint64_t count);

/// "1 node", "2,000 nodes"
std::string counted(std::uint64_t count, const char* one, const char* several);

/// "a, b, c": `name` of each element of a range, at most 20 of them and then "...".
template <class Range, class Name = std::identity>
std::string name_list(const Range& range, Name name = {}) {
    constexpr std::size_t most = 20;
    std::string text;
    for (std::size_t i = 0; const auto& entry : range) {
        if (i > 0) text += ", ";
        if (i++ == most) return text + "...";
        text += std::invoke(name, entry);
    }
    return text;
}

/// A short key of a text: FNV-1a of 32 bits (Fowler, Noll, Vo), as eight digits.
std::string short_hash(std::string_view text);

/// The parts in sequence, as a stream writes them, independent of the host program's locale.
template <class... Parts>
std::string sentence(const Parts&... parts) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    (text << ... << parts);
    return text.str();
}

/// During its lifetime, printf, strtod and similar functions in this thread use the C locale:
/// numbers have a decimal point, in any locale of the host program (POSIX, uselocale).
class CLocale {
  public:
    CLocale() : before_(::uselocale(c())) {}
    ~CLocale() { ::uselocale(before_); }
    CLocale(const CLocale&) = delete;
    CLocale& operator=(const CLocale&) = delete;

  private:
    static locale_t c() {
        static const locale_t c = ::newlocale(LC_ALL_MASK, "C", locale_t{});
        return c;
    }

    locale_t before_;
};

}  // namespace scb
