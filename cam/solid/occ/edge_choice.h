#pragma once

#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopoDS_Edge.hxx>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cam/solid/occ/shape_file.h"

namespace gsim::solid {

/// Whether edges lie in a box, given by its low corner and its high one.
bool lies_within(const std::vector<TopoDS_Edge>& edges, const std::array<double, 6>& box_mm);

/// The edges that are asked for by their numbers in a file, and what becomes of each.
class EdgeChoice {
  public:
    EdgeChoice(const ShapeFile& file, const std::vector<std::string>& numbers)
        : file_(file), numbers_(numbers) {}

    /// None is asked for: any edge will do.
    bool takes_any() const { return numbers_.empty(); }
    /// Looks for them in a body, and gives those that are in it.
    std::vector<TopoDS_Edge> find_in(const TopoDS_Shape& body);
    /// Whether one of them is among these, or any will do.
    bool takes(const std::vector<TopoDS_Edge>& edges) const;
    void mark_cut(const std::vector<TopoDS_Edge>& edges);
    /// Why a contour of these edges is none that is cut, in a sentence.
    void mark_refused(const std::vector<TopoDS_Edge>& edges, const std::string& why);
    /// The first one that the file has not, or that is of no contour that is cut, in a sentence.
    std::optional<std::string> find_fault() const;

  private:
    struct Found {
        std::string label;
        bool is_cut = false;
        std::string refusal = {};
    };
    bool is_asked_for(const std::string& label) const;

    const ShapeFile& file_;
    const std::vector<std::string>& numbers_;
    std::vector<Found> found_;
    TopTools_DataMapOfShapeInteger indices_;  ///< Of edges, in found_.
};

}  // namespace gsim::solid
