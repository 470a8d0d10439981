#pragma once

#include <string>
#include <vector>

namespace gsim::machine {

/// A figure that was fitted: a key of the file, and whose it is.
struct CalibratedFigure {
    std::string of;   ///< Letters of axes that have it together ("XY"), "path" or "controller".
    std::string key;  ///< "max_acceleration_mm_s2"

    bool operator==(const CalibratedFigure&) const = default;
};

/// How well figures of a machine are known that were fitted to recorded runs ([calibration]).
struct Calibration {
    int runs = 0;  ///< That they were fitted to.
    double left_percent =
        0;  ///< Of the times of runs, as a standard deviation: what the fit does not explain.
    std::vector<CalibratedFigure> figures;
    /// Covariance of the figures' logarithms, in percent by percent: a row for each.
    std::vector<std::vector<double>> covariance_percent2;

    bool operator==(const Calibration&) const = default;
};

}  // namespace gsim::machine
