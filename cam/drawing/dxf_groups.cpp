#include "cam/drawing/dxf_groups.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "base/text/read_number.h"
#include "base/text/trimmed.h"

namespace gsim::drawing {

namespace {

constexpr int kMaxGroupCode = 1071;  // of extended data, the highest there is
constexpr std::size_t kMaxShownLength = 40;

std::string printable_text(std::string_view text) {
    std::string result(text.substr(0, kMaxShownLength));
    for (char& c : result) {
        if (static_cast<unsigned char>(c) < ' ') c = '?';
    }
    return result;
}

}  // namespace

std::string_view GroupReader::read_line() {
    const std::size_t end = std::min(text_.find('\n', offset_), text_.size());
    const std::string_view line = text_.substr(offset_, end - offset_);
    offset_ = std::min(end + 1, text_.size());
    ++line_;
    return text::trimmed(line, " \t\r");
}

std::optional<Group> GroupReader::next() {
    if (offset_ >= text_.size()) return {};
    Group group;
    const std::string_view code = read_line();
    const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), group.code);
    const bool is_complete = error == std::errc{} && end == code.data() + code.size();
    if (!is_complete || group.code < -5 || group.code > kMaxGroupCode) {
        if (code.empty() && offset_ >= text_.size()) return {};  // an empty last line
        throw error_at(line_, fmt::format("'{}' is not a group code of DXF", printable_text(code)));
    }
    if (offset_ >= text_.size()) {
        throw error_at(line_, fmt::format("the file ends after group code {}: it is truncated", group.code));
    }
    group.value = read_line();
    group.line = line_;
    return group;
}

Error error_at(std::size_t line, std::string message) {
    return {std::move(message), static_cast<std::uint32_t>(line), 0};
}

double parse_number(const Group& group) {
    const std::optional<double> value = text::parse_number(group.value);
    if (!value) {
        throw error_at(group.line, fmt::format("'{}' (group code {}) is not a finite number",
                                               printable_text(group.value), group.code));
    }
    return *value;
}

void GroupList::read(Group first, GroupReader& reader) {
    kind_ = first;
    groups_.clear();
    for (std::optional<Group> group = reader.peek(); group && group->code != 0; group = reader.peek()) {
        groups_.push_back(*group);
        reader.next();
    }
}

std::optional<std::string_view> GroupList::text(int code) const {
    for (const Group& group : groups_) {
        if (group.code == code) return group.value;
    }
    return {};
}

double GroupList::number(int code, double fallback) const {
    for (const Group& group : groups_) {
        if (group.code == code) return parse_number(group);
    }
    return fallback;
}

double GroupList::number(int code) const {
    for (const Group& group : groups_) {
        if (group.code == code) return parse_number(group);
    }
    throw error_at(line(), fmt::format("{} has no value of group code {}", kind(), code));
}

int GroupList::integer_or(int code, int fallback) const {
    const double value = number(code, fallback);
    if (std::abs(value) > 1e9 || value != std::trunc(value)) {
        throw error_at(line(),
                       fmt::format("{}: group code {} has {}, which is not an integer", kind(), code, value));
    }
    return static_cast<int>(value);
}

geometry::Point GroupList::point(int code) const {
    return {number(code), number(code + 10)};
}

}  // namespace gsim::drawing
