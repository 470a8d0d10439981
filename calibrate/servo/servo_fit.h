#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/error.h"
#include "calibrate/servo/servo_record.h"
#include "machine/model/servo_table.h"

namespace gsim::calibrate {

/// Fitted parameter of a servo loop.
struct FittedServoParameter {
    const char* key = "";  ///< Key in the machine file.
    double value = 0;
    double standard_deviation = 0;  ///< One standard deviation, in the unit of the value.
};

/// Fitted servo loop of an axis.
struct ServoFit {
    char letter = 'X';
    machine::Servo servo;
    std::vector<FittedServoParameter>
        fitted_parameters;    ///< Those of the loop that are there; the others are 0.
    double error_rms = 0;     ///< For the recorded following error, mm or deg,
    double residual_rms = 0;  ///< and of what the loop does not explain of it.
};

/// Returns the position of an axis with this loop at the samples of a record. It starts at the first sample's
/// position, without speed, and follows set points that are linear from sample to sample.
std::vector<double> simulate_following(const machine::Servo& servo, const AxisRecord& record);

/// Fits a servo loop to a record: least squares of positions (Ceres, Levenberg-Marquardt). It begins with the
/// gain alone, and adds parameters one by one (lag, feed-forward of speed or of acceleration, delay). Each
/// must reduce the Bayesian information criterion (Schwarz, 1978) by at least ten. The error: the axis does
/// not move, or follows without a usable error.
Result<ServoFit> fit_servo(const AxisRecord& record);

}  // namespace gsim::calibrate
