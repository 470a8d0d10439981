#pragma once

// The parts that are not flat, as solids: what samples/parts holds as STEP files, and what tests know of them
// in closed form.

#include <TopoDS_Shape.hxx>
#include <filesystem>

namespace gsim::solid::models {

/// Returns the thesis's wheel: a plate with pockets that have tilted walls. The walls are ruled from the path
/// of the jet's TCP in the path file to where it leaves the plate. The origin is in the middle of the upper
/// side.
TopoDS_Shape wheel(const std::filesystem::path& path_file);
inline constexpr double kWheelThickness_mm = 6.35;
inline constexpr double kRimRadius_mm = 215.9, kBoreRadius_mm = 25.4;

/// Returns sheet metal of 6 mm, bent up about the Y axis: one flange level, from x = 0 to -80, the other one
/// rising. The level flange has a slot and a hole, the other a round and a tapered hole.
TopoDS_Shape bracket();
struct Bracket {
    static constexpr double kThickness_mm = 6, kBend_deg = 50, kOuterRadius_mm = 14, kWidth_mm = 60;
    static constexpr double kHoleX_mm = -30, kHoleY_mm = 40,
                            kHoleRadius_mm = 9;  // upright, in the level flange
    static constexpr double kSlotX_mm = -60, kSlotY_mm = 30, kSlotHalf_mm = 12,
                            kSlotRadius_mm = 6;  // along Y
    static constexpr double kFarAlong_mm = 22, kFarY_mm = 18,
                            kFarRadius_mm = 10;  // in the rising flange, from the bend on
    static constexpr double kTaperAlong_mm = 50, kTaperY_mm = 36, kTaperRadius_mm = 11;  // on the upper side
    static constexpr double kTaper_deg = 12;                                             // smaller below
};

/// Returns the shell of an upright cone, with a slot through its side that is wider outside.
TopoDS_Shape frustum();
struct Frustum {
    static constexpr double kLowerRadius_mm = 120, kUpperRadius_mm = 50, kHeight_mm = 50, kWall_mm = 5;
    static constexpr double kSlotRadius_mm = 6, kSlotHalf_mm = 15;  // at the middle of the side, along Y
    static constexpr double kTaper_deg = 12;
};

}  // namespace gsim::solid::models
