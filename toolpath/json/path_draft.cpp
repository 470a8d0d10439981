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

tl::expected<void, std::string> PathDraft::set_text(PathKey key, std::string_view value) {
    if (value.empty()) return tl::unexpected(fmt::format("'{}' must not be empty", key_name(key)));
    frame_.name = frame_name(value);
    return {};
}

tl::expected<void, std::string> PathDraft::set_number(PathKey key, double value) {
    if (!(value >= 0 && value <= kMaxToolNumber) || value != std::floor(value)) {
        return tl::unexpected(fmt::format("'{}' must be a whole number from 0 to {}; it is {}", key_name(key),
                                          kMaxToolNumber, value));
    }
    auto& number = key == PathKey::tool            ? tool_
                   : key == PathKey::length_offset ? length_offset_
                                                   : diameter_offset_;
    number = static_cast<int>(value);
    return {};
}

tl::expected<void, std::string> PathDraft::set_vector(PathKey key, const std::vector<double>& values) {
    if (values.size() != 3) {
        return tl::unexpected(
            fmt::format("'{}' must hold three numbers; it holds {}", key_name(key), values.size()));
    }
    frame_.set_offset_mm = {values[0], values[1], values[2]};
    return {};
}

tl::expected<void, std::string> PathDraft::end_touches() const {
    if (frame_.touches.empty())
        return tl::unexpected(
            fmt::format("'{}' must hold one touch at least", key_name(PathKey::probe_offset)));
    return {};
}

tl::expected<WorkFrame, std::string> PathDraft::finish_frame() const {
    if (frame_.set_offset_mm && frame_.name.empty())
        return tl::unexpected<std::string>("'set_offset_mm' goes with 'work_offset', which says what is set");
    if (!frame_.touches.empty() && frame_.name.empty())
        return tl::unexpected<std::string>(
            "'probe_offset' goes with 'work_offset', which says what is found");
    return frame_;
}

tl::expected<void, std::string> PathDraft::finish(Path& path) const {
    auto frame = finish_frame();
    if (!frame) return tl::unexpected(frame.error());
    path.frame = *std::move(frame);
    if (tool_) {
        path.tool = Tool{*tool_, length_offset_.value_or(*tool_), diameter_offset_};
    } else if (length_offset_ || diameter_offset_) {
        return tl::unexpected(
            fmt::format("'{}' goes with 'tool'",
                        key_name(length_offset_ ? PathKey::length_offset : PathKey::diameter_offset)));
    }
    return {};
}

}  // namespace gsim::path
