#include "cam/solid/occ/face_loops.h"

#include <BRepAdaptor_Curve2d.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>

namespace gsim::solid {

namespace {

struct WireEdges {
    std::vector<TopoDS_Edge> edges;
    bool has_seam = false;
};

WireEdges wire_edges(const TopoDS_Shape& wire, const TopoDS_Face& face) {
    WireEdges found;
    for (TopExp_Explorer edges(wire, TopAbs_EDGE); edges.More(); edges.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
        if (BRep_Tool::IsClosed(edge, face)) {
            found.has_seam = true;
        } else if (!BRep_Tool::Degenerated(edge)) {
            found.edges.push_back(edge);
        }
    }
    return found;
}

// Removes a loop from the edges; edges that do not close are not a loop.
std::vector<TopoDS_Edge> take_loop(std::vector<TopoDS_Edge>& remainder) {
    std::vector<TopoDS_Edge> loop{remainder.back()};
    remainder.pop_back();
    const TopoDS_Vertex start = TopExp::FirstVertex(loop.front(), true);
    TopoDS_Vertex end = TopExp::LastVertex(loop.front(), true);
    while (!end.IsSame(start)) {
        auto next = remainder.begin();
        while (next != remainder.end() && !TopExp::FirstVertex(*next, true).IsSame(end)) ++next;
        if (next == remainder.end()) return {};
        loop.push_back(*next);
        end = TopExp::LastVertex(*next, true);
        remainder.erase(next);
    }
    return loop;
}

// Returns true if a loop runs round a face that is closed in itself: then its parameters do not return to
// their start.
bool wraps_around(const std::vector<TopoDS_Edge>& loop, const TopoDS_Face& face) {
    double u = 0;
    double v = 0;
    for (const TopoDS_Edge& edge : loop) {
        const BRepAdaptor_Curve2d curve(edge, face);
        const double sense = edge.Orientation() == TopAbs_REVERSED ? -1 : 1;
        const gp_Pnt2d from = curve.Value(curve.FirstParameter());
        const gp_Pnt2d to = curve.Value(curve.LastParameter());
        u += sense * (to.X() - from.X());
        v += sense * (to.Y() - from.Y());
    }
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    const auto is_full_period = [](double distance, bool closed, double low, double high) {
        return closed && std::abs(distance) > (high - low) / 2;
    };
    double u_low = 0, u_high = 0, v_low = 0, v_high = 0;
    surface->Bounds(u_low, u_high, v_low, v_high);
    return is_full_period(u, surface->IsUClosed(), u_low, u_high) ||
           is_full_period(v, surface->IsVClosed(), v_low, v_high);
}

}  // namespace

std::vector<FaceLoop> face_loops(const TopoDS_Face& face) {
    std::vector<FaceLoop> loops;
    const TopoDS_Wire outer = BRepTools::OuterWire(face);
    for (TopExp_Explorer wires(face, TopAbs_WIRE); wires.More(); wires.Next()) {
        WireEdges open = wire_edges(wires.Current(), face);
        const bool is_outer = wires.Current().IsSame(outer);
        while (!open.edges.empty()) {
            auto loop = take_loop(open.edges);
            if (loop.empty()) continue;
            const bool is_hole = open.has_seam ? !wraps_around(loop, face) : !is_outer;
            loops.push_back({std::move(loop), is_hole});
        }
    }
    return loops;
}

}  // namespace gsim::solid
