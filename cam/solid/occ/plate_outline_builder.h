#pragma once

#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Solid.hxx>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "cam/solid/occ/outline_pen.h"
#include "cam/solid/occ/plate_frame.h"
#include "cam/solid/occ/shape_file.h"
#include "cam/solid/plate.h"

namespace gsim::solid {

/// Returns the upper side of plates: the plane of the largest plane face among them that the options allow.
/// If several faces have this size, it is the one that faces along Z, then Y, then X the most.
Result<PlateFrame> find_plate(std::span<const TopoDS_Solid> solids, const PlateOptions& options);

/// A collector for the outlines of bodies in a plate; all lie in one plane and have one thickness.
class PlateOutlineBuilder {
  public:
    PlateOutlineBuilder(const ShapeFile& file, const PlateFrame& frame, double tolerance_mm, Plate& plate)
        : file_(file), frame_(frame), plate_(plate), pen_(frame, tolerance_mm, plate.drawing) {}

    /// Adds a body.
    Result<void> add(const TopoDS_Solid& solid);

  private:
    using Neighbours = TopTools_IndexedDataMapOfShapeListOfShape;

    Result<void> sort_faces(const TopoDS_Solid& solid);
    Result<void> find_thickness();
    Result<void> draw_face(const TopoDS_Face& face, const Neighbours& edge_faces);
    Result<void> draw_edge(const TopoDS_Edge& edge, const TopoDS_Face& side);
    Result<void> reject(const TopoDS_Face& face, const std::string& what) const;

    const ShapeFile& file_;
    const PlateFrame& frame_;
    Plate& plate_;
    OutlinePen pen_;
    std::vector<TopoDS_Face> upper_, lower_, other_faces_;  // of the body at hand
    std::vector<double> depths_mm_;                         // of lower_, below the upper side
};

}  // namespace gsim::solid
