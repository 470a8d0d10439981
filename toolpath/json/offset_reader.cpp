#include "toolpath/json/offset_reader.h"

#include <algorithm>

#include "toolpath/json/keys.h"

namespace gsim::path {

void OffsetReader::set_name(const std::string& name) {
    name_ = frame_name(name);
}

ReadResult OffsetReader::start(Program& program) {
    keys_.clear();
    const auto [added, is_new] = program.work_offsets.try_emplace(name_);
    offset_ = &added->second;
    if (is_new) return {};
    return Unexpected(fmt::format("two work offsets have the name '{}'", name_));
}

ReadResult OffsetReader::key(const std::string& name) {
    const bool letter = name.size() == 1 && name[0] >= 'A' && name[0] <= 'Z';
    if (!letter && name != kRotationKey) {
        return Unexpected(
            fmt::format("a work offset must contain axes by one capital letter each, or '{}'; not '{}'",
                        kRotationKey, name));
    }
    if (std::find(keys_.begin(), keys_.end(), name) != keys_.end()) return duplicate_key(name);
    keys_.push_back(name);
    key_ = name;
    return {};
}

void OffsetReader::number(double value) {
    if (key_ == kRotationKey) {
        offset_->rotation_deg = value;
    } else {
        offset_->origin[key_[0]] = value;
    }
}

std::string OffsetReader::expected_offset() const {
    return fmt::format("the work offset '{}' must be an object such as {{\"X\": 200}}", name_);
}

}  // namespace gsim::path
