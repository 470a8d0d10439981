#include <algorithm>
#include <utility>

#include "base/toml/toml_text_editor.h"

namespace gsim::base {

void TomlTextEditor::remove(const TomlPath& path) {
    if (remove_within(path)) return;
    std::vector<TomlRange> bytes = byte_ranges(path);
    std::string text = text_;
    for (auto each = bytes.rbegin(); each != bytes.rend(); ++each) {
        const TomlRange all = with_blank_lines(*each);
        text.erase(all.begin, all.end - all.begin);
    }
    change({0, text_.size()}, text);
}

// Removes the value from brackets or braces, if it is inside.
bool TomlTextEditor::remove_within(const TomlPath& path) {
    for (std::size_t size = path.size(); size-- > 0;) {
        const auto dot = path.begin() + static_cast<std::ptrdiff_t>(size);
        const TomlPath outer(path.begin(), dot);
        const TomlPath inner(dot, path.end());
        const TomlValueSpan* value_span = find(outer);
        if (value_span == nullptr) continue;
        if (value_span->kind == TomlValueSpan::Kind::array) {
            remove_item(*value_span, std::get<std::size_t>(inner.front()));
            return true;
        }
        for (std::size_t i = value_span->items.size(); i-- > 0;) {
            if (!has_prefix(value_span->items[i].key, inner)) continue;
            remove_item(*value_span, i);
            value_span = find(outer);
            if (value_span == nullptr) break;
        }
        return true;
    }
    return false;
}

// A comment above several keys may be about all of them, so it is removed with the last one.
TomlRange TomlTextEditor::lines_with(const TomlStatement& statement) const {
    const std::string_view after = between(statement.end, text_.size());
    const bool standalone = is_blank(after.substr(0, after.find('\n'))) || statement.below > statement.end;
    return {standalone && statement.above > layout_.begin ? statement.above : statement.begin, statement.end};
}

// A comment at the head of the file is about the file.
TomlRange TomlTextEditor::section_bytes(std::size_t header) const {
    const TomlStatement& first = layout_.statements[header];
    std::size_t end = first.below;
    for (std::size_t i = header + 1; i < layout_.statements.size() && layout_.statements[i].is_pair(); ++i)
        end = layout_.statements[i].below;
    return {first.above > layout_.begin ? first.above : first.begin, end};
}

/// Adds blank lines to the range: of those on both sides, one side's stay; at the end of the file none do.
TomlRange TomlTextEditor::with_blank_lines(TomlRange bytes) const {
    const std::string_view before = between(layout_.begin, bytes.begin);
    if (is_blank(between(bytes.end, text_.size()))) {
        const std::size_t last = before.find_last_not_of(" \t\r\n");
        if (last == std::string_view::npos) return {layout_.begin, text_.size()};
        return {layout_.begin + before.find('\n', last) + 1, text_.size()};
    }
    const std::string_view line = between(line_begin(bytes.begin == 0 ? 0 : bytes.begin - 1), bytes.begin);
    if (!is_blank(line)) return bytes;
    while (true) {
        const std::size_t end = text_.find('\n', bytes.end);
        if (end == std::string::npos || !is_blank(between(bytes.end, end))) return bytes;
        bytes.end = end + 1;
    }
}

/// Returns the lines of a table with everything below it, or of keys.
std::vector<TomlRange> TomlTextEditor::byte_ranges(const TomlPath& path) const {
    std::vector<TomlRange> all;
    for (std::size_t i = 0; i < layout_.statements.size(); ++i) {
        const TomlStatement& statement = layout_.statements[i];
        if (!has_prefix(statement.address, path)) continue;
        const bool belongs_to_table = statement.is_pair() && statement.header != TomlLayout::kNoHeader &&
                                      has_prefix(layout_.statements[statement.header].address, path);
        if (belongs_to_table) continue;
        const TomlRange bytes = statement.is_pair() ? lines_with(statement) : section_bytes(i);
        const bool follows = !all.empty() && is_blank(between(all.back().end, bytes.begin));
        if (follows) {
            all.back().end = bytes.end;
        } else {
            all.push_back(bytes);
        }
    }
    return all;
}

std::size_t TomlTextEditor::section_end(const TomlPath& path) const {
    std::size_t end = text_.size();
    for (std::size_t i = 0; i < layout_.statements.size(); ++i) {
        if (has_prefix(layout_.statements[i].address, path)) end = layout_.statements[i].below;
    }
    return end;
}

std::string TomlTextEditor::entry_block(const TomlPath& entry) const {
    std::string block;
    for (const TomlRange& bytes : byte_ranges(entry)) {
        if (!block.empty()) block += line_end();
        block += between(bytes.begin, bytes.end);
        if (!block.ends_with('\n')) block += line_end();
    }
    return block;
}

void TomlTextEditor::move(const TomlPath& list, std::size_t from, std::size_t to) {
    if (const TomlValueSpan* const value_span = find(list)) return move_item(*value_span, from, to);
    const auto is_entry = [&](const TomlStatement& each, std::size_t index) {
        return each.kind == TomlStatement::Kind::entry && each.address == below(list, index);
    };
    const auto separated =
        std::any_of(layout_.statements.begin(), layout_.statements.end(), [&](const TomlStatement& each) {
            return is_entry(each, std::max<std::size_t>(from, 1)) &&
                   is_blank(between(line_begin(each.above - 1), each.above));
        });
    const std::string block = entry_block(below(list, from));
    remove(below(list, from));
    std::size_t at = section_end(list);
    for (const TomlStatement& each : layout_.statements) {
        if (is_entry(each, to)) at = each.above > layout_.begin ? each.above : each.begin;
    }
    add_block(at, block, separated);
}

}  // namespace gsim::base
