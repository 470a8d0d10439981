#include "tests/conformance/canon_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gsim::conformance {

namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180;

void add(PrintedPoint& point, const PrintedPoint& offset) {
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        point.at[axis] += offset.at[axis];
        point.tolerance[axis] += offset.tolerance[axis];
    }
}

}  // namespace

PrintedPoint CanonFrame::offset(std::span<const double> values) const {
    PrintedPoint point;
    for (std::size_t axis = 0; axis < std::min(values.size(), kAxisCount); ++axis) {
        const double unit = axis < kLinearAxes ? unit_mm_ : 1;
        point.at[axis] = values[axis] * unit;
        if (values[axis] != 0) point.tolerance[axis] = kPrinted * unit;
    }
    return point;
}

PrintedPoint CanonFrame::to_machine(const AxisValues& printed) const {
    PrintedPoint point = offset(printed);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        point.tolerance[axis] = kPrinted * (axis < kLinearAxes ? unit_mm_ : 1);
    }
    add(point, g92_);
    if (rotation_deg_ != 0) rotate(point);
    add(point, work_);
    add(point, tool_);
    return point;
}

Vector CanonFrame::turned(const Vector& direction) const {
    const double cosine = std::cos(rotation_deg_ * kRadPerDeg);
    const double sine = std::sin(rotation_deg_ * kRadPerDeg);
    return {direction[0] * cosine - direction[1] * sine, direction[0] * sine + direction[1] * cosine,
            direction[2]};
}

void CanonFrame::rotate(PrintedPoint& point) const {
    const double cosine = std::cos(rotation_deg_ * kRadPerDeg);
    const double sine = std::sin(rotation_deg_ * kRadPerDeg);
    const double x = point.at[0];
    const double y = point.at[1];
    const double turned = std::hypot(x, y) * kPrinted * kRadPerDeg;  // by the digits of the angle
    const double across = std::hypot(point.tolerance[0], point.tolerance[1]) + turned;
    point.at[0] = x * cosine - y * sine;
    point.at[1] = x * sine + y * cosine;
    point.tolerance[0] = point.tolerance[1] = across;
}

}  // namespace gsim::conformance
