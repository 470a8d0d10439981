#include "machine/model/frame_pose.h"

#include <numbers>

#include "base/units.h"
#include "motion/kinematics/pose.h"

namespace gsim::machine {

rrs::CartPos frame_pose(const Frame& frame) {
    return kinematics::pose_from_rpy({.x_mm = frame.x_mm,
                                      .y_mm = frame.y_mm,
                                      .z_mm = frame.z_mm,
                                      .roll_rad = frame.roll_deg * kRadPerDeg,
                                      .pitch_rad = frame.pitch_deg * kRadPerDeg,
                                      .yaw_rad = frame.yaw_deg * kRadPerDeg});
}

}  // namespace gsim::machine
