#include "runtime/monitors/set_point_way.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gsim::simulation {

using Eigen::Vector3d;

namespace {

constexpr double kNoLength_mm = 1e-12;
constexpr int kNewtonSteps = 8;        // of Newton's method, which doubles the digits
constexpr double kHermite = 4.0 / 27;  // the greatest value of u (1 - u)^2

double share_of_line(const Vector3d& point, const Vector3d& from, const Vector3d& to) {
    const Vector3d way = to - from;
    const double square = way.squaredNorm();
    return square > 0 ? std::clamp((point - from).dot(way) / square, 0.0, 1.0) : 0;
}

}  // namespace

Vector3d SetPointWay::Piece::at(double share) const {
    const double left = 1 - share;
    return from + share * (to - from) + share * left * left * bend_from - share * share * left * bend_to;
}

/// Returns any value from `enough_mm` up to the distance, if that is `enough_mm` or more.
double SetPointWay::Piece::distance_mm(const Vector3d& point_mm, double enough_mm) const {
    double share = share_of_line(point_mm, from, to);
    const double of_chord = (from + share * (to - from) - point_mm).norm();
    if (bulge_mm == 0 || of_chord - bulge_mm >= enough_mm) return of_chord;
    double least = std::min((from - point_mm).norm(), (to - point_mm).norm());
    // Newton's method on the derivative of the squared distance, from the foot on the chord.
    for (int i = 0; i < kNewtonSteps; ++i) {
        const double left = 1 - share;
        const Vector3d off = at(share) - point_mm;
        least = std::min(least, off.norm());
        const Vector3d slope =
            (to - from) + left * (left - 2 * share) * bend_from - share * (2 * left - share) * bend_to;
        const Vector3d bend = (6 * share - 4) * bend_from - (2 - 6 * share) * bend_to;
        const double second = slope.squaredNorm() + off.dot(bend);
        if (!(second > 0)) break;
        const double next = std::clamp(share - off.dot(slope) / second, 0.0, 1.0);
        if (std::abs(next - share) < 1e-12) break;
        share = next;
    }
    return least;
}

void SetPointWay::begin(const Vector3d& at_mm) {
    pieces_.clear();
    near_ = 0;
    end_mm_ = at_mm;
}

void SetPointWay::add(Piece piece) {
    if (!pieces_.empty()) piece.behind_mm = pieces_.back().behind_mm + pieces_.back().length_mm;
    end_mm_ = piece.to;
    pieces_.push_back(piece);
    if (pieces_.size() <= kMost) return;
    pieces_.pop_front();
    if (near_ > 0) --near_;
}

void SetPointWay::add_line(const Vector3d& to_mm, double end_s, bool longer) {
    if (longer && !pieces_.empty()) {
        Piece& last = pieces_.back();
        last.to = end_mm_ = to_mm;
        last.length_mm = (last.to - last.from).norm();
        last.end_s = end_s;
        return;
    }
    add({.from = end_mm_,
         .to = to_mm,
         .bend_from = Vector3d::Zero(),
         .bend_to = Vector3d::Zero(),
         .length_mm = (to_mm - end_mm_).norm(),
         .end_s = end_s});
}

void SetPointWay::add_curve(const End& from, const End& to, double end_s) {
    const Vector3d chord = to.point_mm - from.point_mm;
    Piece piece{.from = from.point_mm,
                .to = to.point_mm,
                .bend_from = from.slope_mm - chord,
                .bend_to = to.slope_mm - chord,
                .end_s = end_s};
    const double bends_mm = piece.bend_from.norm() + piece.bend_to.norm();
    piece.bulge_mm = kHermite * bends_mm;
    piece.length_mm = chord.norm() + bends_mm;
    if (piece.length_mm > kNoLength_mm) add(piece);
}

void SetPointWay::forget_before(double t_s) {
    while (pieces_.size() > 1 && pieces_.front().end_s < t_s) {
        pieces_.pop_front();
        if (near_ > 0) --near_;
    }
}

/// Returns the last part in front of this one that is not completely within that distance along the path
/// before its start.
std::size_t SetPointWay::before(std::size_t piece, double skipped_mm) const {
    const double until_mm = pieces_[piece].behind_mm - skipped_mm;
    const auto end = pieces_.begin() + static_cast<std::ptrdiff_t>(piece);
    const auto above = std::partition_point(pieces_.begin(), end,
                                            [&](const Piece& one) { return one.behind_mm < until_mm; });
    return static_cast<std::size_t>(above - pieces_.begin());
}

/// Searches from the newest part backwards. A part that is much farther than the nearest one found cannot
/// come nearer before that much more of the path, so most parts are never checked.
double SetPointWay::distance_mm(const Vector3d& point_mm) {
    if (pieces_.empty()) return (end_mm_ - point_mm).norm();
    near_ = std::min(near_, pieces_.size() - 1);
    double least = pieces_[near_].distance_mm(point_mm, std::numeric_limits<double>::infinity());
    for (std::size_t after = pieces_.size(); after > 0;) {
        const std::size_t piece = after - 1;
        const double distance_mm = pieces_[piece].distance_mm(point_mm, least);
        if (distance_mm < least) {
            least = distance_mm;
            near_ = piece;
        }
        const double ahead_mm = (pieces_[piece].from - point_mm).norm() - least;
        after = ahead_mm > 0 ? before(piece, ahead_mm) : piece;
    }
    return least;
}

}  // namespace gsim::simulation
