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

/// Machine geometry, fitted to measured TCPs.
struct GeometryFit {
    Geometry geometry;
    std::vector<FoundDeviation> found;
    std::vector<HeldDeviation> held;
    Eigen::MatrixXd covariance;       ///< For `found`, in its order and units.
    Eigen::VectorXd singular_values;  ///< See Identified.
    std::vector<TipError> before;  ///< For each TCP; in the instrument's frame by the best alignment alone.
    std::vector<TipError> after;
    std::vector<bool> outliers;   ///< TCPs with an error that noise exceeds once in 10,000.
    Noise noise;                  ///< As given, or as found.
    bool noise_is_found = false;  ///< Noise of positions was not given.
    double left_over_noise =
        0;             ///< Errors after the fit over those expected from noise: about 1 if all is well.
    std::string told;  ///< Final message of Ceres for the last fit.
};

/// Fits the deviations of `machine` that `tips` determine. It uses least squares of the errors in units of
/// their noise, robust if a TCP error exceeds the noise (Huber). The kinematics are the machine's (Ceres,
/// Levenberg-Marquardt). The error: too few TCPs, or they determine no deviation.
tl::expected<GeometryFit, std::string> fit_geometry(const machine::Machine& machine,
                                                    std::span<const MeasuredTip> tips,
                                                    const GeometryOptions& options);

}  // namespace gsim::calibrate
