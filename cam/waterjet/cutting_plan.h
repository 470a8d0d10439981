#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "cam/waterjet/materials.h"
#include "cam/waterjet/value_resolver.h"

namespace gsim::waterjet {

/// The cutting task. Missing values come from the materials file or are inferred.
struct CuttingRequest {
    std::string material;
    double thickness_mm = 0;
    std::string thickness_basis;    ///< Source of the inference; empty if it was given.
    std::optional<double> quality;  ///< 1 (just through) .. 5 (finest edge)
    std::optional<double> pressure_mpa;
    std::optional<double> orifice_mm;
    std::optional<double> mixing_tube_mm;
    std::optional<double> abrasive_g_min;
    std::optional<double> speed_mm_min;
    std::optional<double> kerf_mm;
    std::optional<double> pierce_s;
    bool dynamic_pierce = false;  ///< The nozzle moves meanwhile; pierce_s is of that, too.
};

/// The resolved cutting parameters.
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
    double pierce_s = 0;                     ///< For each pierce, with the nozzle at standstill.
    std::optional<double> dynamic_pierce_s;  ///< While it moves; none if not requested.
    double taper_mm = 0;                     ///< By which each side closes at the cutting speed.
    double lag_mm = 0;                       ///< At the cutting speed.
    double contour_error_mm = 0;             ///< Visible share of the lag.
    LagRule lag;                             ///< By which curves and corners are slower.
    KerfRule kerf;                           ///< By which sides lean.
    std::vector<ResolvedValue> values;       ///< In the order in which they were settled.
    std::vector<std::string> warnings;       ///< Messages.
};

/// Settles every value. The error is a message: an unknown material, a value out of range, a mixing tube that
/// is not wider than its orifice.
Result<CuttingPlan> plan_cutting(const Materials& materials, const CuttingRequest& request);

/// Returns the feed on an arc of the tool path, in mm/min: the cutting speed, reduced as far as necessary to
/// keep the jet's lag within the contour's error. `radius_mm` <= 0 or NaN counts as 0, infinity is a straight
/// line.
double feed_for_radius_mm_min(const CuttingPlan& plan, double radius_mm);

/// Returns the feed in a corner where the direction of the tool path turns by `turn_rad`, of either sign (0:
/// straight on, pi: back), in mm/min. It is valid for corner_zone_mm() on both sides of the corner.
double feed_for_corner_mm_min(const CuttingPlan& plan, double turn_rad);

/// Returns the distance on both sides of a corner within which the jet's exit, behind the nozzle, has not
/// passed it: the lag at the cutting speed.
double corner_zone_mm(const CuttingPlan& plan);

/// Returns the feed on a straight line if the jet has to pass this much of the material, as a tilted jet
/// does: the cutting speed at the plan's thickness, else by the cutting equation. `thickness_mm` > 0.
double speed_at_thickness_mm_min(const CuttingPlan& plan, double thickness_mm);

/// Returns the tilt of the jet over the waste, in deg, that makes the side of the part straight when it is
/// cut at that feed. It compensates the narrowing of the kerf over the thickness.
double taper_compensation_deg(const CuttingPlan& plan, double feed_mm_min);

}  // namespace gsim::waterjet
