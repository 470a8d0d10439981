#include "cam/drawing/dxf_groups.h"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "base/text/read_number.h"
#include "base/text/trimmed.h"

namespace gsim::drawing {

namespace {

constexpr int kMaxCode = 1071;  // of extended data, the highest there is
constexpr std::size_t kShownOfText = 40;

std::string shown_text(std::string_view text) {
    std::string result(text.substr(0, kShownOfText));
    for (char& c : result) {
        if (static_cast<unsigned char>(c) < ' ') c = '?';
    }
    return result;
}

}  // namespace

std::string_view GroupReader::take_line() {
    const std::size_t end = std::min(text_.find('\n', offset_), text_.size());
    const std::string_view line = text_.substr(offset_, end - offset_);
    offset_ = std::min(end + 1, text_.size());
    ++line_;
    return text::trimmed(line, " \t\r");
}

std::optional<Group> GroupReader::next() {
    if (offset_ >= text_.size()) return {};
    Group group;
    const std::string_view code = take_line();
    const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), group.code);
    const bool whole = error == std::errc{} && end == code.data() + code.size();
    if (!whole || group.code < -5 || group.code > kMaxCode) {
        if (code.empty() && offset_ >= text_.size()) return {};  // an empty last line
        throw DrawingFault{line_, fmt::format("'{}' is no group code of DXF", shown_text(code))};
    }
    if (offset_ >= text_.size()) {
        throw DrawingFault{line_,
                           fmt::format("the file ends behind group code {}: it was cut off", group.code)};
    }
    group.value = take_line();
    group.line = line_;
    return group;
}

double number_of(const Group& group) {
    const std::optional<double> value = text::number_of(group.value);
    if (!value) {
        throw DrawingFault{group.line, fmt::format("'{}' (group code {}) is no finite number",
                                                   shown_text(group.value), group.code)};
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

double GroupList::number(int code, double otherwise) const {
    for (const Group& group : groups_) {
        if (group.code == code) return number_of(group);
    }
    return otherwise;
}

double GroupList::number(int code) const {
    for (const Group& group : groups_) {
        if (group.code == code) return number_of(group);
    }
    throw DrawingFault{line(), fmt::format("{} has no value of group code {}", kind(), code)};
}

int GroupList::whole(int code, int otherwise) const {
    const double value = number(code, otherwise);
    if (std::abs(value) > 1e9 || value != std::trunc(value)) {
        throw DrawingFault{
            line(), fmt::format("{}: group code {} has {}, which is no whole number", kind(), code, value)};
    }
    return static_cast<int>(value);
}

geometry::Point GroupList::point(int code) const {
    return {number(code), number(code + 10)};
}

}  // namespace gsim::drawing
