#include "runtime/monitors/set_point_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gsim::simulation {

using Eigen::Vector3d;

namespace {

constexpr double kMinLength_mm = 1e-12;
constexpr int kNewtonIterations = 8;          // of Newton's method, which doubles the digits
constexpr double kMaxHermiteTerm = 4.0 / 27;  // the greatest value of u (1 - u)^2

double line_parameter(const Vector3d& point, const Vector3d& from, const Vector3d& to) {
    const Vector3d displacement = to - from;
    const double square = displacement.squaredNorm();
    return square > 0 ? std::clamp((point - from).dot(displacement) / square, 0.0, 1.0) : 0;
}

}  // namespace

Vector3d SetPointPath::SubSegment::at(double share) const {
    const double left = 1 - share;
    return from + share * (to - from) + share * left * left * slope_deviation_from -
           share * share * left * slope_deviation_to;
}

/// Returns any value from `enough_mm` up to the distance, if that is `enough_mm` or more.
double SetPointPath::SubSegment::distance_mm(const Vector3d& point_mm, double enough_mm) const {
    double share = line_parameter(point_mm, from, to);
    const double chord_distance_mm = (from + share * (to - from) - point_mm).norm();
    if (bulge_mm == 0 || chord_distance_mm - bulge_mm >= enough_mm) return chord_distance_mm;
    double min = std::min((from - point_mm).norm(), (to - point_mm).norm());
    // Newton's method on the derivative of the squared distance, from the foot on the chord.
    for (int i = 0; i < kNewtonIterations; ++i) {
        const double left = 1 - share;
        const Vector3d offset = at(share) - point_mm;
        min = std::min(min, offset.norm());
        const Vector3d slope = (to - from) + left * (left - 2 * share) * slope_deviation_from -
                               share * (2 * left - share) * slope_deviation_to;
        const Vector3d curvature =
            (6 * share - 4) * slope_deviation_from - (2 - 6 * share) * slope_deviation_to;
        const double second = slope.squaredNorm() + offset.dot(curvature);
        if (!(second > 0)) break;
        const double next = std::clamp(share - offset.dot(slope) / second, 0.0, 1.0);
        if (std::abs(next - share) < 1e-12) break;
        share = next;
    }
    return min;
}

void SetPointPath::begin(const Vector3d& at_mm) {
    sub_segments_.clear();
    nearest_ = 0;
    end_mm_ = at_mm;
}

void SetPointPath::add(SubSegment sub_segment) {
    if (!sub_segments_.empty())
        sub_segment.start_distance_mm =
            sub_segments_.back().start_distance_mm + sub_segments_.back().length_mm;
    end_mm_ = sub_segment.to;
    sub_segments_.push_back(sub_segment);
    if (sub_segments_.size() <= kMaxSubSegments) return;
    sub_segments_.pop_front();
    if (nearest_ > 0) --nearest_;
}

void SetPointPath::add_line(const Vector3d& to_mm, double end_s, bool extends_last) {
    if (extends_last && !sub_segments_.empty()) {
        SubSegment& last = sub_segments_.back();
        last.to = end_mm_ = to_mm;
        last.length_mm = (last.to - last.from).norm();
        last.end_s = end_s;
        return;
    }
    add({.from = end_mm_,
         .to = to_mm,
         .slope_deviation_from = Vector3d::Zero(),
         .slope_deviation_to = Vector3d::Zero(),
         .length_mm = (to_mm - end_mm_).norm(),
         .end_s = end_s});
}

void SetPointPath::add_curve(const EndPoint& from, const EndPoint& to, double end_s) {
    const Vector3d chord = to.point_mm - from.point_mm;
    SubSegment sub_segment{.from = from.point_mm,
                           .to = to.point_mm,
                           .slope_deviation_from = from.slope_mm - chord,
                           .slope_deviation_to = to.slope_mm - chord,
                           .end_s = end_s};
    const double slope_deviation_mm =
        sub_segment.slope_deviation_from.norm() + sub_segment.slope_deviation_to.norm();
    sub_segment.bulge_mm = kMaxHermiteTerm * slope_deviation_mm;
    sub_segment.length_mm = chord.norm() + slope_deviation_mm;
    if (sub_segment.length_mm > kMinLength_mm) add(sub_segment);
}

void SetPointPath::discard_before(double t_s) {
    while (sub_segments_.size() > 1 && sub_segments_.front().end_s < t_s) {
        sub_segments_.pop_front();
        if (nearest_ > 0) --nearest_;
    }
}

/// Returns the last part in front of this one that is not completely within that distance along the path
/// before its start.
std::size_t SetPointPath::before(std::size_t sub_segment, double skipped_mm) const {
    const double skip_limit_mm = sub_segments_[sub_segment].start_distance_mm - skipped_mm;
    const auto end = sub_segments_.begin() + static_cast<std::ptrdiff_t>(sub_segment);
    const auto above = std::partition_point(sub_segments_.begin(), end, [&](const SubSegment& one) {
        return one.start_distance_mm < skip_limit_mm;
    });
    return static_cast<std::size_t>(above - sub_segments_.begin());
}

/// Searches from the newest part backwards. A part that is much farther than the nearest one found cannot
/// come nearer before that much more of the path, so most parts are never checked.
double SetPointPath::distance_mm(const Vector3d& point_mm) {
    if (sub_segments_.empty()) return (end_mm_ - point_mm).norm();
    nearest_ = std::min(nearest_, sub_segments_.size() - 1);
    double min = sub_segments_[nearest_].distance_mm(point_mm, std::numeric_limits<double>::infinity());
    for (std::size_t after = sub_segments_.size(); after > 0;) {
        const std::size_t sub_segment = after - 1;
        const double distance_mm = sub_segments_[sub_segment].distance_mm(point_mm, min);
        if (distance_mm < min) {
            min = distance_mm;
            nearest_ = sub_segment;
        }
        const double ahead_mm = (sub_segments_[sub_segment].from - point_mm).norm() - min;
        after = ahead_mm > 0 ? before(sub_segment, ahead_mm) : sub_segment;
    }
    return min;
}

}  // namespace gsim::simulation
