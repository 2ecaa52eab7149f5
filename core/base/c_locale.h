#pragma once

#include <locale.h>

namespace scb {

/// While it lives, printf, strtod and their like in this thread write and read numbers as in the C
/// locale: with a point, whatever locale the host program has set (POSIX, uselocale).
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
