#pragma once

#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Solid.hxx>
#include <string>

#include <tl/expected.hpp>

#include "cam/solid/contours.h"
#include "cam/solid/occ/face_loops.h"
#include "cam/solid/occ/shape_file.h"

namespace gsim::solid {

using FacesOfEdges = TopTools_IndexedDataMapOfShapeListOfShape;

/// Walks round a loop of a face's edges, with the walls across them. Errors say why it is no contour that a
/// jet could cut, as the end of a sentence.
class ContourWalk {
  public:
    ContourWalk(const ShapeFile& file, const TopoDS_Solid& solid, const FacesOfEdges& faces_of,
                const ContourOptions& options)
        : file_(file), solid_(solid), faces_of_(faces_of), options_(options) {}

    tl::expected<WallContour, std::string> walk(const TopoDS_Face& face, const FaceLoop& loop) const;

  private:
    tl::expected<WallEdge, std::string> edge_of(const TopoDS_Edge& edge, const TopoDS_Face& face) const;
    double behind_mm(const WallEdge& edge) const;

    const ShapeFile& file_;
    const TopoDS_Solid& solid_;
    const FacesOfEdges& faces_of_;
    const ContourOptions& options_;
};

}  // namespace gsim::solid
