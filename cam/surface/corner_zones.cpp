#include "cam/surface/corner_zones.h"

#include <algorithm>
#include <cmath>

#include "cam/surface/jet_path.h"

namespace gsim::surface {

namespace {

constexpr double kMinLength_mm = 0.01;  // of a move

struct CornerPosition {
    double at_mm = 0;  // along the path
    double turn_rad = 0;
};

class CornerZones {
  public:
    CornerZones(std::vector<JetPoint>& points, const JetShape& jet, double zone_mm)
        : points_(points), zone_mm_(zone_mm) {
        double at_mm = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i > 0) at_mm += (jet_center(points[i], jet) - jet_center(points[i - 1], jet)).norm();
            arc_lengths_mm_.push_back(at_mm);
        }
        find_corners();
    }

    void mark() {
        if (corners_.empty()) return;
        add_zone_ends();
        for (std::size_t i = 0; i + 1 < points_.size(); ++i)
            points_[i].corner_rad = corner_angle_at((arc_lengths_mm_[i] + arc_lengths_mm_[i + 1]) / 2);
        points_.back().corner_rad = 0;
    }

  private:
    void find_corners() {
        for (std::size_t i = 1; i < points_.size(); ++i) {
            const JetPoint& before = points_[i - 1];
            const JetPoint& after = points_[i];
            if (before.edge == after.edge) continue;
            if (classify_corner(before.tangent, after.tangent, before.normal) != Corner::concave) continue;
            const double turn_rad = angle_between_rad(before.tangent, after.tangent);
            corners_.push_back({arc_lengths_mm_[i], turn_rad});
            // The end of the path is its beginning.
            if (i + 1 == points_.size()) corners_.push_back({0, turn_rad});
        }
    }

    void add_zone_ends() {
        std::vector<double> ends;
        for (const CornerPosition& corner : corners_) {
            ends.push_back(corner.at_mm - zone_mm_);
            ends.push_back(corner.at_mm + zone_mm_);
        }
        std::sort(ends.begin(), ends.end());
        for (const double end_mm : ends) add_zone_end(end_mm);
    }

    void add_zone_end(double end_mm) {
        if (end_mm <= 0 || end_mm >= arc_lengths_mm_.back()) return;
        const auto next = std::upper_bound(arc_lengths_mm_.begin(), arc_lengths_mm_.end(), end_mm);
        const auto i = static_cast<std::size_t>(next - arc_lengths_mm_.begin());
        if (end_mm - arc_lengths_mm_[i - 1] < kMinLength_mm) {
            points_[i - 1].is_fixed = true;
        } else if (arc_lengths_mm_[i] - end_mm < kMinLength_mm) {
            points_[i].is_fixed = true;
        } else {
            JetPoint at =
                between(points_[i - 1], points_[i],
                        (end_mm - arc_lengths_mm_[i - 1]) / (arc_lengths_mm_[i] - arc_lengths_mm_[i - 1]));
            at.edge = points_[i].edge;
            at.is_fixed = true;
            points_.insert(points_.begin() + static_cast<std::ptrdiff_t>(i), at);
            arc_lengths_mm_.insert(next, end_mm);
        }
    }

    double corner_angle_at(double at_mm) const {
        double turn_rad = 0;
        for (const CornerPosition& corner : corners_) {
            if (std::abs(at_mm - corner.at_mm) < zone_mm_) turn_rad = std::max(turn_rad, corner.turn_rad);
        }
        return turn_rad;
    }

    std::vector<JetPoint>& points_;
    double zone_mm_;
    std::vector<double> arc_lengths_mm_;
    std::vector<CornerPosition> corners_;
};

}  // namespace

void mark_corners(std::vector<JetPoint>& points, const JetShape& jet, double zone_mm) {
    if (zone_mm > 0 && !points.empty()) CornerZones(points, jet, zone_mm).mark();
}

}  // namespace gsim::surface
