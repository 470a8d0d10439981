#include "cam/solid/occ/plate_bodies.h"

#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>

namespace gsim::solid {

namespace {

constexpr double kSewingTolerance_mm = 0.01;  // between the edges of neighbours

void add_solid(TopoDS_Solid solid, Bodies& bodies) {
    BRepLib::OrientClosedSolid(solid);
    bodies.solids.push_back(solid);
}

void add_faces(const TopoDS_Shape& shape, Bodies& bodies) {
    for (TopExp_Explorer faces(shape, TopAbs_FACE, TopAbs_SOLID); faces.More(); faces.Next())
        bodies.faces.push_back(TopoDS::Face(faces.Current()));
}

// Searches for closed shells among faces, sewn if their edges meet.
void sew(Bodies& bodies) {
    if (bodies.faces.empty()) return;
    BRepBuilderAPI_Sewing sewing(kSewingTolerance_mm);
    for (const TopoDS_Face& face : bodies.faces) sewing.Add(face);
    sewing.Perform();
    const TopoDS_Shape sewn_shape = sewing.SewedShape();
    bodies.faces.clear();
    for (TopExp_Explorer shells(sewn_shape, TopAbs_SHELL); shells.More(); shells.Next()) {
        const TopoDS_Shell& shell = TopoDS::Shell(shells.Current());
        if (BRep_Tool::IsClosed(shell)) {
            add_solid(BRepBuilderAPI_MakeSolid(shell).Solid(), bodies);
        } else {
            add_faces(shell, bodies);
        }
    }
    for (TopExp_Explorer faces(sewn_shape, TopAbs_FACE, TopAbs_SHELL); faces.More(); faces.Next())
        bodies.faces.push_back(TopoDS::Face(faces.Current()));
}

}  // namespace

Bodies sort_bodies(const TopoDS_Shape& shape) {
    Bodies bodies;
    for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next())
        add_solid(TopoDS::Solid(solids.Current()), bodies);
    add_faces(shape, bodies);
    sew(bodies);
    TopTools_MapOfShape known;
    for (TopExp_Explorer edges(shape, TopAbs_EDGE, TopAbs_FACE); edges.More(); edges.Next()) {
        if (known.Add(edges.Current())) bodies.edges.push_back(TopoDS::Edge(edges.Current()));
    }
    return bodies;
}

}  // namespace gsim::solid
