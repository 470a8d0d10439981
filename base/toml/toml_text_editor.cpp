#include "base/toml/toml_text_editor.h"

#include <algorithm>
#include <utility>

namespace gsim::base {

namespace {

struct FormatCounts {
    std::size_t integer_spelling = 0;
    std::size_t decimal = 0;
};

void count(const TomlValueSpan& value_span, std::string_view text, FormatCounts& found) {
    for (const TomlItem& item : value_span.items) count(item.value, text, found);
    if (value_span.kind != TomlValueSpan::Kind::plain) return;
    const TomlNumberFormat format =
        number_format(text.substr(value_span.bytes.begin, value_span.bytes.end - value_span.bytes.begin));
    found.integer_spelling += format == TomlNumberFormat::integer_spelling ? 1U : 0U;
    found.decimal += format == TomlNumberFormat::decimal ? 1U : 0U;
}

}  // namespace

TomlTextEditor::TomlTextEditor(std::string text) : text_(std::move(text)) {
    change({}, {});
}

void TomlTextEditor::change(TomlRange bytes, std::string_view text) {
    text_.replace(bytes.begin, bytes.end - bytes.begin, text);
    layout_ = parse_layout(text_).value_or(TomlLayout{});
}

std::string_view TomlTextEditor::line_end() const {
    const std::size_t end = text_.find('\n');
    return end != std::string::npos && end > 0 && text_[end - 1] == '\r' ? "\r\n" : "\n";
}

std::string_view TomlTextEditor::between(std::size_t begin, std::size_t end) const {
    return std::string_view(text_).substr(begin, end - begin);
}

std::size_t TomlTextEditor::line_begin(std::size_t at) const {
    if (at <= layout_.begin) return layout_.begin;
    const std::size_t end = text_.rfind('\n', at - 1);
    return end == std::string::npos ? layout_.begin : end + 1;
}

const TomlValueSpan* TomlTextEditor::find(const TomlPath& path) const {
    for (const TomlStatement& statement : layout_.statements) {
        if (!statement.is_pair() || !has_prefix(path, statement.address)) continue;
        const auto on = path.begin() + static_cast<std::ptrdiff_t>(statement.address.size());
        return find_nested_value(statement.item.value, TomlPath(on, path.end()));
    }
    return nullptr;
}

bool TomlTextEditor::defines(const TomlPath& path) const {
    if (path.empty()) return true;
    for (const TomlStatement& statement : layout_.statements) {
        if (has_prefix(statement.address, path)) return true;
        if (!statement.is_pair() || !has_prefix(path, statement.address)) continue;
        // The path within a value is the value itself, or a table that a dotted key in it makes.
        TomlPath remainder(path.begin() + static_cast<std::ptrdiff_t>(statement.address.size()), path.end());
        if (find_nested_value(statement.item.value, remainder) != nullptr) return true;
        TomlPath dotted;
        while (!remainder.empty()) {
            dotted.insert(dotted.begin(), remainder.back());
            remainder.pop_back();
            const TomlValueSpan* const value_span = find_nested_value(statement.item.value, remainder);
            if (value_span == nullptr) continue;
            return std::any_of(value_span->items.begin(), value_span->items.end(),
                               [&](const TomlItem& item) { return has_prefix(item.key, dotted); });
        }
    }
    return false;
}

TomlNumbers TomlTextEditor::neighbor_number_style(
    const std::vector<const TomlValueSpan*>& value_spans) const {
    FormatCounts found;
    for (const TomlValueSpan* value_span : value_spans) count(*value_span, text_, found);
    if (found.integer_spelling + found.decimal == 0) {
        for (const TomlStatement& statement : layout_.statements) count(statement.item.value, text_, found);
    }
    return found.decimal == 0 && found.integer_spelling > 0 ? TomlNumbers::as_given : TomlNumbers::floats;
}

std::string TomlTextEditor::value_like_neighbors(const nlohmann::ordered_json& value,
                                                 const TomlValueSpan& value_span) const {
    return toml_value(value, neighbor_number_style({&value_span}));
}

void TomlTextEditor::replace(const TomlPath& path, const nlohmann::ordered_json& value) {
    const TomlValueSpan* const value_span = find(path);
    if (value_span == nullptr) return;
    const TomlRange bytes = value_span->bytes;
    const TomlNumberFormat old = number_format(between(bytes.begin, bytes.end));
    std::string written = value_like_neighbors(value, *value_span);
    if (value.is_string() && old != TomlNumberFormat::other &&
        is_nonfinite_name(value.get_ref<const std::string&>()))
        written = value.get<std::string>();
    // A trailing comment stays in its column.
    const std::size_t gap_end = std::min(text_.find_first_not_of(' ', bytes.end), text_.size());
    const std::size_t gap = gap_end - bytes.end;
    TomlRange replaced = bytes;
    const bool one_line = between(bytes.begin, bytes.end).find('\n') == std::string_view::npos;
    if (gap > 1 && one_line && between(gap_end, gap_end + 1) == "#") {
        const std::size_t column = bytes.end - bytes.begin + gap;
        replaced.end = gap_end;
        written.resize(std::max(column, written.size() + 1), ' ');
    }
    change(replaced, written);
}

}  // namespace gsim::base
