#include "toolpath/json/path_reader.h"

#include <algorithm>
#include <cstddef>

#include "toolpath/json/target_draft.h"

namespace gsim::path {

void PathReader::start() {
    *this = {};
}

ReadResult PathReader::key(const std::string& name) {
    const auto* const found = std::find(kPathKeys.begin(), kPathKeys.end(), name);
    if (found == kPathKeys.end()) return Unexpected(unknown_key(name, "a path", kPathKeys));
    const auto index = static_cast<std::size_t>(found - kPathKeys.begin());
    if (present_keys_[index]) return duplicate_key(name);
    present_keys_.set(index);
    key_ = static_cast<PathKey>(index);
    return {};
}

ReadResult PathReader::number(double value) {
    if (expects(PathDraft::ValueKind::number)) return draft_.set_number(key_, value);
    return type_error(expected_type(), "a number");
}

ReadResult PathReader::string(const std::string& value) {
    if (expects(PathDraft::ValueKind::text)) return draft_.set_text(key_, value);
    if (key_ != PathKey::name) return type_error(expected_type(), "a string");
    name_ = value;
    return {};
}

ReadResult PathReader::finish(Path& path) const {
    for (std::size_t i = 0; i < kRequiredPathKeys; ++i) {
        if (!present_keys_[i]) return Unexpected(fmt::format("a path lacks the key '{}'", kPathKeys[i]));
    }
    path.name = name_;
    return draft_.finish(path);
}

std::string PathReader::expected_type() const {
    return fmt::format("'{}' must be {}", current_key(),
                       expects_targets()                       ? "an array of targets"
                       : expects(PathDraft::ValueKind::number) ? "a number"
                       : expects_vector()                      ? "an array of three numbers"
                       : expects_touches()                     ? "an array of touches"
                                                               : "a string");
}

}  // namespace gsim::path
