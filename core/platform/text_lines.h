#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/platform/file_window.h"

namespace scb {

/// The lines of a text file, from front to back, so that memory does not depend on its size. Line
/// ends are LF or CR LF. A byte order mark of UTF-8 is passed over.
class TextLines {
  public:
    /// Throws InputError as FileWindow does.
    explicit TextLines(const std::string& path);

    /// The next line without its end, valid until the next call; none at the end of the file.
    /// Throws InputError at a line of more than 64 KiB.
    std::optional<std::string_view> next();

    /// The number of the last line, from 1.
    std::size_t number() const { return number_; }
    /// "log.csv: line 17", for messages.
    std::string place() const;

  private:
    FileWindow file_;
    std::size_t number_ = 0, taken_ = 0;  ///< `taken_`: bytes of the last line, with its end
};

}  // namespace scb
