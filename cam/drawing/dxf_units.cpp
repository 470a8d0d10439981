#include "cam/drawing/dxf_units.h"

#include <fmt/format.h>

#include "base/units.h"
#include "cam/drawing/dxf_groups.h"

namespace gsim::drawing {

double dxf_unit_mm(int code) {
    switch (code) {
        case 0: return 1;
        case 1: return kMmPerInch;
        case 2: return 304.8;
        case 4: return 1;
        case 5: return 10;
        case 6: return 1000;
        case 8: return 25.4e-6;
        case 9: return 0.0254;
        case 10: return 914.4;
        case 13: return 1e-3;
        case 14: return 100;
        default:
            throw error_at(
                1, fmt::format("the unit $INSUNITS {} is not supported for parts; name a unit", code));
    }
}

}  // namespace gsim::drawing
