#pragma once

// Solids and the files they are written to, by OpenCASCADE itself.

#include <TopoDS_Shape.hxx>
#include <array>
#include <filesystem>
#include <gp_Pnt.hxx>
#include <string>
#include <vector>

#include "tests/conformance/scratch_folder.h"

namespace gsim::solid {

using Position = std::array<double, 3>;

/// A box between two corners.
TopoDS_Shape box(const Position& low, const Position& high);
/// Upright, from its lower end on.
TopoDS_Shape cylinder(const Position& foot, double radius, double height);
TopoDS_Shape cone(const Position& foot, double lower_radius, double upper_radius, double height);
TopoDS_Shape sphere(const Position& middle, double radius);
/// An upright body between two polygons of as many corners; its sides are ruled between them.
TopoDS_Shape loft(const std::vector<Position>& lower, const std::vector<Position>& upper);
/// A rectangle and another one above it, both about a middle: a box with bevels.
TopoDS_Shape frustum(const Position& foot, double lower_x, double lower_y, double upper_x, double upper_y,
                     double height);
/// Upright, from an ellipse along X and Y.
TopoDS_Shape elliptic_cylinder(const Position& foot, double x_radius, double y_radius, double height);
TopoDS_Shape without(const TopoDS_Shape& body, const std::vector<TopoDS_Shape>& tools);
/// The plane face of the largest area.
TopoDS_Shape largest_face(const TopoDS_Shape& shape);
/// The edges alone, each once.
TopoDS_Shape edges_of(const TopoDS_Shape& shape);
/// The same with all surfaces and curves as splines.
TopoDS_Shape as_splines(const TopoDS_Shape& shape);
TopoDS_Shape together(const std::vector<TopoDS_Shape>& shapes);
/// Turned about an axis through the origin, then moved.
TopoDS_Shape turned(const TopoDS_Shape& shape, const Position& axis, double angle_rad,
                    const Position& by = {});

/// A folder for files of one test.
class SolidFolder {
  public:
    SolidFolder();

    std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        return folder_.write(name, text);
    }
    /// A unit as OpenCASCADE calls it: "MM", "INCH", "M".
    std::filesystem::path step(const std::string& name, const TopoDS_Shape& shape,
                               const std::string& unit = "MM") const;
    /// As one solid, or as the faces by themselves.
    std::filesystem::path iges(const std::string& name, const TopoDS_Shape& shape,
                               const std::string& unit = "MM", bool as_solid = true) const;

  private:
    conformance::ScratchFolder folder_;
};

std::string read_file(const std::filesystem::path& path);

}  // namespace gsim::solid
