#include "toolpath/rotary/merged_lines.h"

#include <algorithm>
#include <cmath>

namespace gsim::path {

namespace {

constexpr double kLineTolerance_deg = 1e-5;
constexpr double kFeedTolerance = 1e-4;        // as a share
constexpr std::size_t kMaxPassedPoints = 256;  // each is looked at again with each further move

}  // namespace

void MergedLines::flush() {
    if (line_) sink_.move(*line_);
    line_.reset();
    passed_points_.clear();
}

bool MergedLines::turns_rotary(const AxisMove& move) const {
    if (move.rapid || move.arc || !at_) return false;
    for (Eigen::Index i = 0; i < move.axes.size(); ++i) {
        const machine::Axis& axis = space_.machine().axes[static_cast<std::size_t>(i)];
        if (axis.kind == machine::AxisKind::rotary && move.axes[i] != (*at_)[i]) return true;
    }
    return false;
}

// Returns true if a line from the start to `end` runs through a point.
bool MergedLines::is_between(const AxisValues& point, const AxisValues& end) const {
    const AxisValues displacement = end - start_;
    const double share = (point - start_).dot(displacement) / displacement.squaredNorm();
    if (!(share > 0 && share < 1)) return false;
    const AxisValues off = point - start_ - share * displacement;
    for (Eigen::Index i = 0; i < off.size(); ++i) {
        const machine::Axis& axis = space_.machine().axes[static_cast<std::size_t>(i)];
        const double slack = axis.kind == machine::AxisKind::rotary ? kLineTolerance_deg : budget_mm_;
        if (std::abs(off[i]) > slack) return false;
    }
    return true;
}

bool MergedLines::continues(const AxisMove& move) const {
    if (!line_ || move.lead_mm || line_->lead_mm) return false;
    if (line_->duration_s.has_value() != move.duration_s.has_value()) return false;
    if (line_->feed_mm_rev.has_value() || move.feed_mm_rev.has_value()) return false;
    if (line_->feed_is_rotary != move.feed_is_rotary ||
        std::abs(line_->feed_per_min - move.feed_per_min) > kFeedTolerance * move.feed_per_min) {
        return false;
    }
    return is_between(line_->axes, move.axes) &&
           std::all_of(passed_points_.begin(), passed_points_.end(),
                       [&](const AxisValues& point) { return is_between(point, move.axes); });
}

// Drops every second one of very many points: the remaining ones still show a curvature.
void MergedLines::pass(const AxisValues& point) {
    passed_points_.push_back(point);
    if (passed_points_.size() < kMaxPassedPoints) return;
    for (std::size_t i = 0; i < kMaxPassedPoints / 2; ++i) passed_points_[i] = passed_points_[2 * i];
    passed_points_.resize(kMaxPassedPoints / 2);
}

void MergedLines::move(const AxisMove& move) {
    if (!turns_rotary(move)) {
        flush();
        sink_.move(move);
    } else if (continues(move)) {
        pass(line_->axes);
        line_->axes = move.axes;
        if (move.duration_s) *line_->duration_s += *move.duration_s;
    } else {
        flush();
        start_ = *at_;
        line_ = move;
    }
    at_ = move.axes;
}

void MergedLines::set_position(const AxisValues& axes) {
    flush();
    at_ = axes;
    sink_.set_position(axes);
}

void MergedLines::retract() {
    flush();
    sink_.retract();
}

void MergedLines::go_to(const MachineApproach& displacement) {
    flush();
    at_.reset();
    sink_.go_to(displacement);
}

void MergedLines::work_offset(const std::string& name) {
    flush();
    sink_.work_offset(name);
}

void MergedLines::dwell(double seconds) {
    flush();
    sink_.dwell(seconds);
}

void MergedLines::acceleration(double mm_s2) {
    flush();
    sink_.acceleration(mm_s2);
}

void MergedLines::action(const std::string& name) {
    flush();
    sink_.action(name);
}

void MergedLines::call(const SubPath& sub_path) {
    flush();
    at_.reset();
    sink_.call(sub_path);
}

void MergedLines::note(const TargetId& where, std::string_view message) {
    flush();
    sink_.note(where, message);
}

}  // namespace gsim::path
