#include "runtime/monitors/path_deviation_monitor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gsim::simulation {

using Eigen::Vector3d;
using motion::PathDeviation;
using motion::Segment;
using motion::SegmentKind;

namespace {

constexpr double kMinDeviation_mm = 1e-6;      // nearer to the end of a move is on it
constexpr double kDeviationArcStep_rad = 0.1;  // from point to point
constexpr int kSuperimposedPoints = 16;        // of two motions at once
constexpr int kRotationPoints = 32;            // if the part turns
constexpr std::size_t kSubsequentMoves =
    2;  // moves that follow the current one, which a rounded corner may come near
constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr int kMaxTargets = 4;  // of a run that are kept

bool turns(const WorkpieceTcp& tcp, const Segment& segment) {
    const bool standalone = tcp.turns(segment.start, segment.end);
    return standalone || segment.orientation ||
           (segment.superimposed && tcp.turns(segment.superimposed->start, segment.superimposed->end));
}

int step_count(const Segment& segment, bool has_rotation) {
    if (has_rotation) return kRotationPoints;
    if (segment.superimposed) return kSuperimposedPoints;
    if (segment.kind != SegmentKind::circular) return 1;
    return static_cast<int>(std::clamp(std::ceil(segment.arc.sweep_rad / kDeviationArcStep_rad), 8.0, 32.0));
}

}  // namespace

PathDeviationMonitor::PathDeviationMonitor(const motion::PlannerSetup& setup) : setup_(setup) {
    set_tcp(Vector3d::Zero());
}

void PathDeviationMonitor::set_tcp(const Vector3d& tcp_mm) {
    auto tcp = std::make_shared<WorkpieceTcp>(setup_, tcp_mm);
    if (!tcp_ || tcp_->can_rotate() || tcp->can_rotate()) tcp_ = std::move(tcp);
}

void PathDeviationMonitor::expect(rrs::TargetId id, const SourceLocation& location) {
    expected_id_ = id;
    location_ = location;
}

void PathDeviationMonitor::on_programmed_move(const motion::PathMove& move) {
    paths_.emplace_back(move, setup_.position_joints, tcp_,
                        move.target_id == expected_id_ ? location_ : SourceLocation());
}

void PathDeviationMonitor::discard_last_move() {
    paths_.pop_back();
}

void PathDeviationMonitor::forget() {
    paths_.clear();
    run_.clear();
}

void PathDeviationMonitor::on_segment(const Segment& segment, const MoveInfo&) {
    if (paths_.empty()) return;
    const bool is_known = segment.path_deviation == PathDeviation::corner && tcp_->preserves_distances();
    if (is_known && segment.deviation_mm > 0) on_reported_corner(segment);
    if (segment.path_deviation != PathDeviation::no && !is_known) return on_deviating_segment(segment);
    const bool is_standstill =
        segment.target_id < 0 || (segment.kind == SegmentKind::rest && !segment.superimposed);
    if (!run_.empty()) end_run(is_standstill ? run_.back().id : first_move_after_run(segment));
    if (is_standstill) return;
    last_on_path_id_ = first_unsettled_id_ = segment.target_id;
    drop_passed_moves();
}

void PathDeviationMonitor::end(double) {
    if (!run_.empty()) end_run(run_.back().id);
}

/// Returns the move at the start of which a run has ended before this segment: an arc rounds the corner in
/// front of its move.
rrs::TargetId PathDeviationMonitor::first_move_after_run(const Segment& segment) const {
    const std::size_t path_index = find_path_index(segment.target_id);
    const bool is_rounded_corner =
        segment.path_deviation == PathDeviation::corner && segment.kind == SegmentKind::circular;
    return is_rounded_corner && path_index > 0 && path_index < paths_.size() ? paths_[path_index - 1].id()
                                                                             : segment.target_id;
}

/// Adds a corner with a distance that the planner has computed.
void PathDeviationMonitor::on_reported_corner(const Segment& segment) {
    const std::size_t path_index = find_path_index(segment.target_id);
    if (path_index == paths_.size()) return;
    ++blends_.count;
    const bool rapid = paths_[path_index].rapid() && (path_index == 0 || paths_[path_index - 1].rapid());
    note(segment.deviation_mm, rapid, paths_[path_index].location());
}

void PathDeviationMonitor::on_deviating_segment(const Segment& segment) {
    const std::size_t path_index = find_path_index(segment.target_id);
    if (path_index == paths_.size()) return;
    if (run_.empty()) first_unsettled_id_ = last_on_path_id_;
    int targets = run_.empty() || run_.back().id != segment.target_id ? 1 : 0;
    rrs::TargetId second = 0;
    for (std::size_t i = 0; i < run_.size(); ++i) {
        if (i > 0 && run_[i].id == run_[i - 1].id) continue;
        if (i > 0 && second == 0) second = run_[i].id;
        ++targets;
    }
    if (targets >= kMaxTargets) {
        finish_paths_before(second);
        while (run_.front().id != second) run_.pop_front();
        drop_passed_moves();
    }
    run_.emplace_back();
    const std::size_t now = find_path_index(segment.target_id);
    sample_segment(segment, *paths_[now].tcp(), run_.back());
    measure(run_.back(), now);
}

void PathDeviationMonitor::sample_segment(const Segment& segment, WorkpieceTcp& tcp,
                                          ActualSegment& actual) const {
    const bool has_rotation = turns(tcp, segment);
    if (!has_rotation) tcp.set_position(segment.start);
    const int steps = step_count(segment, has_rotation);
    actual.id = segment.target_id;
    actual.tcp = &tcp;
    actual.count = steps + 1;
    for (int i = 0; i <= steps; ++i) {
        const double t_s = segment.duration_s * i / steps;
        Vector3d& point = actual.points[static_cast<std::size_t>(i)];
        point = tcp.at(segment.position_at(t_s));
        actual.box.extend(point);
    }
}

/// Returns the index of a move; their number if it is none of these.
std::size_t PathDeviationMonitor::find_path_index(rrs::TargetId id) const {
    const auto found = std::lower_bound(paths_.begin(), paths_.end(), id,
                                        [](const ProgrammedMovePath& path_index, rrs::TargetId requested) {
                                            return path_index.id() < requested;
                                        });
    const bool is = found != paths_.end() && found->id() == id;
    return is ? static_cast<std::size_t>(found - paths_.begin()) : paths_.size();
}

/// Returns the distance of a point from the moves about this one; if that is no more than `cutoff`, any value
/// up to it. The search starts with the moves that follow `near`, which becomes the move that ends the
/// search.
double PathDeviationMonitor::path_deviation(const Vector3d& point, std::size_t path_index, double cutoff,
                                            std::size_t& near) {
    double min = kInfinite;
    const WorkpieceTcp* const tcp = paths_[path_index].tcp().get();
    const auto check_move = [&](std::size_t index) {
        if (paths_[index].tcp().get() != tcp) return;
        const double distance_mm = paths_[index].distance(point, cutoff);
        if (distance_mm >= min) return;
        min = distance_mm;
        near = index;
    };
    const std::size_t last = std::min(path_index + kSubsequentMoves, paths_.size() - 1),
                      first = std::min(near, last);
    for (std::size_t index = first; index <= last && min > cutoff; ++index) check_move(index);
    for (std::size_t index = first; index > 0 && min > cutoff; --index) check_move(index - 1);
    return min;
}

void PathDeviationMonitor::measure(const ActualSegment& actual, std::size_t path_index) {
    const ProgrammedMovePath& move = paths_[path_index];
    const bool same_tool =
        std::all_of(paths_.begin(), paths_.begin() + static_cast<std::ptrdiff_t>(path_index),
                    [&](const ProgrammedMovePath& other) { return other.tcp() == move.tcp(); });
    if (!same_tool) return;
    std::size_t near = find_path_index(nearest_id_);
    for (const Vector3d& point : actual.curve()) {
        const double worst = (move.rapid() ? blends_.rapid : blends_.feed).deviation_mm;
        note(path_deviation(point, path_index, worst, near), move.rapid(), move.location());
    }
    nearest_id_ = paths_[near].id();
}

/// Measures the distance of the driven path from a programmed point of a move, and counts it if the point is
/// the move's end.
void PathDeviationMonitor::measure_missed_point(const Vector3d& point, std::size_t path_index) {
    const WorkpieceTcp* const tcp = paths_[path_index].tcp().get();
    const ProgrammedMovePath& next = paths_[std::min(path_index + 1, paths_.size() - 1)];
    const bool rapid = paths_[path_index].rapid() && next.rapid();
    const double worst = (rapid ? blends_.rapid : blends_.feed).deviation_mm;
    const double min = run_distance(point, tcp, distance_to_chords, worst);
    if (!(min > kMinDeviation_mm) || min == kInfinite) return;
    if (point == paths_[path_index].end()) ++blends_.count;
    if (min > worst) note(run_distance(point, tcp, distance_to_curve, worst), rapid, next.location());
}

/// Returns the distance of a point from the stored run of this tool; if it is missed by no more than
/// `cutoff`, any value up to it. kInfinite if the run is empty.
double PathDeviationMonitor::run_distance(const Vector3d& point, const WorkpieceTcp* tcp,
                                          CurveDistance distance, double cutoff) const {
    double min = kInfinite;
    for (const ActualSegment& actual : run_) {
        const double search_radius = min > cutoff ? min : kMinDeviation_mm;
        if (actual.tcp != tcp || actual.box.squaredExteriorDistance(point) > search_radius * search_radius)
            continue;
        min = std::min(min, distance(point, actual.curve()));
    }
    return min;
}

/// Checks the ends of moves before this one that the run passes.
void PathDeviationMonitor::finish_paths_before(rrs::TargetId end_id) {
    for (std::size_t path_index = 0; path_index < paths_.size() && paths_[path_index].id() < end_id;
         ++path_index) {
        if (paths_[path_index].id() < first_unsettled_id_) continue;
        const bool left_out = paths_[path_index].id() > last_on_path_id_;
        if (left_out) {
            const std::span<const Vector3d> points = paths_[path_index].points();
            for (std::size_t i = 1; i + 1 < points.size(); ++i) measure_missed_point(points[i], path_index);
        }
        measure_missed_point(paths_[path_index].end(), path_index);
    }
    first_unsettled_id_ = std::max(first_unsettled_id_, end_id);
}

void PathDeviationMonitor::end_run(rrs::TargetId end_id) {
    finish_paths_before(end_id);
    run_.clear();
}

/// Drops moves that take part in no later comparison.
void PathDeviationMonitor::drop_passed_moves() {
    const rrs::TargetId first =
        run_.empty() ? last_on_path_id_ : std::min(run_.front().id, first_unsettled_id_);
    while (!paths_.empty() && paths_.front().id() < first) paths_.pop_front();
}

void PathDeviationMonitor::note(double deviation_mm, bool rapid, const SourceLocation& location) {
    Deviation& worst = rapid ? blends_.rapid : blends_.feed;
    if (deviation_mm > worst.deviation_mm) worst = {deviation_mm, location};
}

}  // namespace gsim::simulation
