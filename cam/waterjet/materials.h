#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "cam/waterjet/cutting_speed.h"
#include "cam/waterjet/jet_lag.h"
#include "cam/waterjet/kerf.h"
#include "cam/waterjet/pierce.h"

namespace gsim::waterjet {

/// The shop's usual jet, and how the values are found that it leaves out.
struct JetRule {
    double pressure_mpa = 0;
    double orifice_mm = 0;
    std::optional<double> mixing_tube_mm;
    std::optional<double> abrasive_g_min;
    double abrasive_factor = 1;
    double discharge = 0;          ///< Of the orifice (water_flow_l_min()).
    double tube_to_orifice = 0;    ///< Mixing tube's diameter by the orifice's, where it is not given; > 1.
    double abrasive_to_water = 0;  ///< Mass of abrasive by that of water, where its flow is not given.
    double quality = 0;            ///< 1 .. 5

    bool operator==(const JetRule&) const = default;
};

/// What things cost, and how long they last. Money is in `currency` throughout.
struct PriceRule {
    std::string currency;
    double machine_per_h = 0;  ///< Machine, operator, energy.
    double water_per_m3 = 0;
    double abrasive_per_kg = 0;
    double recycled_per_kg = 0;  ///< Washing and drying of what is used again.
    double recycled_share = 0;   ///< Of the abrasive's mass, 0 .. < 1.
    double orifice_each = 0;
    double orifice_life_h = 0;  ///< With the jet on.
    double mixing_tube_each = 0;
    double mixing_tube_life_h = 0;  ///< With the jet on.

    bool operator==(const PriceRule&) const = default;
};

/// A cut that a shop has tried: its machinability follows from it.
struct MeasuredCut {
    JetSetting jet;
    double speed_mm_min = 0;
    double thickness_mm = 0;
    double quality = 0;

    bool operator==(const MeasuredCut&) const = default;
};

/// Of machinability, like and measured, a material has exactly one.
struct Material {
    std::string name;
    std::optional<double> machinability;
    std::string like;  ///< The name of a material that has a machinability of its own.
    std::optional<MeasuredCut> measured;
    std::string source;  ///< Where the number is from; may be empty.

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

    bool operator==(const Materials&) const = default;
};

/// The material of that name; the error names the nearest one.
tl::expected<const Material*, std::string> find_material(const Materials& materials, std::string_view name);

/// How well a material of these can be cut: its own number, that of the material it is like, or what follows
/// from its measured cut.
double machinability_of(const Materials& materials, const Material& material);

}  // namespace gsim::waterjet
