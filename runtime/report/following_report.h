#pragma once

#include <optional>
#include <vector>

#include "runtime/simulator/move.h"

namespace gsim::simulation {

/// How far an axis was behind its set points: mm of a linear axis, deg of a rotary one, set point less place.
struct AxisFollowing {
    char letter = 'X';
    bool rotary = false;
    double gain_1_s = 0;  ///< Of its position loop; infinite: it follows at once.
    double behind_s = 0;  ///< By which it is late at a constant speed.
    double peak = 0;      ///< The greatest, either way.
    double peak_t_s = 0;
    Place peak_place = {};
    double rms = 0;  ///< Root mean square over the whole run, rests among it.
    double end = 0;  ///< At the end of the run.
};

/// The farthest that the tip really was from the way of its set points, on the part.
struct ContourError {
    double error_mm = 0;
    double t_s = 0;
    Place place = {};  ///< Of the move that was under way.
};

/// Where axes and tip of a run really were (docs/servo.md).
struct FollowingReport {
    std::vector<AxisFollowing> axes;
    ContourError feed = {};   ///< While feed moves and dwells were under way,
    ContourError rapid = {};  ///< and rapid moves.
    /// As `feed`, from the way that the program asks for; a controller module does not tell.
    std::optional<ContourError> program = ContourError{};
    double band_mm = 0;   ///< In which an axis is in position,
    double band_deg = 0;  ///< and a rotary one.
    /// How long after the end of the run all axes are in their bands to stay; none: they are not within 20
    /// time constants of the slowest.
    std::optional<double> in_position_s = 0;
};

}  // namespace gsim::simulation
