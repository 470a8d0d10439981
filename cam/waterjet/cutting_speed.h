#pragma once

namespace gsim::waterjet {

/// Parameters of the jet.
struct JetSetting {
    double pressure_mpa = 0;     ///< Water pressure before the orifice.
    double orifice_mm = 0;       ///< Inner diameter.
    double mixing_tube_mm = 0;   ///< Inner diameter.
    double abrasive_g_min = 0;   ///< Mass flow.
    double abrasive_factor = 1;  ///< Kind of abrasive: 1 for garnet.

    bool operator==(const JetSetting&) const = default;
};

/// The quality of a cut that just separates, and that of the finest edge.
inline constexpr double kSeparationQuality = 1;
inline constexpr double kFinestQuality = 5;

/// The speed is proportional to this power of the value in the brackets of the equation.
inline constexpr double kSpeedExponent = 1.15;

/// Returns the traverse speed of a straight cut, in mm/min:
///
///     u = (f_a N_m p^1.594 d_o^1.374 m_a^0.343 / (C q h d_m^0.618))^1.15,  C = 788
///
/// with the pressure p in MPa, orifice d_o, mixing tube d_m and thickness h in mm, the abrasive's flow m_a in
/// g/min, the machinability number N_m of the material and the quality q of the edge, 1 .. 5. All must be
/// above 0. Zeng and Kim, "Parameter prediction and cost analysis in abrasive waterjet cutting operations",
/// 7th American Water Jet Conference, 1993, in the form used by OMAX.
double cutting_speed_mm_min(const JetSetting& jet, double machinability, double thickness_mm, double quality);

/// Returns the machinability number of a material that the jet cuts at `speed_mm_min`: the inverse equation.
double machinability_of_cut(const JetSetting& jet, double speed_mm_min, double thickness_mm, double quality);

}  // namespace gsim::waterjet
