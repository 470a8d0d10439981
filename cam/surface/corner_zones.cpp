#include "cam/surface/corner_zones.h"

#include <algorithm>
#include <cmath>

#include "cam/surface/jet_way.h"

namespace gsim::surface {

namespace {

constexpr double kShortest_mm = 0.01;  // of a move

struct CornerPlace {
    double at_mm = 0;  // along the path
    double turn_rad = 0;
};

class CornerZones {
  public:
    CornerZones(std::vector<JetPoint>& points, const JetShape& jet, double zone_mm)
        : points_(points), zone_mm_(zone_mm) {
        double at_mm = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i > 0) at_mm += (middle_of(points[i], jet) - middle_of(points[i - 1], jet)).norm();
            at_mm_.push_back(at_mm);
        }
        find_corners();
    }

    void mark() {
        if (corners_.empty()) return;
        add_ends();
        for (std::size_t i = 0; i + 1 < points_.size(); ++i)
            points_[i].corner_rad = turn_at((at_mm_[i] + at_mm_[i + 1]) / 2);
        points_.back().corner_rad = 0;
    }

  private:
    void find_corners() {
        for (std::size_t i = 1; i < points_.size(); ++i) {
            const JetPoint& before = points_[i - 1];
            const JetPoint& after = points_[i];
            if (before.edge == after.edge) continue;
            if (corner_of(before.tangent, after.tangent, before.normal) != Corner::closes) continue;
            const double turn_rad = angle_between_rad(before.tangent, after.tangent);
            corners_.push_back({at_mm_[i], turn_rad});
            // The end of the path is its beginning.
            if (i + 1 == points_.size()) corners_.push_back({0, turn_rad});
        }
    }

    void add_ends() {
        std::vector<double> ends;
        for (const CornerPlace& corner : corners_) {
            ends.push_back(corner.at_mm - zone_mm_);
            ends.push_back(corner.at_mm + zone_mm_);
        }
        std::sort(ends.begin(), ends.end());
        for (const double end_mm : ends) add_end(end_mm);
    }

    void add_end(double end_mm) {
        if (end_mm <= 0 || end_mm >= at_mm_.back()) return;
        const auto next = std::upper_bound(at_mm_.begin(), at_mm_.end(), end_mm);
        const auto i = static_cast<std::size_t>(next - at_mm_.begin());
        if (end_mm - at_mm_[i - 1] < kShortest_mm) {
            points_[i - 1].stays = true;
        } else if (at_mm_[i] - end_mm < kShortest_mm) {
            points_[i].stays = true;
        } else {
            JetPoint at =
                between(points_[i - 1], points_[i], (end_mm - at_mm_[i - 1]) / (at_mm_[i] - at_mm_[i - 1]));
            at.edge = points_[i].edge;
            at.stays = true;
            points_.insert(points_.begin() + static_cast<std::ptrdiff_t>(i), at);
            at_mm_.insert(next, end_mm);
        }
    }

    double turn_at(double at_mm) const {
        double turn_rad = 0;
        for (const CornerPlace& corner : corners_) {
            if (std::abs(at_mm - corner.at_mm) < zone_mm_) turn_rad = std::max(turn_rad, corner.turn_rad);
        }
        return turn_rad;
    }

    std::vector<JetPoint>& points_;
    double zone_mm_;
    std::vector<double> at_mm_;
    std::vector<CornerPlace> corners_;
};

}  // namespace

void mark_corners(std::vector<JetPoint>& points, const JetShape& jet, double zone_mm) {
    if (zone_mm > 0 && !points.empty()) CornerZones(points, jet, zone_mm).mark();
}

}  // namespace gsim::surface
