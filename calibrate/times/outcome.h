#pragma once

#include <optional>
#include <span>
#include <string>

#include "calibrate/times/choice.h"
#include "calibrate/times/fit.h"

namespace gsim::calibrate {

/// What the fit says of how sure its figures are, for the machine file.
machine::Calibration calibration_of(const Fit& fit);

/// The machine file of a fit, with what was found above it as comments.
std::string machine_text(const Fit& fit, std::span<const RecordedRun> runs);

/// For people: values with their spread, what was not to be found, and each run with its time and error, the
/// worst first.
std::string fit_table(const Fit& fit, std::span<const RecordedRun> runs);

/// The same as JSON, with the covariance of the logarithms.
std::string fit_json(const Fit& fit, std::span<const RecordedRun> runs, const std::optional<Choice>& choice);

/// A picture (SVG) of the errors, one bar a run, in percent.
std::string residuals_svg(const Fit& fit, std::span<const RecordedRun> runs);

/// A short part program (G-code of any control) that depends on what these runs tell nothing of; empty where
/// they tell of all.
std::string test_program(const Fit& fit);

}  // namespace gsim::calibrate
