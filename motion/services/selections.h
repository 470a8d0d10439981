#pragma once

#include <optional>
#include <string>

#include "motion/path/cell_frames.h"
#include "motion/planner/move.h"

namespace gsim::motion {

/// The names by which frames of a cell are selected.
struct FrameNames {
    std::string tool;
    std::string object;
};

/// What a client has selected and set by services, with their defaults: it holds for all targets that the
/// client puts until it is set again.
struct Selections {
    rrs::TargetType target_type = rrs::TargetType::joint;
    rrs::MotionType motion_type = rrs::MotionType::joint;
    MoveTerms terms;                        ///< motion_time_s for the next target alone.
    double rest_s = 0;                      ///< Behind the next target alone.
    std::optional<Eigen::Vector3d> tip_mm;  ///< Under tool-centre-point control, in the tool's frame.
    /// Of Cartesian targets: those of these names, else the tool centre point and the work frame.
    WorkFrames frames;
    std::optional<FrameNames> frame_names;
    bool settles = true;             ///< Exact stops wait
    std::optional<double> settle_s;  ///< for this long; none: for the machine's time.
    int flyby_criterion = 0;         ///< 0: the machine's own.
    double blend_tolerance_mm = 0;   ///< Of the fly-by criterion that has one.
    double interpolation_s = 0.01;
};

}  // namespace gsim::motion
