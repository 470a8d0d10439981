#pragma once

#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopoDS_Edge.hxx>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "cam/solid/occ/shape_file.h"

namespace gsim::solid {

/// Returns true if edges lie in a box, given by its low corner and its high one.
bool is_within_box(const std::vector<TopoDS_Edge>& edges, const std::array<double, 6>& box_mm);

/// The edges requested by their numbers in a file, and the result for each.
class EdgeSelection {
  public:
    EdgeSelection(const ShapeFile& file, const std::vector<std::string>& numbers)
        : file_(file), numbers_(numbers) {}

    /// Returns true if none is requested, so any edge is accepted.
    bool accepts_any() const { return numbers_.empty(); }
    /// Searches for them in a body, and returns those found.
    std::vector<TopoDS_Edge> find_edges_in(const TopoDS_Shape& body);
    /// Returns true if one of them is among these, or any is accepted.
    bool accepts(const std::vector<TopoDS_Edge>& edges) const;
    void mark_cut(const std::vector<TopoDS_Edge>& edges);
    /// Stores the message why a contour of these edges is not cut.
    void mark_rejected(const std::vector<TopoDS_Edge>& edges, const std::string& reason);
    /// Returns an error for the first one that is not in the file or not on a contour that is cut.
    std::optional<Error> find_error() const;

  private:
    struct EdgeMatch {
        std::string label;
        bool is_cut = false;
        std::string error = {};
    };
    bool is_requested(const std::string& label) const;

    const ShapeFile& file_;
    const std::vector<std::string>& numbers_;
    std::vector<EdgeMatch> found_;
    TopTools_DataMapOfShapeInteger indices_;  ///< Indices of edges in found_.
};

}  // namespace gsim::solid
