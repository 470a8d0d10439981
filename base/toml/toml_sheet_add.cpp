#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/toml/toml_sheet.h"

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
bool is_apart(std::string_view before) {
    if (is_blank(before)) return true;
    const std::size_t last = before.find_last_not_of(" \t");
    if (last == std::string_view::npos || before[last] != '\n') return false;
    std::string_view above = before.substr(0, last);
    if (above.ends_with('\r')) above.remove_suffix(1);
    const std::size_t end = above.find_last_not_of(" \t");
    return end == std::string_view::npos || above[end] == '\n';
}

}  // namespace

void TomlSheet::add_key(const TomlPath& table, const std::string& key, const ordered_json& value) {
    if (add_within(table, key, value)) return;
    const auto& statements = layout_.statements;
    const auto is_head = [&](const TomlStatement& each) { return !each.is_pair() && each.address == table; };
    const auto head = std::find_if(statements.begin(), statements.end(), is_head);
    if (table.empty() || head != statements.end()) {
        if (is_section(value) && !has_number(table)) {
            const std::string_view marks = value.is_array() ? "[[]]" : "[]";
            const std::size_t half = marks.size() / 2;
            const std::string name =
                fmt::format("{}{}{}{}", marks.substr(0, half), toml_keys(below(table, key)),
                            marks.substr(half), line_end());
            std::string block;
            for (const ordered_json& each : value.is_array() ? value : ordered_json::array({value}))
                block += (block.empty() ? "" : std::string(line_end())) + name + lines_of(each, "");
            return add_block(table.empty() ? text_.size() : end_of(table), std::move(block), true);
        }
        const auto place = static_cast<std::size_t>(head - statements.begin());
        return add_line(table.empty() ? TomlLayout::kNoHead : place, table, key, value);
    }
    const auto below = std::find_if(statements.begin(), statements.end(), [&](const TomlStatement& each) {
        return leads_through(each.address, table);
    });
    if (below == statements.end()) return;
    if (below->is_pair()) return add_line(below->head, table, key, value);
    const std::string head_line = fmt::format("[{}]{}", toml_keys(table), line_end());
    const ordered_json as_table{{key, value}};
    add_block(below->above, head_line + lines_of(as_table, ""), true);
}

// Adds the key inside braces, if the table is in braces, or one from which a dotted key leads to it.
bool TomlSheet::add_within(const TomlPath& table, const std::string& key, const ordered_json& value) {
    for (std::size_t size = table.size(); size > 0; --size) {
        const auto dot = table.begin() + static_cast<std::ptrdiff_t>(size);
        const TomlSpot* const spot = find(TomlPath(table.begin(), dot));
        if (spot == nullptr || spot->kind != TomlSpot::Kind::table) continue;
        const TomlPath dotted(dot, table.end());
        std::size_t behind = spot->items.size();
        while (behind > 0 && !leads_through(spot->items[behind - 1].key, dotted)) --behind;
        add_item(*spot, behind,
                 fmt::format("{} = {}", toml_keys(below(dotted, key)), value_beside(value, *spot)));
        return true;
    }
    return false;
}

// Adds a line after the last line of its table, in the style of that line.
void TomlSheet::add_line(std::size_t head, const TomlPath& table, const std::string& key,
                         const ordered_json& value) {
    const TomlStatement* last = nullptr;
    std::vector<const TomlSpot*> beside;
    for (const TomlStatement& each : layout_.statements) {
        if (!each.is_pair() || each.head != head) continue;
        beside.push_back(&each.item.value);
        if (leads_through(each.address, table)) last = &each;
    }
    const std::size_t known = head == TomlLayout::kNoHead ? 0 : layout_.statements[head].address.size();
    const std::string name = toml_keys(below(table, key), known);
    const std::string written = toml_value(value, numbers_beside(beside));
    if (last == nullptr) return add_first_line(head, fmt::format("{} = {}", name, written));
    const bool close = between(last->item.key_end, last->item.value.bytes.begin) == "=";
    const std::string line =
        fmt::format("{}{}{}{}", between(last->begin, last->item.begin), name, close ? "=" : " = ", written);
    if (between(0, last->end).ends_with('\n')) {
        change({last->end, last->end}, fmt::format("{}{}", line, line_end()));
    } else {
        change({last->end, last->end}, fmt::format("{}{}", line_end(), line));
    }
}

void TomlSheet::add_first_line(std::size_t head, const std::string& line) {
    if (head == TomlLayout::kNoHead) {
        std::size_t at = text_.size();
        if (!layout_.statements.empty()) {
            const TomlStatement& first = layout_.statements.front();
            at = first.above == layout_.begin ? first.begin : first.above;  // below the comment of the file
        }
        return add_block(at, fmt::format("{}{}", line, line_end()), true);
    }
    const TomlStatement& statement = layout_.statements[head];
    const std::string_view whole = between(statement.begin, statement.end);
    const std::string_view indent = whole.substr(0, whole.find_first_not_of(" \t"));
    if (whole.ends_with('\n')) {
        change({statement.end, statement.end}, fmt::format("{}{}{}", indent, line, line_end()));
    } else {
        change({statement.end, statement.end}, fmt::format("{}{}{}", line_end(), indent, line));
    }
}

void TomlSheet::add_element(const TomlPath& list, std::size_t index, const ordered_json& value) {
    const TomlSpot* const spot = find(list);
    if (spot != nullptr) add_item(*spot, index, value_beside(value, *spot));
}

// Adds an item after this number of existing items.
void TomlSheet::add_item(const TomlSpot& spot, std::size_t behind, const std::string& item) {
    if (spot.items.empty()) {
        const TomlBytes inside{spot.bytes.begin + 1, spot.bytes.end - 1};
        const bool braces = spot.kind == TomlSpot::Kind::table;
        const std::string padded = braces ? fmt::format(" {} ", item) : item;
        if (is_blank(between(inside.begin, inside.end))) return change(inside, padded);
        return change({inside.begin, inside.begin}, padded);  // in front of a comment
    }
    if (behind > 0 && add_below(spot, behind - 1, item)) return;
    if (behind < spot.items.size() && add_above(spot, behind, item)) return;
    if (behind == 0) {
        const std::size_t first = spot.items.front().begin;
        return change({first, first}, fmt::format("{}, ", item));
    }
    const std::size_t end = spot.items[behind - 1].value.bytes.end;
    change({end, end}, fmt::format(", {}", item));
}

void TomlSheet::add_entry(const TomlPath& list, const ordered_json& table) {
    const TomlStatement* last = nullptr;
    for (const TomlStatement& each : layout_.statements) {
        if (each.kind == TomlStatement::Kind::entry && each.address.size() == list.size() + 1 &&
            leads_through(each.address, list))
            last = &each;
    }
    if (last == nullptr) return;
    const std::string_view whole = between(last->begin, last->end);
    const std::string indent(whole.substr(0, whole.find('[')));
    const bool apart = is_apart(between(layout_.begin, last->above));
    add_block(end_of(list),
              fmt::format("{}[[{}]]{}{}", indent, toml_keys(list), line_end(), lines_of(table, indent)),
              apart);
}

std::string TomlSheet::lines_of(const ordered_json& table, std::string_view indent) const {
    const TomlNumbers numbers = numbers_beside({});
    std::string lines;
    for (const auto& [key, value] : table.items())
        lines += fmt::format("{}{} = {}{}", indent, toml_key(key), toml_value(value, numbers), line_end());
    return lines;
}

// Adds complete lines between others, with a blank line on both sides if `apart`.
void TomlSheet::add_block(std::size_t at, std::string block, bool apart) {
    const std::string_view before = between(layout_.begin, at);
    const bool open = !before.empty() && !before.ends_with('\n');  // the last line of the file has no end
    std::string front;
    if (open) front += line_end();
    if (apart && !is_apart(before)) front += line_end();
    const std::string_view after = between(at, text_.size());
    if (after.empty()) {
        if (open) block.resize(block.size() - line_end().size());
    } else if (apart && !is_blank(after.substr(0, after.find('\n')))) {
        block += line_end();
    }
    change({at, at}, front + block);
}

}  // namespace gsim::base
