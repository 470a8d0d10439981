#include "base/toml/toml_sheet.h"

#include <algorithm>
#include <utility>

namespace gsim::base {

namespace {

struct Spellings {
    std::size_t whole = 0;
    std::size_t with_point = 0;
};

void count(const TomlSpot& spot, std::string_view text, Spellings& found) {
    for (const TomlItem& item : spot.items) count(item.value, text, found);
    if (spot.kind != TomlSpot::Kind::plain) return;
    const TomlSpelling spelling =
        spelling_of(text.substr(spot.bytes.begin, spot.bytes.end - spot.bytes.begin));
    found.whole += spelling == TomlSpelling::whole ? 1U : 0U;
    found.with_point += spelling == TomlSpelling::with_point ? 1U : 0U;
}

}  // namespace

TomlSheet::TomlSheet(std::string text) : text_(std::move(text)) {
    change({}, {});
}

void TomlSheet::change(TomlBytes bytes, std::string_view text) {
    text_.replace(bytes.begin, bytes.end - bytes.begin, text);
    layout_ = lay_out(text_).value_or(TomlLayout{});
}

std::string_view TomlSheet::line_end() const {
    const std::size_t end = text_.find('\n');
    return end != std::string::npos && end > 0 && text_[end - 1] == '\r' ? "\r\n" : "\n";
}

std::string_view TomlSheet::between(std::size_t begin, std::size_t end) const {
    return std::string_view(text_).substr(begin, end - begin);
}

std::size_t TomlSheet::line_begin(std::size_t at) const {
    if (at <= layout_.begin) return layout_.begin;
    const std::size_t end = text_.rfind('\n', at - 1);
    return end == std::string::npos ? layout_.begin : end + 1;
}

const TomlSpot* TomlSheet::find(const TomlPath& path) const {
    for (const TomlStatement& statement : layout_.statements) {
        if (!statement.is_pair() || !leads_through(path, statement.address)) continue;
        const auto on = path.begin() + static_cast<std::ptrdiff_t>(statement.address.size());
        return find_within(statement.item.value, TomlPath(on, path.end()));
    }
    return nullptr;
}

bool TomlSheet::makes(const TomlPath& path) const {
    if (path.empty()) return true;
    for (const TomlStatement& statement : layout_.statements) {
        if (leads_through(statement.address, path)) return true;
        if (!statement.is_pair() || !leads_through(path, statement.address)) continue;
        // The path within a value is the value itself, or a table that a dotted key in it makes.
        TomlPath rest(path.begin() + static_cast<std::ptrdiff_t>(statement.address.size()), path.end());
        if (find_within(statement.item.value, rest) != nullptr) return true;
        TomlPath dotted;
        while (!rest.empty()) {
            dotted.insert(dotted.begin(), rest.back());
            rest.pop_back();
            const TomlSpot* const spot = find_within(statement.item.value, rest);
            if (spot == nullptr) continue;
            return std::any_of(spot->items.begin(), spot->items.end(),
                               [&](const TomlItem& item) { return leads_through(item.key, dotted); });
        }
    }
    return false;
}

TomlNumbers TomlSheet::numbers_beside(const std::vector<const TomlSpot*>& spots) const {
    Spellings found;
    for (const TomlSpot* spot : spots) count(*spot, text_, found);
    if (found.whole + found.with_point == 0) {
        for (const TomlStatement& statement : layout_.statements) count(statement.item.value, text_, found);
    }
    return found.with_point == 0 && found.whole > 0 ? TomlNumbers::as_they_are : TomlNumbers::floats;
}

std::string TomlSheet::value_beside(const nlohmann::ordered_json& value, const TomlSpot& spot) const {
    return toml_value(value, numbers_beside({&spot}));
}

void TomlSheet::replace(const TomlPath& path, const nlohmann::ordered_json& value) {
    const TomlSpot* const spot = find(path);
    if (spot == nullptr) return;
    const TomlBytes bytes = spot->bytes;
    const TomlSpelling old = spelling_of(between(bytes.begin, bytes.end));
    std::string written = value_beside(value, *spot);
    if (value.is_string() && old != TomlSpelling::other && names_number(value.get_ref<const std::string&>()))
        written = value.get<std::string>();
    // A comment after it stays in its column.
    const std::size_t gap_end = std::min(text_.find_first_not_of(' ', bytes.end), text_.size());
    const std::size_t gap = gap_end - bytes.end;
    TomlBytes replaced = bytes;
    const bool one_line = between(bytes.begin, bytes.end).find('\n') == std::string_view::npos;
    if (gap > 1 && one_line && between(gap_end, gap_end + 1) == "#") {
        const std::size_t column = bytes.end - bytes.begin + gap;
        replaced.end = gap_end;
        written.resize(std::max(column, written.size() + 1), ' ');
    }
    change(replaced, written);
}

}  // namespace gsim::base
