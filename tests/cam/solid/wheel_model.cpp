#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomFill.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Surface.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/cam/solid/part_models.h"
#include "tests/cam/solid/wheel_path.h"

namespace gsim::solid::models {

namespace {

constexpr int kSamples = 17;  // of each side of a wall

gp_Pnt upper(const WheelStep& step, double share) {
    const auto at = step.at(share);
    return {at[0], at[1], 0};
}

gp_Pnt lower(const WheelStep& step, double share) {
    const auto at = step.at(share);
    const auto axis = step.axis(share);
    return {at[0] - kWheelThickness_mm * axis[0] / axis[2], at[1] - kWheelThickness_mm * axis[1] / axis[2],
            -kWheelThickness_mm};
}

template <typename At>
Handle(Geom_BSplineCurve) through(const At& at) {
    const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, kSamples);
    const Handle(TColStd_HArray1OfReal) shares = new TColStd_HArray1OfReal(1, kSamples);
    for (int i = 0; i < kSamples; ++i) {
        const double share = static_cast<double>(i) / (kSamples - 1);
        points->SetValue(i + 1, at(share));
        shares->SetValue(i + 1, share);
    }
    GeomAPI_Interpolate interpolate(points, shares, false, 1e-9);
    // The course beyond the ends is known, too.
    constexpr double kStep = 1e-4;
    const auto slope = [&](double share) {
        return gp_Vec(at(share - kStep), at(share + kStep)) / (2 * kStep);
    };
    interpolate.Load(slope(0), slope(1), false);
    interpolate.Perform();
    return interpolate.Curve();
}

// A contour of the upper side and the one below it, with the walls between them.
struct Pocket {
    BRepBuilderAPI_MakeWire upper, lower;
    std::vector<TopoDS_Face> walls;
};

Pocket pocket(const std::vector<WheelStep>& steps) {
    Pocket made_pocket;
    for (const WheelStep& step : steps) {
        const auto top = through([&](double share) { return upper(step, share); });
        const auto bottom = through([&](double share) { return lower(step, share); });
        made_pocket.upper.Add(BRepBuilderAPI_MakeEdge(top).Edge());
        made_pocket.lower.Add(BRepBuilderAPI_MakeEdge(bottom).Edge());
        made_pocket.walls.push_back(BRepBuilderAPI_MakeFace(GeomFill::Surface(top, bottom), 1e-6).Face());
    }
    return made_pocket;
}

TopoDS_Wire circle(double radius_mm, double z_mm) {
    const gp_Circ round(gp_Ax2(gp_Pnt(0, 0, z_mm), gp_Dir(0, 0, 1)), radius_mm);
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(round).Edge()).Wire();
}

TopoDS_Face round_wall(double radius_mm) {
    const gp_Ax2 axes(gp_Pnt(0, 0, -kWheelThickness_mm), gp_Dir(0, 0, 1));
    return BRepPrimAPI_MakeCylinder(axes, radius_mm, kWheelThickness_mm).Cylinder().LateralFace();
}

TopoDS_Face side(double z_mm, const std::vector<TopoDS_Wire>& holes) {
    BRepBuilderAPI_MakeFace face(gp_Pln(gp_Pnt(0, 0, z_mm), gp_Dir(0, 0, 1)), circle(kRimRadius_mm, z_mm));
    for (const TopoDS_Wire& hole : holes) face.Add(TopoDS::Wire(hole.Reversed()));
    return face.Face();
}

}  // namespace

TopoDS_Shape wheel(const std::filesystem::path& path_file) {
    BRepBuilderAPI_Sewing sewing(1e-4);
    std::vector<TopoDS_Wire> above{circle(kBoreRadius_mm, 0)};
    std::vector<TopoDS_Wire> below{circle(kBoreRadius_mm, -kWheelThickness_mm)};
    for (const auto& steps : wheel_pockets(path_file)) {
        Pocket made_pocket = pocket(steps);
        above.push_back(made_pocket.upper.Wire());
        below.push_back(made_pocket.lower.Wire());
        for (const TopoDS_Face& wall : made_pocket.walls) sewing.Add(wall);
    }
    sewing.Add(side(0, above));
    sewing.Add(side(-kWheelThickness_mm, below));
    sewing.Add(round_wall(kRimRadius_mm));
    sewing.Add(round_wall(kBoreRadius_mm));
    sewing.Perform();
    const TopExp_Explorer shells(sewing.SewedShape(), TopAbs_SHELL);
    EXPECT_TRUE(shells.More() && sewing.NbFreeEdges() == 0);
    TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(shells.Current())).Solid();
    BRepLib::OrientClosedSolid(solid);
    return solid;
}

}  // namespace gsim::solid::models
