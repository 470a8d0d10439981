#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "calibrate/times/parameter.h"
#include "calibrate/times/predictor.h"

namespace gsim::calibrate {

/// Result of a fit for a parameter.
struct FittedParameter {
    machine::MachineParameter parameter_id;
    double value = 0;
    double standard_deviation = 0;  ///< Standard deviation of the value's logarithm: 0.01 is 1 %.
    bool identified = true;  ///< false: these runs do not depend on it, or on it and others together alone.
};

/// Parameters of a machine, fitted to recorded runs.
struct Fit {
    machine::Machine machine;
    std::vector<FittedParameter> parameters;
    Eigen::MatrixXd covariance;   ///< For the parameters' logarithms. A parameter that runs do not determine
                                  ///< is known to a factor e (one standard deviation).
    std::vector<double> times_s;  ///< For the runs, on `machine`.
    double noise = 0;  ///< Residual of complete runs, as a standard deviation of the times' logarithms.
};

struct FitOptions {
    FreeParameters open = {};
    int max_steps = 15;
    bool multi_start = false;  ///< From several shares for curves, of which two may explain the same times.
};

/// Fits the open parameters of `machine` to the times of `runs`: least squares of the logarithms of times,
/// robust if a run is off by more than 2 % (Huber), within the parameters' bounds (Ceres,
/// Levenberg-Marquardt). Parameters that the runs do not determine stay near their values. Derivatives are
/// differences over 1 % of each parameter. `on_message` receives a message on each step. The error names a
/// program that does not reach its end, or reports too few runs.
Result<Fit> fit_times(const machine::Machine& machine, std::span<const RecordedRun> runs,
                      const Predictor& predictor, const FitOptions& options,
                      const std::function<void(const std::string&)>& on_message = {});

}  // namespace gsim::calibrate
