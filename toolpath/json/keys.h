#pragma once

#include <array>
#include <string_view>

#include "toolpath/model/path.h"

namespace gsim::path {

// Keys of the text form (docs/paths.md), the same in JSON and in Lua.

inline constexpr std::array<std::string_view, 6> kProgramKeys = {"$schema", "format", "name",
                                                                 "root",    "paths",  "work_offsets"};

/// Keys of a path; the first two are required.
enum class PathKey {
    name,
    targets,
    work_offset,
    set_offset_mm,
    probe_offset,
    tool,
    length_offset,
    diameter_offset
};

/// In the order of PathKey.
inline constexpr std::array<std::string_view, 8> kPathKeys = {
    "name",         "targets", "work_offset",   "set_offset_mm",
    "probe_offset", "tool",    "length_offset", "diameter_offset"};
inline constexpr std::size_t kRequiredPathKeys = 2;

/// Keys of a target; those from `path` on are for sub-paths, as is `work_offset`. `fixed` and `reference`
/// make a target a point of the machine, which also has `name`, `dwell_s` and `actions`.
enum class TargetKey {
    name,
    motion,
    position_mm,
    via_mm,
    center_mm,
    normal,
    turn_deg,
    tool_axis,
    rpy_deg,
    rotary_deg,
    feed_mm_min,
    feed_deg_min,
    duration_s,
    feed_mm_rev,
    lead_mm,
    work_offset,
    acceleration_mm_s2,
    dwell_s,
    actions,
    fixed,
    reference,
    path,
    repeats,
    set_offset_mm,
    probe_offset,
};

/// In the order of TargetKey.
inline constexpr auto kTargetKeys = std::to_array<std::string_view>({"name",
                                                                     "motion",
                                                                     "position_mm",
                                                                     "via_mm",
                                                                     "center_mm",
                                                                     "normal",
                                                                     "turn_deg",
                                                                     "tool_axis",
                                                                     "rpy_deg",
                                                                     "rotary_deg",
                                                                     "feed_mm_min",
                                                                     "feed_deg_min",
                                                                     "duration_s",
                                                                     "feed_mm_rev",
                                                                     "lead_mm",
                                                                     "work_offset",
                                                                     "acceleration_mm_s2",
                                                                     "dwell_s",
                                                                     "actions",
                                                                     "fixed",
                                                                     "reference",
                                                                     "path",
                                                                     "repeats",
                                                                     "set_offset_mm",
                                                                     "probe_offset"});

/// Keys of a touch of `probe_offset`; the first five are required.
enum class TouchKey { axis, from_mm, to_mm, surface_mm, feed_mm_min, probe_radius_mm, tool };

/// In the order of TouchKey.
inline constexpr std::array<std::string_view, 7> kTouchKeys = {
    "axis", "from_mm", "to_mm", "surface_mm", "feed_mm_min", "probe_radius_mm", "tool"};
inline constexpr std::size_t kRequiredTouchKeys = 5;

/// Key of a work coordinate system that is not an axis.
inline constexpr std::string_view kRotationKey = "rotation_deg";

inline constexpr std::string_view key_name(TargetKey key) {
    return kTargetKeys[static_cast<std::size_t>(key)];
}
inline constexpr std::string_view key_name(TouchKey key) {
    return kTouchKeys[static_cast<std::size_t>(key)];
}
inline constexpr std::string_view key_name(PathKey key) {
    return kPathKeys[static_cast<std::size_t>(key)];
}

/// In the order of MotionType.
inline constexpr std::array<std::string_view, 4> kMotionNames = {"rapid", "linear", "circular", "none"};

}  // namespace gsim::path
