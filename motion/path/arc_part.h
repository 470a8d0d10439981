#pragma once

#include <optional>

#include "motion/path/arc.h"

namespace gsim::motion {

/// Returns the part of an arc between two of its path lengths, or nullopt if they are too close for an angle
/// between them, so that the path is a point.
inline std::optional<Arc> arc_part(const Arc& arc, double from_mm, double to_mm) {
    if (!(to_mm > from_mm)) return std::nullopt;
    const Arc part = arc.part(from_mm, to_mm);
    if (!(part.sweep_rad > 0)) return std::nullopt;
    return part;
}

}  // namespace gsim::motion
