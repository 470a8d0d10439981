#pragma once

#include <optional>
#include <span>
#include <string>

#include "calibrate/times/fit.h"
#include "calibrate/times/model_selection.h"

namespace gsim::calibrate {

/// Returns the uncertainty of the fit's parameters, for the machine file.
machine::Calibration make_calibration(const Fit& fit);

/// Returns the machine file of a fit, with the results at its top as comments.
std::string machine_text(const Fit& fit, std::span<const RecordedRun> runs);

/// Returns a table for people: values with their spread, undetermined parameters, and each run with its time
/// and error, the worst first.
std::string fit_table(const Fit& fit, std::span<const RecordedRun> runs);

/// Returns the same as JSON, with the covariance of the logarithms.
std::string fit_json(const Fit& fit, std::span<const RecordedRun> runs,
                     const std::optional<ModelSelection>& selection);

/// Returns a picture (SVG) of the errors, one bar a run, in percent.
std::string residuals_svg(const Fit& fit, std::span<const RecordedRun> runs);

/// Returns a short part program (G-code of any controller) that depends on the parameters that these runs do
/// not determine; empty if they determine all.
std::string test_program(const Fit& fit);

}  // namespace gsim::calibrate
