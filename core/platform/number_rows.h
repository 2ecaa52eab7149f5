#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/platform/text_lines.h"

namespace scb {

/// The rows of a text file of numbers. Commas, semicolons or blanks separate the cells of a row.
/// Blank lines and lines that begin with # are left out. A first row
/// without any number is a header.
class NumberRows {
  public:
    using Cells = std::vector<std::string_view>;

    /// Throws InputError as TextLines does.
    explicit NumberRows(const std::string& path) : lines_(path) {}

    /// The next row, valid until the next call; none at the end of the file.
    std::optional<Cells> next();
    /// The cells of the header; empty if there is none.
    const std::vector<std::string>& header() const { return header_; }

    /// The numbers of a row. Throws InputError for a cell that is not a number, or one beyond
    /// `most` in magnitude.
    std::vector<double> numbers(const Cells& cells, double most) const;

    /// The number of the last line, from 1.
    std::size_t line() const { return lines_.number(); }
    /// "log.csv: line 17", for messages.
    std::string place() const { return lines_.place(); }
    /// Throws an InputError that begins with the place.
    [[noreturn]] void refuse(const std::string& sentence) const;

  private:
    TextLines lines_;
    std::vector<std::string> header_;
    bool began_ = false;
};

}  // namespace scb
