#pragma once

namespace gsim::waterjet {

/// Returns the flow through an orifice, in l/min: Q = C_d A sqrt(2 p / rho), with water of 1000 kg/m3 that is
/// not compressed (Bernoulli; `discharge` is C_d, about 0.65 for a sapphire with a sharp edge).
double water_flow_l_min(double orifice_mm, double pressure_mpa, double discharge);

}  // namespace gsim::waterjet
