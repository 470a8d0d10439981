#include "tests/accuracy/table.h"

#include <algorithm>

#include <fmt/format.h>

namespace gsim::accuracy {

namespace {

std::string plain_row(const std::vector<Column>& columns, const std::vector<std::size_t>& widths,
                      const Row& cells) {
    std::string line;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        line += columns[i].align == Align::right ? fmt::format("{:>{}}  ", cells[i], widths[i])
                                                 : fmt::format("{:<{}}  ", cells[i], widths[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    return line + '\n';
}

Row titles(const std::vector<Column>& columns) {
    Row row;
    for (const Column& column : columns) row.push_back(column.title);
    return row;
}

std::string escaped(const std::string& cell) {
    std::string text;
    for (const char c : cell) {
        if (c == '|') text += '\\';
        text += c;
    }
    return text;
}

std::string markdown_row(const Row& cells) {
    std::string line = "|";
    for (const std::string& cell : cells) line += fmt::format(" {} |", escaped(cell));
    return line + '\n';
}

}  // namespace

std::string plain_table(const std::vector<Column>& columns, const std::vector<Row>& rows) {
    std::vector<std::size_t> widths;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        std::size_t width = columns[i].title.size();
        for (const Row& row : rows) width = std::max(width, row[i].size());
        widths.push_back(width);
    }
    std::string text = plain_row(columns, widths, titles(columns));
    for (const Row& row : rows) text += plain_row(columns, widths, row);
    return text;
}

std::string markdown_table(const std::vector<Column>& columns, const std::vector<Row>& rows) {
    std::string text = markdown_row(titles(columns));
    Row rule;
    for (const Column& column : columns) rule.emplace_back(column.align == Align::right ? "---:" : "---");
    text += markdown_row(rule);
    for (const Row& row : rows) text += markdown_row(row);
    return text;
}

}  // namespace gsim::accuracy
