#include "cam/waterjet/water_flow.h"

#include <cmath>
#include <numbers>

namespace gsim::waterjet {

double water_flow_l_min(double orifice_mm, double pressure_mpa, double discharge) {
    constexpr double kDensity_kg_m3 = 1000;
    const double area_m2 = std::numbers::pi / 4 * orifice_mm * orifice_mm * 1e-6;
    const double speed_m_s = std::sqrt(2 * pressure_mpa * 1e6 / kDensity_kg_m3);
    return discharge * area_m2 * speed_m_s * 60e3;
}

}  // namespace gsim::waterjet
