#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "cam/drawing/drawing.h"

namespace gsim::drawing {

/// Returns the contours in a DXF file (text form, as of R12): LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE,
/// POLYLINE, SPLINE and INSERT of the model space, on layers that are neither off nor frozen. The unit is
/// that of $INSUNITS, mm if it is missing. The error message begins with the line.
///
/// Source: Autodesk, "DXF Reference" (AutoCAD 2012).
Result<Drawing> read_dxf(std::string_view text, const ReadOptions& options);

}  // namespace gsim::drawing
