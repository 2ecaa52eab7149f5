#include "app/report/table.h"

#include "core/base/text_format.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

std::string csv_text(const Json& value) {
    if (value.is_null()) return "";
    if (value.is_string()) return csv_field(value.get<std::string>());
    if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
    return value.is_number_float() ? format("%.17g", value.get<double>()) : value.dump();
}

bool is_in_csv(const Column& column) { return column.in_csv && !column.key.empty(); }

std::string html_text(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '&')
            escaped += "&amp;";
        else if (c == '<')
            escaped += "&lt;";
        else
            escaped += c;
    }
    return escaped;
}

std::string html_cell(const char* element, Align align, const std::string& text) {
    return std::string("<") + element + (align == Align::right ? " class=\"number\">" : ">") +
           html_text(text) + "</" + element + ">";
}

}  // namespace

Cell::Cell(double number, const char* pattern) : value(number), text(format(pattern, number)) {}

std::string Table::text_cell(std::size_t column, const std::string& text) const {
    const Column& c = columns_[column];
    if (c.title.empty()) return "";
    const bool is_padded = c.align == Align::right || column + 1 < columns_.size();
    const std::size_t width = is_padded ? c.width : 0;
    return std::string(c.before, ' ') +
           (c.align == Align::right ? right_aligned(text, width) : left_aligned(text, width));
}

void Table::add(std::vector<Cell> cells, std::string note) {
    rows_.push_back({std::move(cells), std::move(note)});
}

std::string Table::text_header() const {
    std::string line;
    for (std::size_t i = 0; i < columns_.size(); ++i) line += text_cell(i, columns_[i].title);
    return line + "\n";
}

std::string Table::text_row(std::size_t row) const {
    std::string line;
    for (std::size_t i = 0; i < rows_[row].cells.size(); ++i)
        line += text_cell(i, rows_[row].cells[i].text);
    return line + rows_[row].note + "\n";
}

std::string Table::text() const {
    std::string text = text_header();
    for (std::size_t row = 0; row < size(); ++row) text += text_row(row);
    return text;
}

std::string Table::csv_header() const {
    std::string line;
    for (const Column& column : columns_)
        if (is_in_csv(column)) line += (line.empty() ? "" : ",") + csv_field(column.key);
    return line + "\n";
}

std::string Table::csv_rows(const std::string& start) const {
    std::string lines;
    for (const Row& row : rows_) {
        lines += start;
        bool first = true;
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            if (!is_in_csv(columns_[i])) continue;
            lines += first ? "" : ",";
            if (i < row.cells.size()) lines += csv_text(row.cells[i].value);
            first = false;
        }
        lines += "\n";
    }
    return lines;
}

Json Table::json() const {
    Json list = Json::array();
    for (const Row& row : rows_) {
        Json object = Json::object();
        for (std::size_t i = 0; i < row.cells.size(); ++i)
            if (!columns_[i].key.empty() && !row.cells[i].value.is_null())
                object[columns_[i].key] = row.cells[i].value;
        list.push_back(std::move(object));
    }
    return list;
}

std::string Table::html() const {
    std::string text = "<table>\n<tr>";
    for (const Column& column : columns_)
        if (!column.title.empty()) text += html_cell("th", column.align, column.title);
    for (const Row& row : rows_) {
        text += "</tr>\n<tr>";
        for (std::size_t i = 0; i < row.cells.size(); ++i)
            if (!columns_[i].title.empty())
                text += html_cell("td", columns_[i].align, row.cells[i].text);
        if (!row.note.empty()) text += html_cell("td", Align::left, row.note);
    }
    return text + "</tr>\n</table>\n";
}

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",:\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

}  // namespace scb::app
