#include "cam/surface/jet_point.h"

namespace gsim::surface {

Vector jet_center(const JetPoint& at, const JetShape& jet) {
    return at.edge_mm + jet.kerf_mm / 2 * at.lateral;
}

Vector lower_jet_center(const JetPoint& at, const JetShape& jet) {
    const Vector middle = jet_center(at, jet);
    return middle + (at.low_mm - middle).dot(at.axis) * at.axis;
}

Vector tcp_position(const JetPoint& at, const JetShape& jet) {
    const double rise_mm = jet.height_mm - jet.kerf_mm / 2 * at.lateral.dot(at.normal);
    return jet_center(at, jet) + rise_mm / at.axis.dot(at.normal) * at.axis;
}

}  // namespace gsim::surface
