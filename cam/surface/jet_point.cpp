#include "cam/surface/jet_point.h"

namespace gsim::surface {

Vector middle_of(const JetPoint& at, const JetShape& jet) {
    return at.edge_mm + jet.kerf_mm / 2 * at.aside;
}

Vector low_middle_of(const JetPoint& at, const JetShape& jet) {
    const Vector middle = middle_of(at, jet);
    return middle + (at.low_mm - middle).dot(at.axis) * at.axis;
}

Vector tip_of(const JetPoint& at, const JetShape& jet) {
    const double rise_mm = jet.height_mm - jet.kerf_mm / 2 * at.aside.dot(at.normal);
    return middle_of(at, jet) + rise_mm / at.axis.dot(at.normal) * at.axis;
}

}  // namespace gsim::surface
