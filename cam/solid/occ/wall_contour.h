#pragma once

#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <optional>
#include <string>

#include "base/error.h"
#include "cam/solid/contours.h"
#include "cam/solid/occ/face_loops.h"
#include "cam/solid/occ/shape_file.h"

namespace gsim::solid {

/// Min alignment of a face with a side so that a jet enters from there, -1 to 1.
inline constexpr double kMinFacing = 0.01;

using EdgeFaceMap = TopTools_IndexedDataMapOfShapeListOfShape;

/// An edge between a face that a jet enters and the wall below, with material to the left of its path.
struct ChainEdge {
    WallEdge edge;
    TopoDS_Vertex begin, end;  ///< Ends of its path.
};

/// A walk round a loop of a face's edges, or along one of them, with the walls across them. Errors explain
/// why a jet cannot cut this contour, as the end of a message.
class ContourTracer {
  public:
    ContourTracer(const ShapeFile& file, const TopoDS_Solid& solid, const EdgeFaceMap& edge_faces,
                  const ContourOptions& options)
        : file_(file), solid_(solid), edge_faces_(edge_faces), options_(options) {}

    Result<WallContour> walk(const TopoDS_Face& face, const FaceLoop& loop) const;
    Result<ChainEdge> trace_edge(const TopoDS_Edge& edge, const TopoDS_Face& face) const;
    /// Returns an error if a wall does not pass through.
    static std::optional<Error> find_blind_wall(const WallContour& contour);

  private:
    Result<WallEdge> make_wall_edge(const TopoDS_Edge& edge, const TopoDS_Face& face) const;
    double next_surface_mm(const WallEdge& edge) const;

    const ShapeFile& file_;
    const TopoDS_Solid& solid_;
    const EdgeFaceMap& edge_faces_;
    const ContourOptions& options_;
};

}  // namespace gsim::solid
