#include "tests/cam/solid/part_models.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>
#include <gp_Circ.hxx>
#include <gp_Trsf.hxx>

#include "base/units.h"
#include "tests/cam/solid/solids.h"

namespace gsim::solid::models {

namespace {

// A round-ended slot along Y in the plane at a height, about the origin.
TopoDS_Wire slot_wire(double half_mm, double radius_mm, double z_mm) {
    BRepBuilderAPI_MakeWire wire;
    const gp_Dir up(0, 0, 1);
    const gp_Pnt right_low(radius_mm, -half_mm, z_mm), right_high(radius_mm, half_mm, z_mm);
    const gp_Pnt left_high(-radius_mm, half_mm, z_mm), left_low(-radius_mm, -half_mm, z_mm);
    const gp_Circ high(gp_Ax2(gp_Pnt(0, half_mm, z_mm), up, gp_Dir(1, 0, 0)), radius_mm);
    const gp_Circ low(gp_Ax2(gp_Pnt(0, -half_mm, z_mm), up, gp_Dir(1, 0, 0)), radius_mm);
    wire.Add(BRepBuilderAPI_MakeEdge(right_low, right_high).Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(high, right_high, left_high).Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(left_high, left_low).Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(low, left_low, right_low).Edge());
    return wire.Wire();
}

// Returns the volume that a slot removes, from a height below to one above; its radius is that at 0.
TopoDS_Shape slot_tool(double half_mm, double radius_mm, double taper_deg, double below_mm, double above_mm) {
    const double growth = std::tan(taper_deg * kRadPerDeg);
    BRepOffsetAPI_ThruSections sections(true, true);
    sections.AddWire(slot_wire(half_mm, radius_mm - growth * below_mm, -below_mm));
    sections.AddWire(slot_wire(half_mm, radius_mm + growth * above_mm, above_mm));
    return sections.Shape();
}

// Moves a shape at the origin to a position, its Z along a direction in the plane of X and Z, its Y kept.
TopoDS_Shape placed(const TopoDS_Shape& shape, const Position& at, double tilt_rad) {
    return turned(shape, {0, 1, 0}, tilt_rad, at);
}

TopoDS_Shape prism_along_y(const std::vector<gp_Pnt>& corners, const std::vector<int>& arc_at,
                           const gp_Circ& outer, const gp_Circ& inner, double width_mm) {
    BRepBuilderAPI_MakeWire wire;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const gp_Pnt& from = corners[i];
        const gp_Pnt& to = corners[(i + 1) % corners.size()];
        if (arc_at[i] == 0) {
            wire.Add(BRepBuilderAPI_MakeEdge(from, to).Edge());
        } else if (arc_at[i] == 1) {
            wire.Add(BRepBuilderAPI_MakeEdge(outer, from, to).Edge());
        } else {
            wire.Add(BRepBuilderAPI_MakeEdge(inner, to, from).Edge());
        }
    }
    const auto face = BRepBuilderAPI_MakeFace(wire.Wire()).Face();
    return BRepPrimAPI_MakePrism(face, gp_Vec(0, width_mm, 0)).Shape();
}

}  // namespace

TopoDS_Shape bracket() {
    using B = Bracket;
    const double bend = B::kBend_deg * kRadPerDeg;
    const double inner_radius = B::kOuterRadius_mm - B::kThickness_mm;
    // About the bend's axis, angles from straight down towards +X.
    const auto at = [&](double radius, double angle, double along) {
        return gp_Pnt(radius * std::sin(angle) + along * std::cos(angle), 0,
                      B::kOuterRadius_mm - radius * std::cos(angle) + along * std::sin(angle));
    };
    const gp_Ax2 axes(gp_Pnt(0, 0, B::kOuterRadius_mm), gp_Dir(0, -1, 0), gp_Dir(0, 0, -1));
    const gp_Circ outer(axes, B::kOuterRadius_mm);
    const gp_Circ inner(axes, inner_radius);
    constexpr double kLevel_mm = 80, kRising_mm = 75;
    const TopoDS_Shape sheet = prism_along_y(
        {at(B::kOuterRadius_mm, 0, -kLevel_mm), at(B::kOuterRadius_mm, 0, 0), at(B::kOuterRadius_mm, bend, 0),
         at(B::kOuterRadius_mm, bend, kRising_mm), at(inner_radius, bend, kRising_mm),
         at(inner_radius, bend, 0), at(inner_radius, 0, 0), at(inner_radius, 0, -kLevel_mm)},
        {0, 1, 0, 0, 0, 2, 0, 0}, outer, inner, B::kWidth_mm);
    const auto on_rising = [&](double along, double y) {
        const gp_Pnt position = at(inner_radius, bend, along);
        return Position{position.X(), y, position.Z()};
    };
    const TopoDS_Shape hole =
        cylinder({B::kHoleX_mm, B::kHoleY_mm, -1}, B::kHoleRadius_mm, B::kThickness_mm + 2);
    const TopoDS_Shape slot = turned(slot_tool(B::kSlotHalf_mm, B::kSlotRadius_mm, 0, 10, 10), {0, 0, 1}, 0,
                                     {B::kSlotX_mm, B::kSlotY_mm, B::kThickness_mm});
    const TopoDS_Shape far =
        placed(cylinder({0, 0, -10}, B::kFarRadius_mm, 20), on_rising(B::kFarAlong_mm, B::kFarY_mm), -bend);
    const double growth = 10 * std::tan(B::kTaper_deg * kRadPerDeg);
    const TopoDS_Shape taper =
        placed(cone({0, 0, -10}, B::kTaperRadius_mm - growth, B::kTaperRadius_mm + growth, 20),
               on_rising(B::kTaperAlong_mm, B::kTaperY_mm), -bend);
    return without(sheet, {hole, slot, far, taper});
}

TopoDS_Shape frustum() {
    using F = Frustum;
    const TopoDS_Shape body = cone({0, 0, 0}, F::kLowerRadius_mm, F::kUpperRadius_mm, F::kHeight_mm);
    const double slope = std::atan2(F::kLowerRadius_mm - F::kUpperRadius_mm, F::kHeight_mm);
    // The same cone, deeper by the wall.
    const double less = F::kWall_mm / std::cos(slope);
    const double over = 5 * std::tan(slope);
    const TopoDS_Shape core = cone({0, 0, -5}, F::kLowerRadius_mm - less + over,
                                   F::kUpperRadius_mm - less - over, F::kHeight_mm + 10);
    const TopoDS_Shape tool = slot_tool(F::kSlotHalf_mm, F::kSlotRadius_mm, F::kTaper_deg, 12, 12);
    const Position middle{(F::kLowerRadius_mm + F::kUpperRadius_mm) / 2, 0, F::kHeight_mm / 2};
    // The side's normal is tilted from the vertical by 90 degrees less its slope.
    return without(body, {core, placed(tool, middle, kTurn_rad / 4 - slope)});
}

}  // namespace gsim::solid::models
