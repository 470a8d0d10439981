// Elements in brackets and braces, with the comments about each of them; and what is removed.

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/toml/toml_text_editor.h"

namespace gsim::base {

namespace {

bool has_line_break(std::string_view text) {
    return text.find_first_of("\n#") != std::string_view::npos;
}

bool is_empty(const TomlRange& bytes) {
    return bytes.begin == bytes.end;
}

bool begins_comment(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    return first != std::string_view::npos && text[first] == '#';
}

}  // namespace

TomlElement TomlTextEditor::element_at(const TomlValueSpan& value_span, std::size_t index) const {
    const TomlItem& item = value_span.items[index];
    const std::size_t before = index > 0 ? value_span.items[index - 1].end : value_span.bytes.begin + 1;
    const bool has_late_comma = has_line_break(between(item.value.bytes.end, item.end));
    TomlElement element{{}, {item.begin, has_late_comma ? item.end - 1 : item.value.bytes.end}, {}, {}};
    const std::size_t line = line_begin(item.begin);
    const std::size_t line_end = text_.find('\n', item.end);
    const std::string_view remainder = between(item.end, line_end);
    // A comment that trails several elements on a line is about all of them.
    const bool is_first = index == 0 || has_line_break(between(before, item.begin));
    if (is_first && begins_comment(remainder)) {
        const std::size_t comment = item.end + remainder.find('#');
        element.after = {comment, comment + between(comment, line_end).find_last_not_of(" \t\r") + 1};
    }
    const bool is_last = is_blank(remainder) || !is_empty(element.after);
    const bool begins_line = line > value_span.bytes.begin && is_blank(between(line, item.begin));
    if (begins_line && is_last && line_end < value_span.bytes.end) {
        element.above = comments_above(value_span, index, {line, line_end + 1});
        element.lines = {is_empty(element.above) ? line : element.above.begin, line_end + 1};
    }
    return element;
}

// If the next element follows at once, they may be about that, too.
TomlRange TomlTextEditor::comments_above(const TomlValueSpan& value_span, std::size_t index,
                                         TomlRange lines) const {
    const bool is_last = index + 1 == value_span.items.size();
    if (!is_last && !has_line_break(between(lines.end, value_span.items[index + 1].begin))) return {};
    const std::size_t before = index > 0 ? value_span.items[index - 1].end : value_span.bytes.begin + 1;
    std::size_t begin = lines.begin;
    while (begin > before) {
        const std::size_t line = line_begin(begin - 1);
        if (line < before || !begins_comment(between(line, begin))) break;
        begin = line;
    }
    return {begin, lines.begin};
}

// Adds the item on its own line, if the element above has one.
bool TomlTextEditor::add_below(const TomlValueSpan& value_span, std::size_t index, const std::string& item) {
    const TomlRange lines = element_at(value_span, index).lines;
    if (is_empty(lines)) return false;
    const TomlItem& above = value_span.items[index];
    const std::size_t end = above.value.bytes.end;
    const bool comma = above.end > end;
    const std::string_view indent = between(line_begin(above.begin), above.begin);
    const std::string below = fmt::format("{}{}{}{}", indent, item, comma ? "," : "", line_end());
    const std::string remainder(between(end, lines.end));
    change({end, lines.end}, fmt::format("{}{}{}", comma ? "" : ",", remainder, below));
    return true;
}

bool TomlTextEditor::add_above(const TomlValueSpan& value_span, std::size_t index, const std::string& item) {
    const TomlRange lines = element_at(value_span, index).lines;
    if (is_empty(lines)) return false;
    const std::size_t begin = value_span.items[index].begin;
    change({lines.begin, lines.begin},
           fmt::format("{}{},{}", between(line_begin(begin), begin), item, line_end()));
    return true;
}

void TomlTextEditor::remove_item(const TomlValueSpan& value_span, std::size_t index) {
    if (index >= value_span.items.size()) return;
    const TomlItem& item = value_span.items[index];
    const TomlElement element = element_at(value_span, index);
    if (!is_empty(element.lines)) return change(element.lines, {});
    if (!is_empty(element.after)) return change({item.begin, element.after.end}, {});
    if (index + 1 < value_span.items.size()) {
        const std::size_t next = value_span.items[index + 1].begin;
        return change({item.begin, has_line_break(between(item.end, next)) ? item.end : next}, {});
    }
    if (index > 0) {
        const TomlItem& previous = value_span.items[index - 1];
        const bool separated = has_line_break(between(previous.end, item.begin));
        return change({separated ? item.begin : previous.value.bytes.end, item.end}, {});
    }
    const TomlRange inside{value_span.bytes.begin + 1, value_span.bytes.end - 1};
    const bool standalone =
        is_blank(between(inside.begin, item.begin)) && is_blank(between(item.end, inside.end));
    change(standalone ? inside : TomlRange{item.begin, item.end}, {});
}

// Moves values between positions with their comments; other comments at the positions stay.
void TomlTextEditor::move_item(const TomlValueSpan& value_span, std::size_t from, std::size_t to) {
    std::vector<TomlElement> old_elements;
    for (std::size_t i = 0; i < value_span.items.size(); ++i)
        old_elements.push_back(element_at(value_span, i));
    std::vector<TomlElement> elements = old_elements;
    const TomlElement moved = elements[from];
    elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(from));
    elements.insert(elements.begin() + static_cast<std::ptrdiff_t>(to), moved);
    std::string text(between(value_span.bytes.begin, value_span.bytes.end));
    const auto replace_text = [&](TomlRange bytes, std::string_view written) {
        text.replace(bytes.begin - value_span.bytes.begin, bytes.end - bytes.begin, written);
    };
    const auto of = [&](TomlRange bytes) { return between(bytes.begin, bytes.end); };
    for (std::size_t i = old_elements.size(); i-- > 0;) {
        const TomlElement& layout_element = old_elements[i];
        const TomlElement& element = elements[i];
        const std::size_t end = value_span.items[i].end;
        if (!is_empty(layout_element.after)) {
            replace_text(
                {is_empty(element.after) ? end : layout_element.after.begin, layout_element.after.end},
                of(element.after));
        } else if (!is_empty(element.after)) {
            const std::string_view remainder = between(end, text_.find('\n', end));
            replace_text({end, end},
                         fmt::format(" {}{}", of(element.after), is_blank(remainder) ? "" : line_end()));
        }
        replace_text(layout_element.value, of(element.value));
        if (!is_empty(layout_element.lines)) {
            const std::size_t line = line_begin(layout_element.value.begin);
            replace_text({is_empty(layout_element.above) ? line : layout_element.above.begin, line},
                         of(element.above));
        } else if (!is_empty(element.above)) {
            replace_text({layout_element.value.begin, layout_element.value.begin},
                         fmt::format("{}{}", line_end(), of(element.above)));
        }
    }
    change(value_span.bytes, text);
}

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
