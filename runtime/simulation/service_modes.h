#pragma once

#include "runtime/motion/planner_setup.h"
#include "runtime/rrs/types.h"

namespace gsim::simulation {

/// What a client has selected and programmed by services, with their defaults, as far as moves of a program
/// select it, too: between such moves it holds as if the program had made none.
struct ServiceModes {
    rrs::TargetType target_type = rrs::TargetType::joint;
    rrs::MotionType motion_type = rrs::MotionType::joint;
    double position_speed_mm_s = 0;  ///< 0: none was programmed.
    double orientation_speed_rad_s = motion::kUnlimited;
    bool rapid = false;
};

}  // namespace gsim::simulation
