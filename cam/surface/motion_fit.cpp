#include "cam/surface/motion_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "cam/surface/jet_way.h"
#include "cam/surface/upright.h"

namespace gsim::surface {

namespace {

constexpr double kStands_mm = 1e-6;
constexpr double kMostSweep_rad = 200 * kRadPerDeg;
constexpr double kMostRadius_mm = 1e5;
constexpr double kSameAxis = 1e-9;
constexpr double kUprightLean_rad = 1e-7;
constexpr int kMostHalvings = 9;

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
    const Vector off =
        (ac.squaredNorm() * normal.cross(ab) + ab.squaredNorm() * ac.cross(normal)) / (2 * size);
    if (off.norm() > kMostRadius_mm) return std::nullopt;
    return Circle{a + off, normal / std::sqrt(size), off.norm()};
}

// Returns true if an axis that turns in proportion about the vertical and away from it deviates from the
// straight turn between two points.
bool swings(const JetPoint& a, const JetPoint& b, double off_mm) {
    const double first_lean = lean_rad(a.axis);
    const double last_lean = lean_rad(b.axis);
    if (std::min(first_lean, last_lean) < kUprightLean_rad) return false;
    const double first = azimuth_rad(a.axis);
    const double turn = std::remainder(azimuth_rad(b.axis) - first, kTurn_rad);
    const Vector swung = axis_of(first + turn / 2, (first_lean + last_lean) / 2);
    const Vector straight = (a.axis + b.axis).normalized();
    return (swung - straight).norm() * std::max({a.depth_mm, b.depth_mm, 1.0}) > off_mm;
}

void add_between(const JetPoint& a, const JetPoint& b, double off_mm, int depth,
                 std::vector<JetPoint>& points) {
    if (depth < kMostHalvings && swings(a, b, off_mm)) {
        JetPoint middle = between(a, b, 0.5);
        middle.edge = b.edge;
        add_between(a, middle, off_mm, depth + 1, points);
        add_between(middle, b, off_mm, depth + 1, points);
        return;
    }
    points.push_back(b);
}

// Adds points near the upright orientation, because the turn about the vertical is fast there.
std::vector<JetPoint> close_near_upright(std::span<const JetPoint> points, double off_mm) {
    std::vector<JetPoint> close;
    if (points.empty()) return close;
    close.push_back(points.front());
    for (std::size_t i = 1; i < points.size(); ++i) add_between(points[i - 1], points[i], off_mm, 0, close);
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
        tips_.push_back(tip_of(at, jet));
        const double lean = lean_rad(at.axis);
        double azimuth = azimuth_rad(at.axis);
        if (!azimuth_.empty()) {
            const double before = azimuth_.back();
            azimuth = lean < kUprightLean_rad ? before : before + std::remainder(azimuth - before, kTurn_rad);
        }
        azimuth_.push_back(azimuth);
        lean_.push_back(lean);
        way_mm_.push_back(way_mm_.empty() ? 0
                                          : way_mm_.back() + (tips_.back() - tips_[tips_.size() - 2]).norm());
    }

    // Returns the last point that one move can reach, found by doubling and halving.
    std::size_t farthest(std::size_t from) const {
        std::size_t good = from + 1;
        if (way_mm_[good] - way_mm_[from] < kStands_mm) return good;
        std::size_t step = 2;
        std::size_t bad = 0;
        while (bad == 0) {
            const std::size_t to = std::min(from + step, points_.size() - 1);
            if (to == good) return good;
            if (!is_one_move(from, to))
                bad = to;
            else if (to == points_.size() - 1)
                return to;
            else
                good = to;
            step *= 2;
        }
        while (bad - good > 1) {
            const std::size_t middle = (good + bad) / 2;
            (is_one_move(from, middle) ? good : bad) = middle;
        }
        return good;
    }

    bool is_one_move(std::size_t from, std::size_t to) const {
        for (std::size_t i = from; i < to; ++i) {
            const bool stands = way_mm_[i + 1] - way_mm_[i] < kStands_mm;
            if (i > from && points_[i].stays) return false;
            if (stands || points_[i + 1].edge != points_[from + 1].edge) return false;
        }
        return axis_fits(from, to) && (is_line(from, to) || arc(from, to).has_value());
    }

    bool axis_fits(std::size_t from, std::size_t to) const {
        for (std::size_t i = from + 1; i < to; ++i) {
            const double share = (way_mm_[i] - way_mm_[from]) / (way_mm_[to] - way_mm_[from]);
            const Vector axis = axis_of(azimuth_[from] + share * (azimuth_[to] - azimuth_[from]),
                                        lean_[from] + share * (lean_[to] - lean_[from]));
            const double reach_mm = std::max(points_[i].depth_mm, 1.0);
            if ((axis - points_[i].axis).norm() * reach_mm > tolerance_.wall_mm) return false;
        }
        return true;
    }

    bool is_line(std::size_t from, std::size_t to) const {
        const Vector chord = tips_[to] - tips_[from];
        for (std::size_t i = from + 1; i < to; ++i) {
            const double off = chord.cross(tips_[i] - tips_[from]).norm();
            if (off > tolerance_.tip_mm * chord.norm()) return false;
        }
        return chord.norm() > kStands_mm;
    }

    std::optional<Circle> arc(std::size_t from, std::size_t to) const {
        auto circle = circle_through(tips_[from], tips_[(from + to) / 2], tips_[to]);
        if (!circle || way_mm_[to] - way_mm_[from] > kMostSweep_rad * circle->radius_mm) return std::nullopt;
        for (std::size_t i = from; i <= to; ++i) {
            const Vector off = tips_[i] - circle->center;
            const double above = off.dot(circle->normal);
            const double beside = (off - above * circle->normal).norm() - circle->radius_mm;
            if (std::hypot(above, beside) > tolerance_.tip_mm) return std::nullopt;
        }
        return circle;
    }

    // Returns the midpoint of the arc, on the side of its points.
    Vector half_way(const Circle& circle, std::size_t from, std::size_t to) const {
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
        found.tip_mm = way_mm_[to] - way_mm_[from];
        found.turns = (points_[to].axis - points_[from].axis).norm() > kSameAxis;
        found.corner_rad = points_[from].corner_rad;
        found.depth_mm = points_[from].depth_mm;
        for (std::size_t i = from; i < to; ++i)
            found.depth_mm = std::max(found.depth_mm, points_[i + 1].depth_mm);
        for (std::size_t i = from; i < to; ++i)
            found.edge_mm += (points_[i + 1].edge_mm - points_[i].edge_mm).norm();
        if (to - from < 2 || is_line(from, to)) return found;
        const auto circle = arc(from, to);
        if (!circle) return found;
        found.via_mm = half_way(*circle, from, to);
        found.radius_mm = circle->radius_mm;
        return found;
    }

    std::span<const JetPoint> points_;
    const FitTolerance& tolerance_;
    std::vector<Vector> tips_;
    std::vector<double> azimuth_, lean_, way_mm_;
};

}  // namespace

std::vector<JetMove> fit_moves(std::span<const JetPoint> points, const JetShape& jet,
                               const FitTolerance& tolerance) {
    const std::vector<JetPoint> close = close_near_upright(points, tolerance.wall_mm / 3);
    return MoveFitter(close, jet, tolerance).run();
}

}  // namespace gsim::surface
