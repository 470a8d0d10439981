#include "toolpath/json/touch_reader.h"

#include <algorithm>

#include "toolpath/json/target_draft.h"

namespace gsim::path {

void TouchReader::start(const SourceLocation& location) {
    draft_ = {};
    location_ = location;
}

ReadResult TouchReader::key(const std::string& name) {
    const auto* const found = std::find(kTouchKeys.begin(), kTouchKeys.end(), name);
    if (found == kTouchKeys.end()) return Unexpected(unknown_key(name, "a touch", kTouchKeys));
    key_ = static_cast<TouchKey>(found - kTouchKeys.begin());
    if (draft_.mark_present(key_)) return duplicate_key(name);
    return {};
}

ReadResult TouchReader::number(double value) {
    if (TouchDraft::value_kind(key_) != TouchDraft::ValueKind::number)
        return type_error(expected_type(), "a number");
    return draft_.set_number(key_, value);
}

ReadResult TouchReader::string(std::string_view value) {
    if (TouchDraft::value_kind(key_) != TouchDraft::ValueKind::text)
        return type_error(expected_type(), "a string");
    return draft_.set_text(key_, value);
}

std::string TouchReader::expected_type() const {
    return fmt::format("'{}' must be {}", current_key(),
                       key_ == TouchKey::axis      ? "a string"
                       : key_ == TouchKey::from_mm ? "an array of three numbers"
                                                   : "a number");
}

}  // namespace gsim::path
