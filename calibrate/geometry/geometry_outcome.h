#pragma once

#include <span>
#include <string>

#include <tl/expected.hpp>

#include "calibrate/geometry/geometry_fit.h"
#include "calibrate/geometry/squareness.h"

namespace gsim::calibrate {

/// The machine file of a fit, with what was found above it as comments. The error: programs would refuse it.
tl::expected<std::string, std::string> geometry_text(const GeometryFit& fit);

/// For people: what was found with its spread, what was not to be told, squareness, and tips before and
/// after, the worst first.
std::string geometry_table(const GeometryFit& fit, std::span<const Squareness> squareness);

/// The same as JSON, with the covariance.
std::string geometry_json(const GeometryFit& fit, std::span<const Squareness> squareness);

/// A picture (SVG) of the tips' errors in micrometres, before and after, one bar a tip, each side to its own
/// measure.
std::string tips_svg(const GeometryFit& fit);

}  // namespace gsim::calibrate
