#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scb::app {

/// A cell of a table: its value, and the text that readers see.
struct Cell {
    nlohmann::ordered_json value;  ///< a number, a text or a truth value; null for none
    std::string text;

    /// Without a value.
    Cell() = default;
    Cell(std::string word) : value(word), text(std::move(word)) {}
    Cell(const char* word) : Cell(std::string(word)) {}
    Cell(std::string_view word) : Cell(std::string(word)) {}
    template <std::integral T>
    Cell(T number) : value(number), text(std::to_string(number)) {}
    /// `pattern`: of printf for one double, for the text.
    Cell(double number, const char* pattern);
    Cell(nlohmann::ordered_json its_value, std::string its_text)
        : value(std::move(its_value)), text(std::move(its_text)) {}
};

enum class Align { right, left };

/// A column of a table. Without a title it is not shown to readers; without a key it is neither in
/// CSV nor in JSON.
struct Column {
    std::string title{}, key{};
    std::size_t width = 0;  ///< in characters, in the text
    Align align = Align::right;
    std::size_t before = 0;  ///< blanks before the cell, in the text
    bool in_csv = true;
};

/// A table for readers (text, HTML) and programs (CSV, JSON).
class Table {
  public:
    explicit Table(std::vector<Column> columns = {}) : columns_(std::move(columns)) {}

    /// Adds a row. It may lack cells of the last columns. `note`: appended to the line of text.
    void add(std::vector<Cell> cells, std::string note = {});

    std::size_t size() const { return rows_.size(); }

    /// The line of the titles, and the line of a row. A left-aligned cell of the last column is not
    /// padded.
    std::string text_header() const;
    std::string text_row(std::size_t row) const;
    std::string text() const;

    /// The line of the keys, and the lines of all rows, as RFC 4180 says, but with a line feed at
    /// their ends. Truth values are 1 and 0; a cell without a value is empty. `start`: before each
    /// row.
    std::string csv_header() const;
    std::string csv_rows(const std::string& start = {}) const;

    /// An object for each row, without the cells that have no value.
    nlohmann::ordered_json json() const;

    /// The element `table`, with the notes in a last column.
    std::string html() const;

  private:
    std::string text_cell(std::size_t column, const std::string& text) const;

    struct Row {
        std::vector<Cell> cells;
        std::string note;
    };

    std::vector<Column> columns_;
    std::vector<Row> rows_;
};

/// A column of a table of `Row`s, and its cell of a row.
template <class Row>
struct Field {
    Column column;
    std::function<Cell(const Row&)> cell;
};

template <class Row>
Table table_of(const std::vector<Field<Row>>& fields, const std::vector<Row>& rows = {}) {
    std::vector<Column> columns;
    for (const Field<Row>& field : fields) columns.push_back(field.column);
    Table table(std::move(columns));
    for (const Row& row : rows) {
        std::vector<Cell> cells;
        for (const Field<Row>& field : fields) cells.push_back(field.cell(row));
        table.add(std::move(cells));
    }
    return table;
}

/// A field of a line of CSV (RFC 4180). A text with a colon is quoted too, since print_result would
/// change a name that begins with two colons.
std::string csv_field(const std::string& text);

}  // namespace scb::app
