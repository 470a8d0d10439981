#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gsim::machine {

/// Motion of the axes of a group, relative to the others, in a move of the tool to a pose; see
/// docs/groups.md.
enum class GroupMotion : std::uint8_t {
    synchronous,  ///< All arrive together; the tool follows its path as if the group were at its target.
    coordinated,  ///< The tool follows its path on the work, whatever the group does meanwhile.
    independent,  ///< Not driven by poses: it moves on its own, as fast as it can, and moves do not wait for
                  ///< it.
};

/// Axes that form a unit separate from those that move the tool: a positioner, a track. The inverse leaves
/// them as the program has set them.
struct AxisGroup {
    std::string name;
    std::vector<std::size_t> axes;                  ///< Indices; each axis is in one group at most.
    GroupMotion motion = GroupMotion::synchronous;  ///< Until a program says another one.

    bool operator==(const AxisGroup&) const = default;
};

}  // namespace gsim::machine
