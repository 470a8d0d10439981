#pragma once

namespace gsim::waterjet {

/// What an orifice lets through, in l/min: Q = C_d A sqrt(2 p / rho), with water of 1000 kg/m3 that is not
/// compressed (Bernoulli; `discharge` is C_d, about 0.65 for a sapphire with a sharp edge).
double water_flow_l_min(double orifice_mm, double pressure_mpa, double discharge);

}  // namespace gsim::waterjet
