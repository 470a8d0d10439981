#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gsim::machine {

/// How the axes of a group move beside the others in a move of the tool to a pose; see docs/groups.md.
enum class GroupMotion : std::uint8_t {
    synchronous,  ///< All arrive together; the tool goes its way as if the group stood where it goes to.
    coordinated,  ///< The tool goes its way on the work, whatever the group does meanwhile.
    independent,  ///< Poses do not lead it: it goes by itself, as fast as it can, and moves do not wait for
                  ///< it.
};

/// Axes that are a unit of their own beside those that move the tool: a positioner, a track. The inverse
/// leaves them where the program has them.
struct AxisGroup {
    std::string name;
    std::vector<std::size_t> axes;                  ///< Indices; each axis is in one group at most.
    GroupMotion motion = GroupMotion::synchronous;  ///< Until a program says another one.

    bool operator==(const AxisGroup&) const = default;
};

}  // namespace gsim::machine
