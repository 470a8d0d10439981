#include "cam/waterjet/cutting_speed.h"

#include <cmath>

namespace gsim::waterjet {

namespace {

constexpr double kSpeedConstant = 788;  // in MPa, mm, g/min and mm/min; 163 in kpsi, in, lb/min and in/min

// Returns the value in the brackets for a machinability of 1, a thickness of 1 mm and a quality of 1.
double jet_strength(const JetSetting& jet) {
    return jet.abrasive_factor * std::pow(jet.pressure_mpa, 1.594) * std::pow(jet.orifice_mm, 1.374) *
           std::pow(jet.abrasive_g_min, 0.343) / (kSpeedConstant * std::pow(jet.mixing_tube_mm, 0.618));
}

}  // namespace

double cutting_speed_mm_min(const JetSetting& jet, double machinability, double thickness_mm,
                            double quality) {
    return std::pow(jet_strength(jet) * machinability / (quality * thickness_mm), kSpeedExponent);
}

double machinability_of_cut(const JetSetting& jet, double speed_mm_min, double thickness_mm, double quality) {
    return std::pow(speed_mm_min, 1 / kSpeedExponent) * quality * thickness_mm / jet_strength(jet);
}

}  // namespace gsim::waterjet
