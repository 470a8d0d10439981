#pragma once

#include "geometry/planar/point.h"

namespace gsim::drawing {

/// An affine map of the plane: the images of the unit vectors and of the origin.
struct Affine {
    geometry::Point x{1, 0}, y{0, 1}, origin{0, 0};

    geometry::Point direction(geometry::Point v) const { return v.x * x + v.y * y; }
    geometry::Point operator()(geometry::Point p) const { return origin + direction(p); }
    /// Returns the map that applies `first`, then this.
    Affine operator*(const Affine& first) const {
        return {direction(first.x), direction(first.y), (*this)(first.origin)};
    }
};

inline Affine scaled(double x, double y) {
    return {{x, 0}, {0, y}, {0, 0}};
}
inline Affine moved(geometry::Point by) {
    return {{1, 0}, {0, 1}, by};
}
inline Affine turned(double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    return {{c, s}, {-s, c}, {0, 0}};
}

}  // namespace gsim::drawing
