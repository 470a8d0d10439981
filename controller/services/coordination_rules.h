#pragma once

namespace gsim::rrs {

/// Orientation of the tool in linear and circular moves that are not rapid.
enum class OrientationRule {
    joints,        ///< By the angles of the rotary joints.
    great_circle,  ///< Its direction follows the great circle, evenly with the length of the path.
};

/// How the joints of a move go together.
struct CoordinationRules {
    /// Max distance of the TCP from its path if the joints move on curved paths to keep it there
    /// (tool-centre-point control, Cartesian targets): these paths become lines of the joints.
    double tcp_tolerance_mm = 0.001;
    OrientationRule orientation = OrientationRule::joints;
    /// True if the joints outside the tool's path (rotary ones, and a second set of linear ones) arrive with
    /// it, but by independent ramps. Else all joints of a linear or circular move run in proportion at every
    /// instant. Only for planners with plans_uncoordinated_joints: the others know no such moves.
    bool independent_ramps = false;
    /// True if all joints of a rapid move arrive together, in proportion. Else each moves by its own limits
    /// and arrives at its own time, so that the path is not a straight line ("dog-leg"). The latter is only
    /// for planners with plans_uncoordinated_joints.
    bool interpolated_rapids = true;

    bool operator==(const CoordinationRules&) const = default;
};

}  // namespace gsim::rrs
