#include "toolpath/json/path_draft.h"

#include <cmath>

#include <fmt/format.h>

namespace gsim::path {

PathDraft::ValueKind PathDraft::value_kind(PathKey key) {
    switch (key) {
        case PathKey::name:
        case PathKey::targets: return ValueKind::other;
        case PathKey::work_offset: return ValueKind::text;
        case PathKey::set_offset_mm: return ValueKind::vector;
        case PathKey::probe_offset: return ValueKind::touches;
        default: return ValueKind::number;
    }
}

Result<void> PathDraft::set_text(PathKey key, std::string_view value) {
    if (value.empty()) return Unexpected(fmt::format("'{}' must not be empty", key_name(key)));
    frame_.name = frame_name(value);
    return {};
}

Result<void> PathDraft::set_number(PathKey key, double value) {
    if (!(value >= 0 && value <= kMaxToolNumber) || value != std::floor(value)) {
        return Unexpected(fmt::format("'{}' must be an integer from 0 to {}; it is {}", key_name(key),
                                      kMaxToolNumber, value));
    }
    auto& number = key == PathKey::tool            ? tool_
                   : key == PathKey::length_offset ? length_offset_
                                                   : diameter_offset_;
    number = static_cast<int>(value);
    return {};
}

Result<void> PathDraft::set_vector(PathKey key, const std::vector<double>& values) {
    if (values.size() != 3) {
        return Unexpected(
            fmt::format("'{}' must contain three numbers; it contains {}", key_name(key), values.size()));
    }
    frame_.set_offset_mm = {values[0], values[1], values[2]};
    return {};
}

Result<void> PathDraft::end_touches() const {
    if (frame_.touches.empty())
        return Unexpected(
            fmt::format("'{}' must contain at least one touch", key_name(PathKey::probe_offset)));
    return {};
}

Result<WorkFrame> PathDraft::finish_frame() const {
    if (frame_.set_offset_mm && frame_.name.empty())
        return Unexpected("'set_offset_mm' requires 'work_offset', which names the offset to set");
    if (!frame_.touches.empty() && frame_.name.empty())
        return Unexpected("'probe_offset' requires 'work_offset', which names the offset to measure");
    return frame_;
}

Result<void> PathDraft::finish(Path& path) const {
    auto frame = finish_frame();
    if (!frame) return tl::unexpected(frame.error());
    path.frame = *std::move(frame);
    if (tool_) {
        path.tool = Tool{*tool_, length_offset_.value_or(*tool_), diameter_offset_};
    } else if (length_offset_ || diameter_offset_) {
        return Unexpected(
            fmt::format("'{}' requires 'tool'",
                        key_name(length_offset_ ? PathKey::length_offset : PathKey::diameter_offset)));
    }
    return {};
}

}  // namespace gsim::path
