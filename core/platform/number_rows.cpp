#include "core/platform/number_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/text_format.h"
#include "core/platform/tokens.h"
#include "scb/error.h"

namespace scb {
namespace {

/// Blanks about a comma or semicolon belong to it.
NumberRows::Cells cells_of(std::string_view line) {
    constexpr std::string_view blanks = " \t\r\v\f", separators = " \t\r\v\f,;";
    const auto skip_blanks = [&] {
        line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    };
    NumberRows::Cells cells;
    skip_blanks();
    while (true) {
        const std::size_t end = std::min(line.find_first_of(separators), line.size());
        cells.push_back(line.substr(0, end));
        line.remove_prefix(end);
        skip_blanks();
        if (line.empty()) return cells;
        if (line.front() != ',' && line.front() != ';') continue;
        line.remove_prefix(1);
        skip_blanks();
    }
}

std::string_view unquoted(std::string_view cell) {
    const bool is_quoted = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
    return is_quoted ? cell.substr(1, cell.size() - 2) : cell;
}

/// Numbers in quotes are refused, but not taken for a header.
bool has_number(const NumberRows::Cells& cells) {
    return std::any_of(cells.begin(), cells.end(),
                       [](std::string_view cell) { return number_in(unquoted(cell)).has_value(); });
}

}  // namespace

std::optional<NumberRows::Cells> NumberRows::next() {
    while (const std::optional<std::string_view> line = lines_.next()) {
        Cells cells = cells_of(*line);
        const bool is_blank = cells.size() == 1 && cells[0].empty();
        if (is_blank || cells[0].starts_with('#')) continue;
        if (std::exchange(began_, true) || has_number(cells)) return cells;
        header_.assign(cells.begin(), cells.end());
    }
    return std::nullopt;
}

std::vector<double> NumberRows::numbers(const Cells& cells, double most) const {
    std::vector<double> numbers;
    for (const std::string_view cell : cells) {
        const std::optional<double> number = number_in(cell);
        if (!number || !(std::abs(*number) <= most))
            refuse("'" + excerpt(cell) + "' is not a number within " + exact_number(most) +
                   "; correct the row.");
        numbers.push_back(*number);
    }
    return numbers;
}

void NumberRows::refuse(const std::string& sentence) const {
    throw InputError(place() + ": " + sentence);
}

}  // namespace scb
