#pragma once

namespace gsim::drawing {

/// What a unit is by $INSUNITS; 1 mm for code 0, which says nothing. Throws DrawingFault for units that no
/// part is drawn in.
double dxf_unit_mm(int code);

}  // namespace gsim::drawing
