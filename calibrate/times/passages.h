#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "calibrate/times/motion_record.h"

namespace gsim::calibrate {

/// When a recorded motion began and ended, s by its clock: the samples between which it leaves its first
/// place and comes to its last one. Nothing where it stays within 0.01 mm.
struct Span {
    double start_s = 0;
    double end_s = 0;
};
std::optional<Span> motion_span(std::span<const MotionSample> samples);

/// When a recorded motion passed each of `places_mm` nearest, in their order; nothing for those that it does
/// not come within 1 mm of behind the one before. Between two samples it goes straight, at one speed.
std::vector<std::optional<double>> passages_s(std::span<const MotionSample> samples,
                                              std::span<const Eigen::Vector3d> places_mm);

}  // namespace gsim::calibrate
