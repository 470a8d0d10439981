#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "calibrate/geometry/deviation.h"
#include "calibrate/geometry/identification.h"
#include "calibrate/geometry/measured_tcp.h"
#include "calibrate/geometry/tcp_errors.h"

namespace gsim::calibrate {

struct GeometryOptions {
    DeviationOptions deviation_options = {};
    std::optional<double> noise_mm = std::nullopt;   ///< Else it is found from what is left of the errors.
    std::optional<double> noise_deg = std::nullopt;  ///< The same of turns.
};

struct FittedDeviation {
    Deviation deviation;
    double value = 0;
    double standard_deviation = 0;  ///< One standard deviation; both in the deviation's unit.
};

/// Machine geometry, fitted to measured TCPs.
struct GeometryFit {
    Geometry geometry;
    std::vector<FittedDeviation> found;
    std::vector<FixedDeviation> fixed;
    Eigen::MatrixXd covariance;       ///< For `found`, in its order and units.
    Eigen::VectorXd singular_values;  ///< See Identification.
    std::vector<TcpError> before;  ///< For each TCP; in the instrument's frame by the best alignment alone.
    std::vector<TcpError> after;
    std::vector<bool> outliers;       ///< TCPs with an error that noise exceeds once in 10,000.
    Noise noise;                      ///< As given, or as found.
    bool noise_is_estimated = false;  ///< Noise of positions was not given.
    double residual_noise_ratio =
        0;  ///< Errors after the fit over those expected from noise: about 1 if all is well.
    std::string solver_message;  ///< Final message of Ceres for the last fit.
};

/// Fits the deviations of `machine` that `tcps` determine. It uses least squares of the errors in units of
/// their noise, robust if a TCP error exceeds the noise (Huber). The kinematics are the machine's (Ceres,
/// Levenberg-Marquardt). The error: too few TCPs, or they determine no deviation.
Result<GeometryFit> fit_geometry(const machine::Machine& machine, std::span<const MeasuredTcp> tcps,
                                 const GeometryOptions& options);

}  // namespace gsim::calibrate
