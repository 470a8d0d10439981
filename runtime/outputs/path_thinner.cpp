#include "runtime/outputs/path_thinner.h"

#include <cmath>
#include <utility>

namespace gsim::simulation {

using Eigen::Vector2d;

void PathThinner::add(const Vector2d& at_mm, PathStyle style) {
    push({at_mm, style});
    if (kept_.size() >= kMaxPoints) coarsen();
}

void PathThinner::push(const PathPoint& point) {
    if (kept_.empty()) {
        kept_.push_back(point);
        return;
    }
    const bool style_changes = last_ && last_->style != point.style;
    if (style_changes && (last_->at_mm - kept_.back().at_mm).norm() > tolerance_mm_) store_last();
    if (last_ && direction_ && !continues_line(point.at_mm)) store_last();
    const Vector2d displacement = point.at_mm - kept_.back().at_mm;
    if (!direction_ && displacement.norm() > tolerance_mm_) direction_ = displacement.normalized();
    last_ = point;
}

void PathThinner::store_last() {
    kept_.push_back(*last_);
    last_.reset();
    direction_.reset();
}

bool PathThinner::continues_line(const Vector2d& at_mm) const {
    const Vector2d displacement = at_mm - kept_.back().at_mm;
    const Vector2d last_offset = last_->at_mm - kept_.back().at_mm;
    const double lateral = displacement.x() * direction_->y() - displacement.y() * direction_->x();
    return std::abs(lateral) <= tolerance_mm_ &&
           displacement.dot(*direction_) >= last_offset.dot(*direction_) - tolerance_mm_;
}

void PathThinner::coarsen() {
    while (kept_.size() > kMaxPoints / 2) {
        tolerance_mm_ *= 2;
        std::vector<PathPoint> old = points();
        kept_.clear();
        last_.reset();
        direction_.reset();
        for (const PathPoint& point : old) push(point);
    }
}

std::vector<PathPoint> PathThinner::points() const {
    std::vector<PathPoint> points = kept_;
    if (last_) points.push_back(*last_);
    return points;
}

}  // namespace gsim::simulation
