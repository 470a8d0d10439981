#pragma once

#include <array>
#include <string_view>

#include "runtime/path/path.h"

namespace gsim::path {

// The keys of the text form (docs/paths.md), the same in JSON and in Lua.

inline constexpr std::array<std::string_view, 4> kProgramKeys = {"$schema", "name", "root", "paths"};
inline constexpr std::array<std::string_view, 2> kPathKeys = {"name", "targets"};

/// A target's keys; those from `path` on are of sub-paths.
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
    acceleration_mm_s2,
    dwell_s,
    actions,
    path,
    repeats,
};

/// In the order of TargetKey.
inline constexpr std::array<std::string_view, 18> kTargetKeys = {
    "name",      "motion",  "position_mm", "via_mm",      "center_mm",    "normal",     "turn_deg",
    "tool_axis", "rpy_deg", "rotary_deg",  "feed_mm_min", "feed_deg_min", "duration_s", "acceleration_mm_s2",
    "dwell_s",   "actions", "path",        "repeats"};

inline constexpr std::string_view name_of(TargetKey key) {
    return kTargetKeys[static_cast<std::size_t>(key)];
}

/// In the order of MotionType.
inline constexpr std::array<std::string_view, 3> kMotionNames = {"rapid", "linear", "circular"};

}  // namespace gsim::path
