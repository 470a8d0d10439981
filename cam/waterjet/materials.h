#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "cam/waterjet/cutting_speed.h"
#include "cam/waterjet/jet_lag.h"
#include "cam/waterjet/kerf.h"
#include "cam/waterjet/pierce.h"

namespace gsim::waterjet {

/// The shop's usual jet, and the rules for its missing values.
struct JetRule {
    double pressure_mpa = 0;
    double orifice_mm = 0;
    std::optional<double> mixing_tube_mm;
    std::optional<double> abrasive_g_min;
    double abrasive_factor = 1;
    double discharge = 0;  ///< Orifice factor (water_flow_l_min()).
    double tube_to_orifice =
        0;  ///< Ratio of the mixing tube's diameter to the orifice's, if it is not given; > 1.
    double abrasive_to_water =
        0;               ///< Ratio of the mass of abrasive to that of water, if its flow is not given.
    double quality = 0;  ///< 1 .. 5

    bool operator==(const JetRule&) const = default;
};

/// Prices of things, and their lifetimes. Money is in `currency` throughout.
struct PriceRule {
    std::string currency;
    double machine_per_h = 0;  ///< Machine, operator, energy.
    double water_per_m3 = 0;
    double abrasive_per_kg = 0;
    double recycled_per_kg = 0;  ///< Washing and drying of what is used again.
    double recycled_share = 0;   ///< Share of the abrasive's mass, 0 .. < 1.
    double orifice_price = 0;
    double orifice_life_h = 0;  ///< With the jet on.
    double mixing_tube_price = 0;
    double mixing_tube_life_h = 0;  ///< With the jet on.

    bool operator==(const PriceRule&) const = default;
};

/// A cut that a shop has tested: its machinability follows from it.
struct MeasuredCut {
    JetSetting jet;
    double speed_mm_min = 0;
    double thickness_mm = 0;
    double quality = 0;

    bool operator==(const MeasuredCut&) const = default;
};

/// A material, with exactly one of machinability, like and measured.
struct Material {
    std::string name;
    std::optional<double> machinability;
    std::string like;  ///< The name of a material with its own machinability.
    std::optional<MeasuredCut> measured;
    std::string source;  ///< Source of the number; may be empty.

    bool operator==(const Material&) const = default;
};

/// A materials file (docs/waterjet.md).
struct Materials {
    JetRule jet;
    LagRule lag;
    KerfRule kerf;
    PierceRule pierce;
    PriceRule prices;
    std::vector<Material> materials;
    std::vector<std::string> warnings;  ///< About the file, each as "file:line:column: message".

    bool operator==(const Materials&) const = default;
};

/// Returns the material of that name; the error names the nearest one.
Result<const Material*> find_material(const Materials& materials, std::string_view name);

/// Returns the machinability of one of these materials: its own number, that of the material it is like, or
/// the result of its measured cut.
double material_machinability(const Materials& materials, const Material& material);

}  // namespace gsim::waterjet
