#pragma once

#include <clocale>
#include <cstdlib>
#include <locale>
#include <string>

#include "tests/temporary_folder.h"

namespace scb {

/// While it lives, this program has the locale of a German host, whose numbers have a comma: in C,
/// where `is_set` says that localedef could make such a locale, and in the streams of C++.
class HostLocale {
  public:
    bool is_set = false;

    HostLocale() {
        const std::string name = folder_ / "de_DE.UTF-8";
        const std::string command =
            "localedef -i de_DE -f UTF-8 '" + name + "' >'" + (folder_ / "said") + "' 2>&1";
        ::setenv("LOCPATH", folder_.path.c_str(), 1);
        is_set =
            std::system(command.c_str()) == 0 && std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
        before_ = std::locale::global(std::locale(std::locale::classic(), new Commas));
    }
    ~HostLocale() {
        std::locale::global(before_);
        std::setlocale(LC_ALL, "C");
        ::unsetenv("LOCPATH");
    }
    HostLocale(const HostLocale&) = delete;
    HostLocale& operator=(const HostLocale&) = delete;

  private:
    struct Commas : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };

    TemporaryFolder folder_;
    std::locale before_;
};

}  // namespace scb
