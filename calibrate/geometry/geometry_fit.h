#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "calibrate/geometry/deviation.h"
#include "calibrate/geometry/identify.h"
#include "calibrate/geometry/measured_tip.h"
#include "calibrate/geometry/tip_errors.h"

namespace gsim::calibrate {

struct GeometryOptions {
    DeviationChoice choice = {};
    std::optional<double> noise_mm = std::nullopt;   ///< Else it is found from what is left of the errors.
    std::optional<double> noise_deg = std::nullopt;  ///< The same of turns.
};

struct FoundDeviation {
    Deviation deviation;
    double value = 0;
    double spread = 0;  ///< One standard deviation; both in the deviation's unit.
};

/// A machine's geometry, fitted to measured tips.
struct GeometryFit {
    Geometry geometry;
    std::vector<FoundDeviation> found;
    std::vector<HeldDeviation> held;
    Eigen::MatrixXd covariance;       ///< Of `found`, in its order and units.
    Eigen::VectorXd singular_values;  ///< See Identified.
    std::vector<TipError> before;     ///< Of each tip; in the instrument's frame by the best alignment alone.
    std::vector<TipError> after;
    std::vector<bool> outliers;   ///< Tips that lie farther off than noise puts one in 10,000.
    Noise noise;                  ///< As given, or as found.
    bool noise_is_found = false;  ///< That of places was not given.
    double left_over_noise = 0;   ///< Errors after over what noise makes of them: about 1 where all is well.
    std::string told;             ///< What the last fit ended with, in Ceres's words.
};

/// Fits the deviations of `machine` that `tips` tell of: least squares of the errors in units of their noise,
/// robust where a tip is off by more than noise is (Huber), on the machine's own kinematics (Ceres,
/// Levenberg-Marquardt). The error: there are too few tips, or nothing is told.
tl::expected<GeometryFit, std::string> fit_geometry(const machine::Machine& machine,
                                                    std::span<const MeasuredTip> tips,
                                                    const GeometryOptions& options);

}  // namespace gsim::calibrate
