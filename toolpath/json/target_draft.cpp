#include "toolpath/json/target_draft.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/nearest_name.h"

namespace gsim::path {

namespace {

constexpr double kMaxRepeats = 1e9;
constexpr std::array kMachinePointKeys = {TargetKey::name, TargetKey::dwell_s, TargetKey::actions,
                                          TargetKey::fixed, TargetKey::reference};

Vector to_vector(const std::vector<double>& values) {
    return {values[0], values[1], values[2]};
}

}  // namespace

TargetDraft::ValueKind TargetDraft::value_kind(TargetKey key) {
    switch (key) {
        case TargetKey::name:
        case TargetKey::motion:
        case TargetKey::work_offset:
        case TargetKey::path: return ValueKind::text;
        case TargetKey::position_mm:
        case TargetKey::via_mm:
        case TargetKey::center_mm:
        case TargetKey::normal:
        case TargetKey::tool_axis:
        case TargetKey::rpy_deg:
        case TargetKey::set_offset_mm: return ValueKind::vector;
        case TargetKey::rotary_deg: return ValueKind::letters;
        case TargetKey::actions: return ValueKind::list;
        case TargetKey::fixed:
        case TargetKey::reference: return ValueKind::text_or_number;
        case TargetKey::probe_offset: return ValueKind::touches;
        default: return ValueKind::number;
    }
}

bool TargetDraft::mark_present(TargetKey key) {
    const bool before = has(key);
    present_keys_.set(static_cast<std::size_t>(key));
    return before;
}

Result<void> TargetDraft::set_text(TargetKey key, std::string_view value) {
    if (key == TargetKey::name) {
        point_.name = value;
    } else if (key == TargetKey::path) {
        path_name_ = value;
    } else if (key == TargetKey::fixed || key == TargetKey::reference) {
        machine_point_.alias = value;
    } else if (key == TargetKey::work_offset) {
        point_.work_offset = frame_name(value);
        return frame_.set_text(PathKey::work_offset, value);
    } else {
        const auto* const found = std::find(kMotionNames.begin(), kMotionNames.end(), value);
        if (found == kMotionNames.end()) {
            return Unexpected(fmt::format("'motion' must be \"{}\"", text::joined(kMotionNames, "\" or \"")));
        }
        point_.motion = static_cast<MotionType>(found - kMotionNames.begin());
    }
    return {};
}

Result<void> TargetDraft::set_number(TargetKey key, double value) {
    switch (key) {
        case TargetKey::turn_deg: center_.turn_deg = value; break;
        case TargetKey::feed_mm_min: point_.feed_mm_min = value; break;
        case TargetKey::feed_deg_min: point_.feed_deg_min = value; break;
        case TargetKey::duration_s: point_.duration_s = value; break;
        case TargetKey::feed_mm_rev: point_.feed_mm_rev = value; break;
        case TargetKey::lead_mm: point_.lead_mm = value; break;
        case TargetKey::acceleration_mm_s2: point_.acceleration_mm_s2 = value; break;
        case TargetKey::dwell_s: point_.dwell_s = value; break;
        case TargetKey::fixed: return set_point_number(key, value, kMaxFixedPoint);
        case TargetKey::reference: return set_point_number(key, value, kReferencePointCount);
        default:
            if (!(value >= 1 && value <= kMaxRepeats) || value != std::floor(value)) {
                return Unexpected(
                    fmt::format("'repeats' must be an integer from 1 to 1000000000; it is {}", value));
            }
            repeats_ = static_cast<int>(value);
    }
    return {};
}

Result<void> TargetDraft::set_point_number(TargetKey key, double value, int max) {
    if (!(value >= 1 && value <= max) || value != std::floor(value)) {
        return Unexpected(
            fmt::format("'{}' must be an integer from 1 to {}; it is {}", key_name(key), max, value));
    }
    machine_point_.number = static_cast<int>(value);
    return {};
}

Result<void> TargetDraft::set_vector(TargetKey key, const std::vector<double>& values) {
    if (values.size() != 3) {
        return Unexpected(
            fmt::format("'{}' must contain three numbers; it contains {}", key_name(key), values.size()));
    }
    if (key == TargetKey::set_offset_mm) return frame_.set_vector(PathKey::set_offset_mm, values);
    const Vector vector = to_vector(values);
    switch (key) {
        case TargetKey::position_mm: point_.position_mm = vector; break;
        case TargetKey::via_mm: via_.via_mm = vector; break;
        case TargetKey::center_mm: center_.center_mm = vector; break;
        case TargetKey::normal: center_.normal = vector; break;
        case TargetKey::tool_axis: point_.orientation = ToolAxis{vector}; break;
        default: point_.orientation = RollPitchYaw{vector[0], vector[1], vector[2]};
    }
    return {};
}

Result<void> TargetDraft::set_rotary(std::string_view letter, double value_deg) {
    if (letter.size() != 1 || letter[0] < 'A' || letter[0] > 'Z') {
        return Unexpected(fmt::format(
            "'rotary_deg' must contain axes by one capital letter each, such as B, not '{}'", letter));
    }
    auto& axes = std::get<RotaryAxes>(*point_.orientation);
    if (!axes.emplace(letter[0], value_deg).second)
        return Unexpected(fmt::format("'{}' is given twice", letter));
    return {};
}

std::optional<Error> TargetDraft::find_sub_path_error() const {
    if (!has(TargetKey::path)) {
        return fmt::format("'{}' is only for sub-paths; this target lacks the key 'path'",
                           key_name(has(TargetKey::repeats)         ? TargetKey::repeats
                                    : has(TargetKey::set_offset_mm) ? TargetKey::set_offset_mm
                                                                    : TargetKey::probe_offset));
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(TargetKey::path); ++i) {
        if (present_keys_[i] && static_cast<TargetKey>(i) != TargetKey::work_offset) {
            return fmt::format("a target with the key 'path' is a sub-path and cannot have '{}'",
                               kTargetKeys[i]);
        }
    }
    return std::nullopt;
}

std::optional<Error> TargetDraft::find_arc_error() const {
    const bool via = has(TargetKey::via_mm);
    const bool center = has(TargetKey::center_mm);
    if (point_.motion != MotionType::circular) {
        for (const TargetKey key :
             {TargetKey::via_mm, TargetKey::center_mm, TargetKey::normal, TargetKey::turn_deg}) {
            if (has(key)) return fmt::format("'{}' is only for circular motions", key_name(key));
        }
        return std::nullopt;
    }
    if (via == center) return "a circular motion needs either 'via_mm' or 'center_mm' with 'turn_deg'";
    if (center && !has(TargetKey::turn_deg)) return "an arc about 'center_mm' lacks the key 'turn_deg'";
    if (via && (has(TargetKey::normal) || has(TargetKey::turn_deg))) {
        return "an arc through 'via_mm' must not have 'normal' or 'turn_deg'; these require 'center_mm'";
    }
    return std::nullopt;
}

std::optional<Error> TargetDraft::find_point_error() const {
    if (!has(TargetKey::position_mm)) return "a point lacks the key 'position_mm'";
    const int orientations = static_cast<int>(has(TargetKey::tool_axis)) +
                             static_cast<int>(has(TargetKey::rpy_deg)) +
                             static_cast<int>(has(TargetKey::rotary_deg));
    if (orientations > 1) return "a point may have only one of 'tool_axis', 'rpy_deg' and 'rotary_deg'";
    return find_arc_error();
}

std::optional<Error> TargetDraft::find_machine_point_error() const {
    if (has(TargetKey::fixed) && has(TargetKey::reference))
        return "'fixed' and 'reference' are two points; a target may have only one of them";
    for (std::size_t i = 0; i < kTargetKeys.size(); ++i) {
        const auto key = static_cast<TargetKey>(i);
        const bool is_point_key =
            std::find(kMachinePointKeys.begin(), kMachinePointKeys.end(), key) != kMachinePointKeys.end();
        if (!present_keys_[i] || is_point_key) continue;
        return fmt::format(
            "a target with the key '{}' is a point of the machine, which is reached by a rapid; it cannot "
            "have '{}'",
            key_name(has(TargetKey::fixed) ? TargetKey::fixed : TargetKey::reference), kTargetKeys[i]);
    }
    return std::nullopt;
}

Result<Target> TargetDraft::finish() {
    if (is_sub_path()) {
        if (auto error = find_sub_path_error()) return tl::unexpected(*std::move(error));
        auto frame = frame_.finish_frame();
        if (!frame) return tl::unexpected(frame.error());
        return SubPath{0, repeats_, *std::move(frame)};
    }
    if (is_machine_point()) {
        if (auto error = find_machine_point_error()) return tl::unexpected(*std::move(error));
        machine_point_.kind =
            has(TargetKey::fixed) ? MachinePoint::Kind::fixed : MachinePoint::Kind::reference;
        machine_point_.name = std::move(point_.name);
        machine_point_.dwell_s = point_.dwell_s;
        machine_point_.actions = std::move(point_.actions);
        machine_point_.actions.shrink_to_fit();
        return std::move(machine_point_);
    }
    if (auto error = find_point_error()) return tl::unexpected(*std::move(error));
    if (has(TargetKey::center_mm)) {
        point_.arc = center_;
    } else {
        point_.arc = via_;
    }
    point_.actions.shrink_to_fit();
    return std::move(point_);
}

std::string unknown_key(std::string_view key, std::string_view where,
                        std::span<const std::string_view> known) {
    constexpr std::size_t kMaxShownLength = 64;
    const auto nearest = text::nearest_name(key, known);
    const std::string hint = nearest ? fmt::format("did you mean '{}'?", *nearest)
                                     : fmt::format("known keys: {}", text::joined(known, ", "));
    return fmt::format("unknown key '{}' in {}; {}", key.substr(0, kMaxShownLength), where, hint);
}

}  // namespace gsim::path
