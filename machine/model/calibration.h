#pragma once

#include <string>
#include <vector>

namespace gsim::machine {

/// A fitted parameter: a key of the file, and its owner.
struct CalibratedParameter {
    std::string of;   ///< Letters of axes that have it together ("XY"), "path" or "controller".
    std::string key;  ///< "max_acceleration_mm_s2"

    bool operator==(const CalibratedParameter&) const = default;
};

/// Accuracy of those parameters of a machine that were fitted to recorded runs ([calibration]).
struct Calibration {
    int runs = 0;                 ///< That they were fitted to.
    double residual_percent = 0;  ///< Standard deviation of the times of runs that the fit does not explain.
    std::vector<CalibratedParameter> parameters;
    /// Covariance of the parameters' logarithms, in percent by percent: a row for each.
    std::vector<std::vector<double>> covariance_percent2;

    bool operator==(const Calibration&) const = default;
};

}  // namespace gsim::machine
