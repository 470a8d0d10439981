#include "cam/solid/occ/plate_frame.h"

#include <fmt/format.h>

#include "base/text/number.h"

namespace gsim::solid {

namespace {

gp_Dir x_axis(const gp_Dir& up) {
    constexpr double kUpright = 1 - 1e-6;
    const gp_Dir along = std::abs(up.X()) > kUpright ? gp_Dir(0, 1, 0) : gp_Dir(1, 0, 0);
    return up.CrossCrossed(along, up);
}

gp_Vec from_origin(const gp_Pnt& point) {
    return {point.X(), point.Y(), point.Z()};
}

}  // namespace

PlateFrame::PlateFrame(const gp_Pnt& on_plane, const gp_Dir& up)
    : on_plane_(on_plane), up_(up), x_(x_axis(up)), y_(up.Crossed(x_)) {}

geometry::Point PlateFrame::in_plane(const gp_Vec& vector) const {
    return {vector.Dot(x_), vector.Dot(y_)};
}

geometry::Point PlateFrame::in_plane(const gp_Pnt& point) const {
    return in_plane(from_origin(point));
}

double PlateFrame::height_mm(const gp_Pnt& point) const {
    return gp_Vec(on_plane_, point).Dot(up_);
}

std::string shown(const gp_Pnt& point) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", text::unsigned_zero(point.X()),
                       text::unsigned_zero(point.Y()), text::unsigned_zero(point.Z()));
}

}  // namespace gsim::solid
