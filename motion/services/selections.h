#pragma once

#include <optional>
#include <string>

#include "motion/path/cell_frames.h"
#include "motion/planner/move.h"

namespace gsim::motion {

/// Names by which frames of a cell are selected.
struct FrameNames {
    std::string tool;
    std::string object;
};

/// Selections and settings of a client by services, with their defaults. They hold for all targets that the
/// client enqueues until they are set again.
struct Selections {
    rrs::TargetType target_type = rrs::TargetType::joint;
    rrs::MotionType motion_type = rrs::MotionType::joint;
    MoveParameters move_parameters;         ///< motion_time_s for the next target alone.
    double dwell_s = 0;                     ///< Dwell at only the next target.
    std::optional<Eigen::Vector3d> tcp_mm;  ///< Under tool-centre-point control, in the tool's frame.
    /// Frames of Cartesian targets: those of these names, else the TCP and the work frame.
    WorkFrames frames;
    std::optional<FrameNames> frame_names;
    bool settles = true;             ///< Exact stops wait
    std::optional<double> settle_s;  ///< for this long; none: for the machine's time.
    int flyby_criterion = 0;         ///< 0: the machine's own.
    double blend_tolerance_mm = 0;   ///< Tolerance of the fly-by criterion that has one.
    double interpolation_s = 0.01;
};

}  // namespace gsim::motion
