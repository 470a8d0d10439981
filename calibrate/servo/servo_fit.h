#pragma once

#include <array>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "calibrate/servo/servo_record.h"
#include "machine/model/servo_table.h"

namespace gsim::calibrate {

/// A figure of a servo loop that was fitted.
struct ServoFigure {
    const char* key = "";  ///< Of the machine file.
    double value = 0;
    double spread = 0;  ///< One standard deviation, in the unit of the value.
};

/// The servo loop that an axis was found to have.
struct ServoFit {
    char letter = 'X';
    machine::Servo servo;
    std::vector<ServoFigure> figures;  ///< Those of the loop that are there; the others are 0.
    double error_rms = 0;              ///< Of the recorded following error, mm or deg,
    double left_rms = 0;               ///< and of what the loop does not explain of it.
};

/// Where an axis with this loop is at the samples of a record: from where it was at the first one, without
/// speed, behind set points that go straight from sample to sample.
std::vector<double> follow(const machine::Servo& servo, const AxisRecord& record);

/// Fits a servo loop to a record: least squares of places (Ceres, Levenberg-Marquardt). It begins with the
/// gain alone, and takes one figure more (lag, feed-forward of speed or of acceleration, delay) as long as
/// one lessens the Bayesian information criterion (Schwarz, 1978) by ten at least. The error: the axis does
/// not move, or follows without an error that could tell.
tl::expected<ServoFit, std::string> fit_servo(const AxisRecord& record);

}  // namespace gsim::calibrate
