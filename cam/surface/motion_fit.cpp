#include "cam/surface/motion_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "cam/surface/jet_path.h"
#include "cam/surface/vertical_points.h"

namespace gsim::surface {

namespace {

constexpr double kStationary_mm = 1e-6;
constexpr double kMaxFitSweep_rad = 200 * kRadPerDeg;
constexpr double kMaxFitRadius_mm = 1e5;
constexpr double kAxisTolerance = 1e-9;
constexpr double kVerticalTilt_rad = 1e-7;
constexpr int kMaxHalvings = 9;

struct Circle {
    Vector center, normal;
    double radius_mm = 0;
};

std::optional<Circle> circle_through(const Vector& a, const Vector& b, const Vector& c) {
    const Vector ab = b - a;
    const Vector ac = c - a;
    const Vector normal = ab.cross(ac);
    const double size = normal.squaredNorm();
    if (size <= 1e-16 * ab.squaredNorm() * ac.squaredNorm()) return std::nullopt;
    const Vector offset =
        (ac.squaredNorm() * normal.cross(ab) + ab.squaredNorm() * ac.cross(normal)) / (2 * size);
    if (offset.norm() > kMaxFitRadius_mm) return std::nullopt;
    return Circle{a + offset, normal / std::sqrt(size), offset.norm()};
}

// Returns true if an axis that turns in proportion about the vertical and away from it deviates from the
// straight turn between two points.
bool deviates_from_arc(const JetPoint& a, const JetPoint& b, double tolerance_mm) {
    const double first_tilt = tilt_rad(a.axis);
    const double last_tilt = tilt_rad(b.axis);
    if (std::min(first_tilt, last_tilt) < kVerticalTilt_rad) return false;
    const double first = azimuth_rad(a.axis);
    const double turn = std::remainder(azimuth_rad(b.axis) - first, kTurn_rad);
    const Vector interpolated_axis = axis_direction(first + turn / 2, (first_tilt + last_tilt) / 2);
    const Vector straight = (a.axis + b.axis).normalized();
    return (interpolated_axis - straight).norm() * std::max({a.depth_mm, b.depth_mm, 1.0}) > tolerance_mm;
}

void subdivide(const JetPoint& a, const JetPoint& b, double tolerance_mm, int depth,
               std::vector<JetPoint>& points) {
    if (depth < kMaxHalvings && deviates_from_arc(a, b, tolerance_mm)) {
        JetPoint middle = between(a, b, 0.5);
        middle.edge = b.edge;
        subdivide(a, middle, tolerance_mm, depth + 1, points);
        subdivide(middle, b, tolerance_mm, depth + 1, points);
        return;
    }
    points.push_back(b);
}

// Adds points near the upright orientation, because the turn about the vertical is fast there.
std::vector<JetPoint> refine_near_vertical(std::span<const JetPoint> points, double tolerance_mm) {
    std::vector<JetPoint> close;
    if (points.empty()) return close;
    close.push_back(points.front());
    for (std::size_t i = 1; i < points.size(); ++i)
        subdivide(points[i - 1], points[i], tolerance_mm, 0, close);
    return close;
}

class MoveFitter {
  public:
    MoveFitter(std::span<const JetPoint> points, const JetShape& jet, const FitTolerance& tolerance)
        : points_(points), tolerance_(tolerance) {
        for (const JetPoint& at : points) add(at, jet);
    }

    std::vector<JetMove> run() {
        std::vector<JetMove> moves;
        for (std::size_t from = 0; from + 1 < points_.size();) {
            const std::size_t to = farthest(from);
            moves.push_back(move(from, to));
            from = to;
        }
        return moves;
    }

  private:
    void add(const JetPoint& at, const JetShape& jet) {
        tips_.push_back(tcp_position(at, jet));
        const double tilt = tilt_rad(at.axis);
        double azimuth = azimuth_rad(at.axis);
        if (!azimuth_.empty()) {
            const double before = azimuth_.back();
            azimuth =
                tilt < kVerticalTilt_rad ? before : before + std::remainder(azimuth - before, kTurn_rad);
        }
        azimuth_.push_back(azimuth);
        tilt_.push_back(tilt);
        distance_mm_.push_back(
            distance_mm_.empty() ? 0 : distance_mm_.back() + (tips_.back() - tips_[tips_.size() - 2]).norm());
    }

    // Returns the last point that one move can reach, found by doubling and halving.
    std::size_t farthest(std::size_t from) const {
        std::size_t fitting_end = from + 1;
        if (distance_mm_[fitting_end] - distance_mm_[from] < kStationary_mm) return fitting_end;
        std::size_t step = 2;
        std::size_t bad = 0;
        while (bad == 0) {
            const std::size_t to = std::min(from + step, points_.size() - 1);
            if (to == fitting_end) return fitting_end;
            if (!fits_one_move(from, to))
                bad = to;
            else if (to == points_.size() - 1)
                return to;
            else
                fitting_end = to;
            step *= 2;
        }
        while (bad - fitting_end > 1) {
            const std::size_t middle = (fitting_end + bad) / 2;
            (fits_one_move(from, middle) ? fitting_end : bad) = middle;
        }
        return fitting_end;
    }

    bool fits_one_move(std::size_t from, std::size_t to) const {
        for (std::size_t i = from; i < to; ++i) {
            const bool is_stationary = distance_mm_[i + 1] - distance_mm_[i] < kStationary_mm;
            if (i > from && points_[i].is_fixed) return false;
            if (is_stationary || points_[i + 1].edge != points_[from + 1].edge) return false;
        }
        return is_axis_within_tolerance(from, to) && (is_line(from, to) || arc(from, to).has_value());
    }

    bool is_axis_within_tolerance(std::size_t from, std::size_t to) const {
        for (std::size_t i = from + 1; i < to; ++i) {
            const double share =
                (distance_mm_[i] - distance_mm_[from]) / (distance_mm_[to] - distance_mm_[from]);
            const Vector axis = axis_direction(azimuth_[from] + share * (azimuth_[to] - azimuth_[from]),
                                               tilt_[from] + share * (tilt_[to] - tilt_[from]));
            const double reach_mm = std::max(points_[i].depth_mm, 1.0);
            if ((axis - points_[i].axis).norm() * reach_mm > tolerance_.wall_mm) return false;
        }
        return true;
    }

    bool is_line(std::size_t from, std::size_t to) const {
        const Vector chord = tips_[to] - tips_[from];
        for (std::size_t i = from + 1; i < to; ++i) {
            const double offset = chord.cross(tips_[i] - tips_[from]).norm();
            if (offset > tolerance_.tcp_mm * chord.norm()) return false;
        }
        return chord.norm() > kStationary_mm;
    }

    std::optional<Circle> arc(std::size_t from, std::size_t to) const {
        auto circle = circle_through(tips_[from], tips_[(from + to) / 2], tips_[to]);
        if (!circle || distance_mm_[to] - distance_mm_[from] > kMaxFitSweep_rad * circle->radius_mm)
            return std::nullopt;
        for (std::size_t i = from; i <= to; ++i) {
            const Vector offset = tips_[i] - circle->center;
            const double above = offset.dot(circle->normal);
            const double radial = (offset - above * circle->normal).norm() - circle->radius_mm;
            if (std::hypot(above, radial) > tolerance_.tcp_mm) return std::nullopt;
        }
        return circle;
    }

    // Returns the midpoint of the arc, on the side of its points.
    Vector arc_midpoint(const Circle& circle, std::size_t from, std::size_t to) const {
        const Vector begin = tips_[from] - circle.center;
        Vector out = (begin + tips_[to] - circle.center);
        const Vector middle = tips_[(from + to) / 2] - circle.center;
        if (out.norm() < 1e-6 * circle.radius_mm) out = circle.normal.cross(begin);
        if (out.dot(middle) < 0) out = -out;
        return circle.center + circle.radius_mm * out.normalized();
    }

    JetMove move(std::size_t from, std::size_t to) const {
        JetMove found;
        found.end_mm = tips_[to];
        found.axis = points_[to].axis;
        found.tcp_mm = distance_mm_[to] - distance_mm_[from];
        found.axis_changes = (points_[to].axis - points_[from].axis).norm() > kAxisTolerance;
        found.corner_rad = points_[from].corner_rad;
        found.depth_mm = points_[from].depth_mm;
        for (std::size_t i = from; i < to; ++i)
            found.depth_mm = std::max(found.depth_mm, points_[i + 1].depth_mm);
        for (std::size_t i = from; i < to; ++i)
            found.edge_mm += (points_[i + 1].edge_mm - points_[i].edge_mm).norm();
        if (to - from < 2 || is_line(from, to)) return found;
        const auto circle = arc(from, to);
        if (!circle) return found;
        found.via_mm = arc_midpoint(*circle, from, to);
        found.radius_mm = circle->radius_mm;
        return found;
    }

    std::span<const JetPoint> points_;
    const FitTolerance& tolerance_;
    std::vector<Vector> tips_;
    std::vector<double> azimuth_, tilt_, distance_mm_;
};

}  // namespace

std::vector<JetMove> fit_moves(std::span<const JetPoint> points, const JetShape& jet,
                               const FitTolerance& tolerance) {
    const std::vector<JetPoint> close = refine_near_vertical(points, tolerance.wall_mm / 3);
    return MoveFitter(close, jet, tolerance).run();
}

}  // namespace gsim::surface
