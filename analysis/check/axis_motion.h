#pragma once

#include <string>
#include <vector>

#include "machine/model/machine.h"

namespace gsim::check {

/// Motion of an axis as its value grows, with all axes at home: distance or turn of the tool relative to the
/// work, in the work frame.
struct AxisMotion {
    char letter = 'X';
    bool is_rotary = false;              ///< A rotary axis.
    bool carries_work = false;           ///< The work moves, in reverse.
    Eigen::Vector3d direction{0, 0, 1};  ///< Length 1; for a turn its axis, by the right-hand rule.
};

/// Returns the motions of all axes that carry the tool or the work, in their order.
std::vector<AxisMotion> axis_motions(const machine::Machine& machine);

/// Returns "+X moves the tool to the right (+x)": seen from the front, with the work frame's x to the right
/// and its z up.
std::string to_message(const AxisMotion& motion);

/// Returns messages about wrong senses of linear axes that belong together (X Y Z, U V W): they are
/// left-handed, so that parts come out mirrored.
std::vector<std::string> find_left_handed_axes(const std::vector<AxisMotion>& motions);

/// Returns messages about rotary axes A, B and C that turn against the right-hand rule about the machine's
/// own X, Y and Z. Such machines exist, though ISO 841 defines it otherwise.
std::vector<std::string> find_left_handed_rotations(const std::vector<AxisMotion>& motions);

/// Returns the motions as a picture (SVG): arrows along, and round, the directions of the work frame.
std::string axes_svg(const machine::Machine& machine);

}  // namespace gsim::check
