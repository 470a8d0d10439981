#pragma once

#include <string>
#include <vector>

namespace gsim::accuracy {

enum class Align { left, right };

struct Column {
    std::string title;
    Align align = Align::left;
};

using Row = std::vector<std::string>;

/// A table for people: columns as wide as their longest cell, two blanks between. Each row has a cell for
/// each column.
std::string plain_table(const std::vector<Column>& columns, const std::vector<Row>& rows);

/// The same in Markdown; a bar in a cell is escaped.
std::string markdown_table(const std::vector<Column>& columns, const std::vector<Row>& rows);

}  // namespace gsim::accuracy
