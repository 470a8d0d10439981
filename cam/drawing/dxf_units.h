#pragma once

namespace gsim::drawing {

/// Returns the size of a unit by $INSUNITS; 1 mm for code 0, which means unspecified. Throws Error for
/// units in which no part is drawn.
double dxf_unit_mm(int code);

}  // namespace gsim::drawing
