#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "cam/waterjet/inference.h"
#include "cam/waterjet/materials.h"

namespace gsim::waterjet {

/// What is to be cut. Whatever is left out comes from the materials file or is inferred.
struct CuttingRequest {
    std::string material;
    double thickness_mm = 0;
    std::string thickness_basis;    ///< From what it was inferred; empty where it was given.
    std::optional<double> quality;  ///< 1 (just through) .. 5 (finest edge)
    std::optional<double> pressure_mpa;
    std::optional<double> orifice_mm;
    std::optional<double> mixing_tube_mm;
    std::optional<double> abrasive_g_min;
    std::optional<double> speed_mm_min;
    std::optional<double> kerf_mm;
    std::optional<double> pierce_s;
    bool moving_pierce = false;  ///< The nozzle moves meanwhile; pierce_s is of that, too.
};

/// How it is cut.
struct CuttingPlan {
    std::string material;
    double thickness_mm = 0;
    double machinability = 0;
    double quality = 0;
    JetSetting jet;
    double water_l_min = 0;
    double cutting_speed_mm_min = 0;     ///< On a straight line.
    double separation_speed_mm_min = 0;  ///< At which the jet just comes through.
    double kerf_mm = 0;                  ///< At the entry: the tool path lies half of it off the contour.
    double exit_kerf_mm = 0;
    double pierce_s = 0;                    ///< For each pierce, with the nozzle at rest.
    std::optional<double> moving_pierce_s;  ///< While it moves; none where that was not asked for.
    double taper_mm = 0;                    ///< By which each side closes at the cutting speed.
    double lag_mm = 0;                      ///< At the cutting speed.
    double contour_error_mm = 0;            ///< What of the lag may show.
    LagRule lag;                            ///< By which curves and corners are slower.
    KerfRule kerf;                          ///< By which sides lean.
    std::vector<SettledValue> values;       ///< In the order in which they were settled.
    std::vector<std::string> warnings;      ///< Sentences.
};

/// Settles every value. The error is a sentence: an unknown material, a value out of range, a mixing tube
/// that is not wider than its orifice.
tl::expected<CuttingPlan, std::string> plan_cutting(const Materials& materials,
                                                    const CuttingRequest& request);

/// The feed on an arc of the tool path, in mm/min: the cutting speed, or as much less as keeps the jet's lag
/// within the contour's error. `radius_mm` <= 0 or NaN counts as 0, infinity is a straight line.
double feed_for_radius_mm_min(const CuttingPlan& plan, double radius_mm);

/// The feed in a corner where the direction of the tool path turns by `turn_rad`, of either sign (0: straight
/// on, pi: back), in mm/min. It holds for corner_zone_mm() before the corner and behind it.
double feed_for_corner_mm_min(const CuttingPlan& plan, double turn_rad);

/// How long before a corner and behind it the jet's exit has not come round it: the lag at the cutting speed.
double corner_zone_mm(const CuttingPlan& plan);

/// The feed on a straight line where the jet has this much of the material to go through, as a jet has that
/// leans: the cutting speed at the plan's thickness, else by the cutting equation. `thickness_mm` > 0.
double speed_at_thickness_mm_min(const CuttingPlan& plan, double thickness_mm);

/// How far the jet has to lean over the waste, in deg, so that the side of the part gets straight that is cut
/// at that feed: by what the kerf closes over the thickness.
double straightening_lean_deg(const CuttingPlan& plan, double feed_mm_min);

}  // namespace gsim::waterjet
