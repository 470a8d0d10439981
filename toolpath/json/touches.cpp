#include "toolpath/json/touches.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace gsim::path {

namespace {

constexpr double kMaxPosition_mm = 1e6;  // beyond any machine
constexpr double kMaxFeed_mm_min = 1e9;

double start_on_axis_mm(const Touch& touch) {
    return touch.from_mm[static_cast<std::size_t>(touch.axis - 'X')];
}

}  // namespace

TouchDraft::ValueKind TouchDraft::value_kind(TouchKey key) {
    switch (key) {
        case TouchKey::axis: return ValueKind::text;
        case TouchKey::from_mm: return ValueKind::vector;
        default: return ValueKind::number;
    }
}

bool TouchDraft::mark_present(TouchKey key) {
    const bool before = present_keys_[static_cast<std::size_t>(key)];
    present_keys_[static_cast<std::size_t>(key)] = true;
    return before;
}

Result<void> TouchDraft::set_text(TouchKey /*key*/, std::string_view value) {
    if (value.size() != 1 || value[0] < 'X' || value[0] > 'Z')
        return Unexpected("'axis' of a touch must be \"X\", \"Y\" or \"Z\"");
    touch_.axis = value[0];
    return {};
}

Result<void> TouchDraft::set_number(TouchKey key, double value) {
    switch (key) {
        case TouchKey::to_mm: touch_.to_mm = value; break;
        case TouchKey::surface_mm: touch_.surface_mm = value; break;
        case TouchKey::feed_mm_min: touch_.feed_mm_min = value; break;
        case TouchKey::probe_radius_mm: touch_.probe_radius_mm = value; break;
        default:
            if (!(value >= 0 && value <= kMaxToolNumber) || value != std::floor(value)) {
                return Unexpected(
                    fmt::format("'tool' must be an integer from 0 to {}; it is {}", kMaxToolNumber, value));
            }
            touch_.tool = static_cast<int>(value);
    }
    return {};
}

Result<void> TouchDraft::set_vector(TouchKey key, const std::vector<double>& values) {
    if (values.size() != 3) {
        return Unexpected(
            fmt::format("'{}' must contain three numbers; it contains {}", key_name(key), values.size()));
    }
    touch_.from_mm = {values[0], values[1], values[2]};
    return {};
}

Result<Touch> TouchDraft::finish() const {
    for (std::size_t i = 0; i < kRequiredTouchKeys; ++i) {
        if (!present_keys_[i]) return Unexpected(fmt::format("a touch lacks the key '{}'", kTouchKeys[i]));
    }
    return touch_;
}

bool is_upward(const Touch& touch) {
    return touch.to_mm > start_on_axis_mm(touch);
}

double contact_mm(const Touch& touch) {
    return touch.surface_mm + (is_upward(touch) ? -touch.probe_radius_mm : touch.probe_radius_mm);
}

std::optional<Error> find_touch_error(const Touch& touch) {
    if (touch.axis < 'X' || touch.axis > 'Z') return "a touch must be along X, Y or Z";
    for (const double value :
         {touch.from_mm[0], touch.from_mm[1], touch.from_mm[2], touch.to_mm, touch.surface_mm}) {
        if (!(std::abs(value) <= kMaxPosition_mm))
            return fmt::format("the positions of a touch must be between -1e6 and 1e6; one is {}", value);
    }
    if (!(touch.feed_mm_min > 0 && touch.feed_mm_min <= kMaxFeed_mm_min))
        return fmt::format("'feed_mm_min' must be greater than 0 and at most 1e9; it is {}",
                           touch.feed_mm_min);
    if (!(touch.probe_radius_mm >= 0 && touch.probe_radius_mm <= kMaxPosition_mm))
        return fmt::format("'probe_radius_mm' must be 0 or greater and at most 1e6; it is {}",
                           touch.probe_radius_mm);
    if (touch.axis == 'Z' && touch.probe_radius_mm != 0)
        return "'probe_radius_mm' is only for touches along X and Y; along Z the tool length defines the "
               "contact";
    const double from = start_on_axis_mm(touch);
    const double contact = contact_mm(touch);
    const auto [min, max] = std::minmax(from, touch.to_mm);
    if (!(contact > min && contact < max)) {
        return fmt::format(
            "along {} the touch moves from {} to {} and expects the surface at {}, which must be in between",
            touch.axis, from, touch.to_mm, contact);
    }
    return std::nullopt;
}

}  // namespace gsim::path
