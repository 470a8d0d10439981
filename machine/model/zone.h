#pragma once

#include <array>
#include <optional>

namespace gsim::machine {

enum class ZoneKind {
    enter_forbidden,  ///< A security zone: the tool stays outside.
    leave_forbidden,  ///< A security zone: the tool stays inside.
    working,          ///< The working zone: the tool centre point stays inside, always.
};

/// The walls of a zone on one axis, in mm of machine coordinates; min_mm is below max_mm.
struct ZoneLimits {
    double min_mm = 0;
    double max_mm = 0;

    bool operator==(const ZoneLimits&) const = default;
};

/// A box in machine coordinates, as machine data give it (docs/machine-data.md).
struct Zone {
    int number = 1;
    ZoneKind kind = ZoneKind::enter_forbidden;
    /// Limits of X, Y and Z; an axis without limits has no walls. So a zone with two of them is an area,
    /// whatever the third axis does. At least one axis has limits.
    std::array<std::optional<ZoneLimits>, 3> limits = {};
    bool active_at_start = true;
    /// The number by which a program switches the zone on and off; none: it stays as at the start.
    std::optional<int> switch_number = {};

    bool operator==(const Zone&) const = default;
};

}  // namespace gsim::machine
