#pragma once

#include <array>
#include <string_view>

#include "runtime/path/path.h"

namespace gsim::path {

// The keys of the text form (docs/paths.md), the same in JSON and in Lua.

inline constexpr std::array<std::string_view, 5> kProgramKeys = {"$schema", "name", "root", "paths",
                                                                 "work_offsets"};

/// A path's keys; the first two it must have.
enum class PathKey { name, targets, work_offset, set_offset_mm, tool, length_offset, diameter_offset };

/// In the order of PathKey.
inline constexpr std::array<std::string_view, 7> kPathKeys = {
    "name", "targets", "work_offset", "set_offset_mm", "tool", "length_offset", "diameter_offset"};
inline constexpr std::size_t kNeededPathKeys = 2;

/// A target's keys; those from `path` on are of sub-paths, as is `work_offset`. `fixed` and `reference` make
/// a target a point of the machine, which has `name`, `dwell_s` and `actions` beside them.
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
};

/// In the order of TargetKey.
inline constexpr std::array<std::string_view, 24> kTargetKeys = {"name",
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
                                                                 "set_offset_mm"};

/// The key of a work coordinate system that is no axis.
inline constexpr std::string_view kRotationKey = "rotation_deg";

inline constexpr std::string_view name_of(TargetKey key) {
    return kTargetKeys[static_cast<std::size_t>(key)];
}
inline constexpr std::string_view name_of(PathKey key) {
    return kPathKeys[static_cast<std::size_t>(key)];
}

/// In the order of MotionType.
inline constexpr std::array<std::string_view, 4> kMotionNames = {"rapid", "linear", "circular", "none"};

}  // namespace gsim::path
