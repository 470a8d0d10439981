#include "toolpath/json/target_reader.h"

#include <algorithm>

namespace gsim::path {

void TargetReader::start(const SourceLocation& location) {
    draft_ = {};
    location_ = location;
}

ReadResult TargetReader::key(const std::string& name) {
    const auto* const found = std::find(kTargetKeys.begin(), kTargetKeys.end(), name);
    if (found == kTargetKeys.end()) return Unexpected(unknown_key(name, "a target", kTargetKeys));
    key_ = static_cast<TargetKey>(found - kTargetKeys.begin());
    if (draft_.mark_present(key_)) return duplicate_key(name);
    return {};
}

ReadResult TargetReader::number(double value) {
    if (expects(TargetDraft::ValueKind::number) || expects(TargetDraft::ValueKind::text_or_number))
        return draft_.set_number(key_, value);
    return type_error(expected_type(), "a number");
}

ReadResult TargetReader::string(const std::string& value) {
    if (expects(TargetDraft::ValueKind::text) || expects(TargetDraft::ValueKind::text_or_number))
        return draft_.set_text(key_, value);
    return type_error(expected_type(), "a string");
}

std::string TargetReader::expected_type() const {
    switch (TargetDraft::value_kind(key_)) {
        case TargetDraft::ValueKind::text: return fmt::format("'{}' must be a string", current_key());
        case TargetDraft::ValueKind::number: return fmt::format("'{}' must be a number", current_key());
        case TargetDraft::ValueKind::text_or_number:
            return fmt::format("'{}' must be a name or a number", current_key());
        case TargetDraft::ValueKind::vector:
            return fmt::format("'{}' must be an array of three numbers", current_key());
        case TargetDraft::ValueKind::touches:
            return fmt::format("'{}' must be an array of touches", current_key());
        case TargetDraft::ValueKind::letters: return "'rotary_deg' must be an object such as {\"B\": 90}";
        case TargetDraft::ValueKind::list: return "'actions' must be an array of strings";
    }
    return {};
}

}  // namespace gsim::path
