#include "cam/solid/occ/plate_frame.h"

#include <fmt/format.h>

#include "base/text/number.h"

namespace gsim::solid {

namespace {

gp_Dir x_axis(const gp_Dir& up) {
    constexpr double kVerticalLimit = 1 - 1e-6;
    const gp_Dir reference_direction = std::abs(up.X()) > kVerticalLimit ? gp_Dir(0, 1, 0) : gp_Dir(1, 0, 0);
    return up.CrossCrossed(reference_direction, up);
}

gp_Vec position_vector(const gp_Pnt& point) {
    return {point.X(), point.Y(), point.Z()};
}

}  // namespace

PlateFrame::PlateFrame(const gp_Pnt& plane_point, const gp_Dir& up)
    : plane_point_(plane_point), up_(up), x_(x_axis(up)), y_(up.Crossed(x_)) {}

geometry::Point PlateFrame::to_plane(const gp_Vec& vector) const {
    return {vector.Dot(x_), vector.Dot(y_)};
}

geometry::Point PlateFrame::to_plane(const gp_Pnt& point) const {
    return to_plane(position_vector(point));
}

double PlateFrame::height_mm(const gp_Pnt& point) const {
    return gp_Vec(plane_point_, point).Dot(up_);
}

std::string display_text(const gp_Pnt& point) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", text::unsigned_zero(point.X()),
                       text::unsigned_zero(point.Y()), text::unsigned_zero(point.Z()));
}

}  // namespace gsim::solid
