#pragma once

#include <span>
#include <string>

#include "base/error.h"
#include "calibrate/geometry/geometry_fit.h"
#include "calibrate/geometry/squareness.h"

namespace gsim::calibrate {

/// Returns the machine file of a fit, with the results at its top as comments. The error: programs would
/// reject it.
Result<std::string> geometry_text(const GeometryFit& fit);

/// Returns a table for people: results with their spread, undetermined deviations, squareness, and TCP errors
/// before and after, the worst first.
std::string geometry_table(const GeometryFit& fit, std::span<const Squareness> squareness);

/// Returns the same as JSON, with the covariance.
std::string geometry_json(const GeometryFit& fit, std::span<const Squareness> squareness);

/// Returns a picture (SVG) of the TCP errors in micrometres, before and after, one bar a TCP, each side with
/// a separate scale.
std::string tcps_svg(const GeometryFit& fit);

}  // namespace gsim::calibrate
