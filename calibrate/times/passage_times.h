#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "calibrate/times/motion_record.h"

namespace gsim::calibrate {

/// Begin and end of a recorded motion, s by its clock: the samples between which it leaves its first position
/// and reaches its last one. Empty if it stays within 0.01 mm.
struct TimeSpan {
    double start_s = 0;
    double end_s = 0;
};
std::optional<TimeSpan> motion_span(std::span<const MotionSample> samples);

/// Returns when a recorded motion was nearest to each of `positions_mm`, in their order; empty for those that
/// it does not approach within 1 mm after the previous one. Between two samples the motion is straight, at
/// constant speed.
std::vector<std::optional<double>> passage_times_s(std::span<const MotionSample> samples,
                                                   std::span<const Eigen::Vector3d> positions_mm);

}  // namespace gsim::calibrate
