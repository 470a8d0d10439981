#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "grammar/dialect_rules.h"

namespace gsim::grammar {

/// Letter and number of a code: {'G', 921} is G92.1.
struct CodeNumber {
    char letter = 'G';
    std::int32_t code_x10 = 0;

    bool operator==(const CodeNumber&) const = default;
};

// Return what identifies a row in its table.
constexpr CodeNumber row_key(const Code& code) {
    return {code.letter, code.code_x10};
}
constexpr std::string_view row_key(const Letter& letter) {
    return letter.address;
}
constexpr std::string_view row_key(const ExtendedCommand& command) {
    return command.name;
}
constexpr std::string_view row_key(const lexer::ExpressionName& name) {
    return name.name;
}

template <typename Row>
using RowKey = decltype(row_key(std::declval<const Row&>()));

/// Replaces the row with the same key by each of `rows`, or adds it at the end if there is none.
template <typename Row>
void set_rows(std::vector<Row>& table, std::span<const std::type_identity_t<Row>> rows) {
    for (const Row& row : rows) {
        const auto old_row = std::find_if(table.begin(), table.end(),
                                          [&](const Row& one) { return row_key(one) == row_key(row); });
        if (old_row == table.end()) {
            table.push_back(row);
        } else {
            *old_row = row;
        }
    }
}

/// Removes the rows with these keys. Throws std::invalid_argument if the table has no such row.
template <typename Row>
void remove_rows(std::vector<Row>& table, std::initializer_list<RowKey<Row>> keys) {
    for (const RowKey<Row>& key : keys) {
        if (std::erase_if(table, [&](const Row& row) { return row_key(row) == key; }) == 0)
            throw std::invalid_argument("a dialect removes a row that its base does not have");
    }
}

}  // namespace gsim::grammar
