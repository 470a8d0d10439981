#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/toml/toml_text_editor.h"

namespace gsim::base {

using nlohmann::ordered_json;

namespace {

/// True if a value becomes tables on their own lines if possible: an object, or a list of objects.
bool is_section(const ordered_json& value) {
    const auto is_object = [](const ordered_json& each) { return each.is_object(); };
    return value.is_object() ||
           (value.is_array() && !value.empty() && std::all_of(value.begin(), value.end(), is_object));
}

bool has_number(const TomlPath& path) {
    return std::any_of(path.begin(), path.end(),
                       [](const TomlStep& step) { return std::holds_alternative<std::size_t>(step); });
}

/// True if the line just above `at` is blank, or no text precedes it.
bool ends_with_blank_line(std::string_view before) {
    if (is_blank(before)) return true;
    const std::size_t last = before.find_last_not_of(" \t");
    if (last == std::string_view::npos || before[last] != '\n') return false;
    std::string_view above = before.substr(0, last);
    if (above.ends_with('\r')) above.remove_suffix(1);
    const std::size_t end = above.find_last_not_of(" \t");
    return end == std::string_view::npos || above[end] == '\n';
}

}  // namespace

void TomlTextEditor::add_key(const TomlPath& table, const std::string& key, const ordered_json& value) {
    if (add_inline(table, key, value)) return;
    const auto& statements = layout_.statements;
    const auto is_header = [&](const TomlStatement& each) {
        return !each.is_pair() && each.address == table;
    };
    const auto header = std::find_if(statements.begin(), statements.end(), is_header);
    if (table.empty() || header != statements.end()) {
        if (is_section(value) && !has_number(table)) {
            const std::string_view marks = value.is_array() ? "[[]]" : "[]";
            const std::size_t half = marks.size() / 2;
            const std::string name =
                fmt::format("{}{}{}{}", marks.substr(0, half), toml_keys(below(table, key)),
                            marks.substr(half), line_end());
            std::string block;
            for (const ordered_json& each : value.is_array() ? value : ordered_json::array({value}))
                block += (block.empty() ? "" : std::string(line_end())) + name + table_lines(each, "");
            return add_block(table.empty() ? text_.size() : section_end(table), std::move(block), true);
        }
        const auto head_index = static_cast<std::size_t>(header - statements.begin());
        return add_line(table.empty() ? TomlLayout::kNoHeader : head_index, table, key, value);
    }
    const auto below = std::find_if(statements.begin(), statements.end(), [&](const TomlStatement& each) {
        return has_prefix(each.address, table);
    });
    if (below == statements.end()) return;
    if (below->is_pair()) return add_line(below->header, table, key, value);
    const std::string header_line = fmt::format("[{}]{}", toml_keys(table), line_end());
    const ordered_json as_table{{key, value}};
    add_block(below->above, header_line + table_lines(as_table, ""), true);
}

// Adds the key inside braces, if the table is in braces, or one from which a dotted key leads to it.
bool TomlTextEditor::add_inline(const TomlPath& table, const std::string& key, const ordered_json& value) {
    for (std::size_t size = table.size(); size > 0; --size) {
        const auto dot = table.begin() + static_cast<std::ptrdiff_t>(size);
        const TomlValueSpan* const value_span = find(TomlPath(table.begin(), dot));
        if (value_span == nullptr || value_span->kind != TomlValueSpan::Kind::table) continue;
        const TomlPath dotted(dot, table.end());
        std::size_t after = value_span->items.size();
        while (after > 0 && !has_prefix(value_span->items[after - 1].key, dotted)) --after;
        add_item(
            *value_span, after,
            fmt::format("{} = {}", toml_keys(below(dotted, key)), value_like_neighbors(value, *value_span)));
        return true;
    }
    return false;
}

// Adds a line that follows the last one of its table, in the style of that one.
void TomlTextEditor::add_line(std::size_t header, const TomlPath& table, const std::string& key,
                              const ordered_json& value) {
    const TomlStatement* last = nullptr;
    std::vector<const TomlValueSpan*> siblings;
    for (const TomlStatement& each : layout_.statements) {
        if (!each.is_pair() || each.header != header) continue;
        siblings.push_back(&each.item.value);
        if (has_prefix(each.address, table)) last = &each;
    }
    const std::size_t known = header == TomlLayout::kNoHeader ? 0 : layout_.statements[header].address.size();
    const std::string name = toml_keys(below(table, key), known);
    const std::string written = toml_value(value, neighbor_number_style(siblings));
    if (last == nullptr) return add_first_line(header, fmt::format("{} = {}", name, written));
    const bool close = between(last->item.key_end, last->item.value.bytes.begin) == "=";
    const std::string line =
        fmt::format("{}{}{}{}", between(last->begin, last->item.begin), name, close ? "=" : " = ", written);
    if (between(0, last->end).ends_with('\n')) {
        change({last->end, last->end}, fmt::format("{}{}", line, line_end()));
    } else {
        change({last->end, last->end}, fmt::format("{}{}", line_end(), line));
    }
}

void TomlTextEditor::add_first_line(std::size_t header, const std::string& line) {
    if (header == TomlLayout::kNoHeader) {
        std::size_t at = text_.size();
        if (!layout_.statements.empty()) {
            const TomlStatement& first = layout_.statements.front();
            at = first.above == layout_.begin ? first.begin : first.above;  // below the comment of the file
        }
        return add_block(at, fmt::format("{}{}", line, line_end()), true);
    }
    const TomlStatement& statement = layout_.statements[header];
    const std::string_view statement_text = between(statement.begin, statement.end);
    const std::string_view indent = statement_text.substr(0, statement_text.find_first_not_of(" \t"));
    if (statement_text.ends_with('\n')) {
        change({statement.end, statement.end}, fmt::format("{}{}{}", indent, line, line_end()));
    } else {
        change({statement.end, statement.end}, fmt::format("{}{}{}", line_end(), indent, line));
    }
}

void TomlTextEditor::add_element(const TomlPath& list, std::size_t index, const ordered_json& value) {
    const TomlValueSpan* const value_span = find(list);
    if (value_span != nullptr) add_item(*value_span, index, value_like_neighbors(value, *value_span));
}

// Adds an item after this number of existing items.
void TomlTextEditor::add_item(const TomlValueSpan& value_span, std::size_t after, const std::string& item) {
    if (value_span.items.empty()) {
        const TomlRange inside{value_span.bytes.begin + 1, value_span.bytes.end - 1};
        const bool braces = value_span.kind == TomlValueSpan::Kind::table;
        const std::string padded = braces ? fmt::format(" {} ", item) : item;
        if (is_blank(between(inside.begin, inside.end))) return change(inside, padded);
        return change({inside.begin, inside.begin}, padded);  // in front of a comment
    }
    if (after > 0 && add_below(value_span, after - 1, item)) return;
    if (after < value_span.items.size() && add_above(value_span, after, item)) return;
    if (after == 0) {
        const std::size_t first = value_span.items.front().begin;
        return change({first, first}, fmt::format("{}, ", item));
    }
    const std::size_t end = value_span.items[after - 1].value.bytes.end;
    change({end, end}, fmt::format(", {}", item));
}

void TomlTextEditor::add_entry(const TomlPath& list, const ordered_json& table) {
    const TomlStatement* last = nullptr;
    for (const TomlStatement& each : layout_.statements) {
        if (each.kind == TomlStatement::Kind::entry && each.address.size() == list.size() + 1 &&
            has_prefix(each.address, list))
            last = &each;
    }
    if (last == nullptr) return;
    const std::string_view statement_text = between(last->begin, last->end);
    const std::string indent(statement_text.substr(0, statement_text.find('[')));
    const bool separated = ends_with_blank_line(between(layout_.begin, last->above));
    add_block(section_end(list),
              fmt::format("{}[[{}]]{}{}", indent, toml_keys(list), line_end(), table_lines(table, indent)),
              separated);
}

std::string TomlTextEditor::table_lines(const ordered_json& table, std::string_view indent) const {
    const TomlNumbers numbers = neighbor_number_style({});
    std::string lines;
    for (const auto& [key, value] : table.items())
        lines += fmt::format("{}{} = {}{}", indent, toml_key(key), toml_value(value, numbers), line_end());
    return lines;
}

// Adds complete lines between others, with a blank line on both sides if `separated`.
void TomlTextEditor::add_block(std::size_t at, std::string block, bool separated) {
    const std::string_view before = between(layout_.begin, at);
    const bool open = !before.empty() && !before.ends_with('\n');  // the last line of the file has no end
    std::string front;
    if (open) front += line_end();
    if (separated && !ends_with_blank_line(before)) front += line_end();
    const std::string_view after = between(at, text_.size());
    if (after.empty()) {
        if (open) block.resize(block.size() - line_end().size());
    } else if (separated && !is_blank(after.substr(0, after.find('\n')))) {
        block += line_end();
    }
    change({at, at}, front + block);
}

}  // namespace gsim::base
