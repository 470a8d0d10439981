// Elements in brackets and braces, with the comments about each of them.

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/toml/toml_sheet.h"

namespace gsim::base {

namespace {

bool has_break(std::string_view text) {
    return text.find_first_of("\n#") != std::string_view::npos;
}

bool is_empty(const TomlBytes& bytes) {
    return bytes.begin == bytes.end;
}

bool begins_comment(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    return first != std::string_view::npos && text[first] == '#';
}

}  // namespace

TomlElement TomlSheet::element_of(const TomlSpot& spot, std::size_t index) const {
    const TomlItem& item = spot.items[index];
    const std::size_t before = index > 0 ? spot.items[index - 1].end : spot.bytes.begin + 1;
    const bool late_comma = has_break(between(item.value.bytes.end, item.end));
    TomlElement element{{}, {item.begin, late_comma ? item.end - 1 : item.value.bytes.end}, {}, {}};
    const std::size_t line = line_begin(item.begin);
    const std::size_t line_end = text_.find('\n', item.end);
    const std::string_view rest = between(item.end, line_end);
    // A comment after several elements on a line is about all of them.
    const bool is_first = index == 0 || has_break(between(before, item.begin));
    if (is_first && begins_comment(rest)) {
        const std::size_t comment = item.end + rest.find('#');
        element.behind = {comment, comment + between(comment, line_end).find_last_not_of(" \t\r") + 1};
    }
    const bool is_last = is_blank(rest) || !is_empty(element.behind);
    const bool begins_line = line > spot.bytes.begin && is_blank(between(line, item.begin));
    if (begins_line && is_last && line_end < spot.bytes.end) {
        element.above = comments_above(spot, index, {line, line_end + 1});
        element.lines = {is_empty(element.above) ? line : element.above.begin, line_end + 1};
    }
    return element;
}

// If the next element follows at once, they may be about that, too.
TomlBytes TomlSheet::comments_above(const TomlSpot& spot, std::size_t index, TomlBytes lines) const {
    const bool is_last = index + 1 == spot.items.size();
    if (!is_last && !has_break(between(lines.end, spot.items[index + 1].begin))) return {};
    const std::size_t before = index > 0 ? spot.items[index - 1].end : spot.bytes.begin + 1;
    std::size_t begin = lines.begin;
    while (begin > before) {
        const std::size_t line = line_begin(begin - 1);
        if (line < before || !begins_comment(between(line, begin))) break;
        begin = line;
    }
    return {begin, lines.begin};
}

// Adds the item on its own line, if the element above has one.
bool TomlSheet::add_below(const TomlSpot& spot, std::size_t index, const std::string& item) {
    const TomlBytes lines = element_of(spot, index).lines;
    if (is_empty(lines)) return false;
    const TomlItem& above = spot.items[index];
    const std::size_t end = above.value.bytes.end;
    const bool comma = above.end > end;
    const std::string_view indent = between(line_begin(above.begin), above.begin);
    const std::string below = fmt::format("{}{}{}{}", indent, item, comma ? "," : "", line_end());
    const std::string rest(between(end, lines.end));
    change({end, lines.end}, fmt::format("{}{}{}", comma ? "" : ",", rest, below));
    return true;
}

bool TomlSheet::add_above(const TomlSpot& spot, std::size_t index, const std::string& item) {
    const TomlBytes lines = element_of(spot, index).lines;
    if (is_empty(lines)) return false;
    const std::size_t begin = spot.items[index].begin;
    change({lines.begin, lines.begin},
           fmt::format("{}{},{}", between(line_begin(begin), begin), item, line_end()));
    return true;
}

void TomlSheet::remove_item(const TomlSpot& spot, std::size_t index) {
    if (index >= spot.items.size()) return;
    const TomlItem& item = spot.items[index];
    const TomlElement element = element_of(spot, index);
    if (!is_empty(element.lines)) return change(element.lines, {});
    if (!is_empty(element.behind)) return change({item.begin, element.behind.end}, {});
    if (index + 1 < spot.items.size()) {
        const std::size_t next = spot.items[index + 1].begin;
        return change({item.begin, has_break(between(item.end, next)) ? item.end : next}, {});
    }
    if (index > 0) {
        const TomlItem& previous = spot.items[index - 1];
        const bool apart = has_break(between(previous.end, item.begin));
        return change({apart ? item.begin : previous.value.bytes.end, item.end}, {});
    }
    const TomlBytes inside{spot.bytes.begin + 1, spot.bytes.end - 1};
    const bool alone = is_blank(between(inside.begin, item.begin)) && is_blank(between(item.end, inside.end));
    change(alone ? inside : TomlBytes{item.begin, item.end}, {});
}

// Moves values between positions with their comments; other comments at the positions stay.
void TomlSheet::move_item(const TomlSpot& spot, std::size_t from, std::size_t to) {
    std::vector<TomlElement> places;
    for (std::size_t i = 0; i < spot.items.size(); ++i) places.push_back(element_of(spot, i));
    std::vector<TomlElement> elements = places;
    const TomlElement moved = elements[from];
    elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(from));
    elements.insert(elements.begin() + static_cast<std::ptrdiff_t>(to), moved);
    std::string text(between(spot.bytes.begin, spot.bytes.end));
    const auto put = [&](TomlBytes bytes, std::string_view written) {
        text.replace(bytes.begin - spot.bytes.begin, bytes.end - bytes.begin, written);
    };
    const auto of = [&](TomlBytes bytes) { return between(bytes.begin, bytes.end); };
    for (std::size_t i = places.size(); i-- > 0;) {
        const TomlElement& place = places[i];
        const TomlElement& element = elements[i];
        const std::size_t end = spot.items[i].end;
        if (!is_empty(place.behind)) {
            put({is_empty(element.behind) ? end : place.behind.begin, place.behind.end}, of(element.behind));
        } else if (!is_empty(element.behind)) {
            const std::string_view rest = between(end, text_.find('\n', end));
            put({end, end}, fmt::format(" {}{}", of(element.behind), is_blank(rest) ? "" : line_end()));
        }
        put(place.value, of(element.value));
        if (!is_empty(place.lines)) {
            const std::size_t line = line_begin(place.value.begin);
            put({is_empty(place.above) ? line : place.above.begin, line}, of(element.above));
        } else if (!is_empty(element.above)) {
            put({place.value.begin, place.value.begin}, fmt::format("{}{}", line_end(), of(element.above)));
        }
    }
    change(spot.bytes, text);
}

}  // namespace gsim::base
