#pragma once

#include <locale.h>

namespace scb {

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
