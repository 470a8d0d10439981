#pragma once

#include <string>
#include <vector>

#include "machine/model/machine.h"

namespace gsim::check {

/// What an axis does as its value grows, with all axes at home: the way, or the turn, of the tool against the
/// work, in the work frame.
struct AxisMotion {
    char letter = 'X';
    bool turns = false;                  ///< A rotary axis.
    bool carries_work = false;           ///< The work moves, the other way.
    Eigen::Vector3d direction{0, 0, 1};  ///< Of length 1; of a turn its axis, by the right-hand rule.
};

/// The motions of all axes that carry the tool or the work, in their order.
std::vector<AxisMotion> axis_motions(const machine::Machine& machine);

/// "+X moves the tool to the right (+x)": seen from the front, with the work frame's x to the right and its z
/// up.
std::string to_sentence(const AxisMotion& motion);

/// What is wrong with the senses of linear axes that belong together (X Y Z, U V W), in sentences: they are
/// left-handed, so that parts come out mirrored.
std::vector<std::string> find_left_handed(const std::vector<AxisMotion>& motions);

/// Rotary axes A, B and C that turn against the right-hand rule about the machine's own X, Y and Z, in
/// sentences; there are such machines, though ISO 841 has it otherwise.
std::vector<std::string> find_left_turns(const std::vector<AxisMotion>& motions);

/// The motions as a picture (SVG): arrows along, and round, the directions of the work frame.
std::string axes_svg(const machine::Machine& machine);

}  // namespace gsim::check
