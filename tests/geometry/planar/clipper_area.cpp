#include "tests/geometry/planar/clipper_area.h"

#include <polyclipping/clipper.hpp>

#include "tests/geometry/planar/shapes.h"

namespace gsim::geometry {

namespace {

constexpr double kPerMm = 1e6;

}  // namespace

double clipper_offset_area_mm2(const Contour& contour, double distance_mm, double tolerance_mm) {
    ClipperLib::Path path;
    for (const Point& point : flattened(contour, tolerance_mm)) {
        path << ClipperLib::IntPoint(static_cast<ClipperLib::cInt>(point.x * kPerMm),
                                     static_cast<ClipperLib::cInt>(point.y * kPerMm));
    }
    ClipperLib::ClipperOffset clipper(2, tolerance_mm * kPerMm);
    clipper.AddPath(path, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
    ClipperLib::Paths result;
    clipper.Execute(result, distance_mm * kPerMm);
    double area = 0;
    for (const ClipperLib::Path& one : result) area += ClipperLib::Area(one);
    return area / (kPerMm * kPerMm);
}

}  // namespace gsim::geometry
