#include "tests/cam/solid/solids.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepGProp.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <fstream>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Elips.hxx>
#include <gp_Trsf.hxx>
#include <sstream>

#include <gtest/gtest.h>

// OpenCASCADE leaks; LeakSanitizer calls this function for what it must not report.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libTK";
}

namespace gsim::solid {

namespace {

gp_Pnt at(const Position& position) {
    return {position[0], position[1], position[2]};
}

gp_Ax2 upright(const Position& foot) {
    return {at(foot), gp_Dir(0, 0, 1)};
}

// The writers print a page of statistics.
void redirect_output() {
    Message::DefaultMessenger()->ChangePrinters().Clear();
}

}  // namespace

TopoDS_Shape box(const Position& low, const Position& high) {
    return BRepPrimAPI_MakeBox(at(low), at(high)).Shape();
}

TopoDS_Shape cylinder(const Position& foot, double radius, double height) {
    return BRepPrimAPI_MakeCylinder(upright(foot), radius, height).Shape();
}

TopoDS_Shape cone(const Position& foot, double lower_radius, double upper_radius, double height) {
    return BRepPrimAPI_MakeCone(upright(foot), lower_radius, upper_radius, height).Shape();
}

TopoDS_Shape sphere(const Position& middle, double radius) {
    return BRepPrimAPI_MakeSphere(at(middle), radius).Shape();
}

TopoDS_Shape loft(const std::vector<Position>& lower, const std::vector<Position>& upper) {
    BRepOffsetAPI_ThruSections sections(true, true);
    for (const std::vector<Position>& corners : {lower, upper}) {
        BRepBuilderAPI_MakePolygon polygon;
        for (const Position& corner : corners) polygon.Add(at(corner));
        polygon.Close();
        sections.AddWire(polygon.Wire());
    }
    return sections.Shape();
}

TopoDS_Shape frustum(const Position& foot, double lower_x, double lower_y, double upper_x, double upper_y,
                     double height) {
    const auto rectangle = [&](double x, double y, double z) {
        return std::vector<Position>{{foot[0] - x / 2, foot[1] - y / 2, z},
                                     {foot[0] + x / 2, foot[1] - y / 2, z},
                                     {foot[0] + x / 2, foot[1] + y / 2, z},
                                     {foot[0] - x / 2, foot[1] + y / 2, z}};
    };
    return loft(rectangle(lower_x, lower_y, foot[2]), rectangle(upper_x, upper_y, foot[2] + height));
}

TopoDS_Shape elliptic_cylinder(const Position& foot, double x_radius, double y_radius, double height) {
    const bool along_x = x_radius >= y_radius;
    const gp_Ax2 axes(at(foot), gp_Dir(0, 0, 1), along_x ? gp_Dir(1, 0, 0) : gp_Dir(0, 1, 0));
    const gp_Elips ellipse(axes, std::max(x_radius, y_radius), std::min(x_radius, y_radius));
    const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(ellipse).Edge());
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire).Face(), gp_Vec(0, 0, height)).Shape();
}

TopoDS_Shape without(const TopoDS_Shape& body, const std::vector<TopoDS_Shape>& tools) {
    TopoDS_Shape remainder = body;
    for (const TopoDS_Shape& tool : tools) remainder = BRepAlgoAPI_Cut(remainder, tool).Shape();
    return remainder;
}

TopoDS_Shape largest_face(const TopoDS_Shape& shape) {
    TopoDS_Shape largest;
    double max = 0;
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(faces.Current(), properties);
        if (properties.Mass() <= max) continue;
        max = properties.Mass();
        largest = faces.Current();
    }
    return largest;
}

TopoDS_Shape edges_of(const TopoDS_Shape& shape) {
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    std::vector<TopoDS_Shape> list(edges.cbegin(), edges.cend());
    return together(list);
}

TopoDS_Shape as_splines(const TopoDS_Shape& shape) {
    return BRepBuilderAPI_NurbsConvert(shape).Shape();
}

TopoDS_Shape together(const std::vector<TopoDS_Shape>& shapes) {
    TopoDS_Compound compound;
    const BRep_Builder builder;
    builder.MakeCompound(compound);
    for (const TopoDS_Shape& shape : shapes) builder.Add(compound, shape);
    return compound;
}

TopoDS_Shape turned(const TopoDS_Shape& shape, const Position& axis, double angle_rad, const Position& by) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(axis[0], axis[1], axis[2])), angle_rad);
    gp_Trsf move;
    move.SetTranslation(gp_Vec(by[0], by[1], by[2]));
    return BRepBuilderAPI_Transform(shape, move * turn, true).Shape();
}

SolidFolder::SolidFolder() {
    redirect_output();
}

std::filesystem::path SolidFolder::step(const std::string& name, const TopoDS_Shape& shape,
                                        const std::string& unit) const {
    STEPControl_Controller::Init();
    Interface_Static::SetCVal("write.step.unit", unit.c_str());
    STEPControl_Writer writer;
    EXPECT_EQ(writer.Transfer(shape, STEPControl_AsIs), IFSelect_RetDone);
    EXPECT_EQ(writer.Write(path(name).c_str()), IFSelect_RetDone);
    return path(name);
}

std::filesystem::path SolidFolder::iges(const std::string& name, const TopoDS_Shape& shape,
                                        const std::string& unit, bool as_solid) const {
    IGESControl_Controller::Init();
    IGESControl_Writer writer(unit.c_str(), as_solid ? 1 : 0);
    EXPECT_TRUE(writer.AddShape(shape));
    writer.ComputeModel();
    EXPECT_TRUE(writer.Write(path(name).c_str()));
    return path(name);
}

std::string read_file(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return std::move(text).str();
}

}  // namespace gsim::solid
