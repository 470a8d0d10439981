#pragma once

#include <algorithm>
#include <cmath>

namespace gsim::geometry {

/// A point or a vector of the plane, in mm.
struct Point {
    double x = 0, y = 0;

    bool operator==(const Point&) const = default;
};

inline Point operator+(Point a, Point b) {
    return {a.x + b.x, a.y + b.y};
}
inline Point operator-(Point a, Point b) {
    return {a.x - b.x, a.y - b.y};
}
inline Point operator*(double factor, Point a) {
    return {factor * a.x, factor * a.y};
}
inline double dot(Point a, Point b) {
    return a.x * b.x + a.y * b.y;
}
/// Returns a value above 0 if b is to the left of a.
inline double cross(Point a, Point b) {
    return a.x * b.y - a.y * b.x;
}
inline double length(Point a) {
    return std::hypot(a.x, a.y);
}
inline double distance(Point a, Point b) {
    return length(b - a);
}
/// Returns the same vector, a quarter turn to the left.
inline Point left_normal(Point a) {
    return {-a.y, a.x};
}
inline Point right_normal(Point a) {
    return {a.y, -a.x};
}
/// Returns the vector with length 1; a vector without a length stays as it is.
inline Point unit(Point a) {
    const double size = length(a);
    return size > 0 ? (1 / size) * a : a;
}
inline bool is_finite(Point a) {
    return std::isfinite(a.x) && std::isfinite(a.y);
}

/// An upright rectangle with its edges; empty until something is added.
struct Box {
    Point low{HUGE_VAL, HUGE_VAL};
    Point high{-HUGE_VAL, -HUGE_VAL};

    bool empty() const { return low.x > high.x; }
    void add(Point p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    void add(const Box& other) {
        low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
        high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
    }
    Box expanded(double by) const { return {{low.x - by, low.y - by}, {high.x + by, high.y + by}}; }
    bool overlaps(const Box& other) const {
        return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
               other.low.y <= high.y;
    }
};

}  // namespace gsim::geometry
