#include "runtime/monitors/way_deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gsim::simulation {

using Eigen::Vector3d;
using motion::OffWay;
using motion::Segment;
using motion::SegmentKind;

namespace {

constexpr double kMissed_mm = 1e-6;            // nearer to the end of a move is on it
constexpr double kDeviationArcStep_rad = 0.1;  // from point to point
constexpr int kPointsOfTwo = 16;               // of two motions at once
constexpr int kPointsOfTurns = 32;             // if the part turns
constexpr std::size_t kWaysBehind = 2;  // moves after the current one that a rounded corner may come near
constexpr double kNowhere = std::numeric_limits<double>::infinity();
constexpr int kMostTargets = 4;  // of a run that are kept

bool turns(const PartTip& tip, const Segment& segment) {
    const bool alone = tip.turns(segment.start, segment.end);
    return alone || segment.orientation ||
           (segment.beside && tip.turns(segment.beside->start, segment.beside->end));
}

int steps_of(const Segment& segment, bool turning) {
    if (turning) return kPointsOfTurns;
    if (segment.beside) return kPointsOfTwo;
    if (segment.kind != SegmentKind::circular) return 1;
    return static_cast<int>(std::clamp(std::ceil(segment.arc.sweep_rad / kDeviationArcStep_rad), 8.0, 32.0));
}

}  // namespace

WayDeviation::WayDeviation(const motion::PlannerSetup& setup) : setup_(setup) {
    set_tip(Vector3d::Zero());
}

void WayDeviation::set_tip(const Vector3d& tip_mm) {
    auto tip = std::make_shared<PartTip>(setup_, tip_mm);
    if (!tip_ || tip_->ever_turns() || tip->ever_turns()) tip_ = std::move(tip);
}

void WayDeviation::expect(rrs::TargetId id, const Place& place) {
    expected_ = id;
    place_ = place;
}

void WayDeviation::programmed(const motion::PathMove& move) {
    ways_.emplace_back(move, setup_.position_joints, tip_, move.target_id == expected_ ? place_ : Place());
}

void WayDeviation::take_back() {
    ways_.pop_back();
}

void WayDeviation::forget() {
    ways_.clear();
    run_.clear();
}

void WayDeviation::take(const Segment& segment, const MoveInfo&) {
    if (ways_.empty()) return;
    const bool told = segment.off_way == OffWay::corner && tip_->keeps_distances();
    if (told && segment.deviation_mm > 0) take_told(segment);
    if (segment.off_way != OffWay::no && !told) return take_off_way(segment);
    const bool rests = segment.target_id < 0 || (segment.kind == SegmentKind::rest && !segment.beside);
    if (!run_.empty()) end_run(rests ? run_.back().id : first_behind_run(segment));
    if (rests) return;
    passed_ = unsettled_ = segment.target_id;
    drop_old();
}

void WayDeviation::end(double) {
    if (!run_.empty()) end_run(run_.back().id);
}

/// Returns the move at the start of which a run has ended before this segment: an arc rounds the corner in
/// front of its move.
rrs::TargetId WayDeviation::first_behind_run(const Segment& segment) const {
    const std::size_t way = way_of(segment.target_id);
    const bool rounds = segment.off_way == OffWay::corner && segment.kind == SegmentKind::circular;
    return rounds && way > 0 && way < ways_.size() ? ways_[way - 1].id() : segment.target_id;
}

/// Adds a corner with a distance that the planner has computed.
void WayDeviation::take_told(const Segment& segment) {
    const std::size_t way = way_of(segment.target_id);
    if (way == ways_.size()) return;
    ++blends_.count;
    const bool rapid = ways_[way].rapid() && (way == 0 || ways_[way - 1].rapid());
    note(segment.deviation_mm, rapid, ways_[way].place());
}

void WayDeviation::take_off_way(const Segment& segment) {
    const std::size_t way = way_of(segment.target_id);
    if (way == ways_.size()) return;
    if (run_.empty()) unsettled_ = passed_;
    int targets = run_.empty() || run_.back().id != segment.target_id ? 1 : 0;
    rrs::TargetId second = 0;
    for (std::size_t i = 0; i < run_.size(); ++i) {
        if (i > 0 && run_[i].id == run_[i - 1].id) continue;
        if (i > 0 && second == 0) second = run_[i].id;
        ++targets;
    }
    if (targets >= kMostTargets) {
        settle(second);
        while (run_.front().id != second) run_.pop_front();
        drop_old();
    }
    run_.emplace_back();
    const std::size_t now = way_of(segment.target_id);
    look_at(segment, *ways_[now].tip(), run_.back());
    measure(run_.back(), now);
}

void WayDeviation::look_at(const Segment& segment, PartTip& tip, Driven& driven) const {
    const bool turning = turns(tip, segment);
    if (!turning) tip.stand_at(segment.start);
    const int steps = steps_of(segment, turning);
    driven.id = segment.target_id;
    driven.tip = &tip;
    driven.count = steps + 1;
    for (int i = 0; i <= steps; ++i) {
        const double t_s = segment.duration_s * i / steps;
        Vector3d& point = driven.points[static_cast<std::size_t>(i)];
        point = tip.at(segment.position_at(t_s));
        driven.box.extend(point);
    }
}

/// Returns the index of a move; their number if it is none of these.
std::size_t WayDeviation::way_of(rrs::TargetId id) const {
    const auto found =
        std::lower_bound(ways_.begin(), ways_.end(), id,
                         [](const ProgrammedWay& way, rrs::TargetId wanted) { return way.id() < wanted; });
    const bool is = found != ways_.end() && found->id() == id;
    return is ? static_cast<std::size_t>(found - ways_.begin()) : ways_.size();
}

/// Returns the distance of a point from the moves about this one; if that is no more than `enough`, any value
/// up to it. The search starts with the moves that follow `near`, which becomes the move that ends the
/// search.
double WayDeviation::off_way(const Vector3d& point, std::size_t way, double enough, std::size_t& near) {
    double least = kNowhere;
    const PartTip* const tip = ways_[way].tip().get();
    const auto look = [&](std::size_t index) {
        if (ways_[index].tip().get() != tip) return;
        const double distance_mm = ways_[index].distance(point, enough);
        if (distance_mm >= least) return;
        least = distance_mm;
        near = index;
    };
    const std::size_t last = std::min(way + kWaysBehind, ways_.size() - 1), first = std::min(near, last);
    for (std::size_t index = first; index <= last && least > enough; ++index) look(index);
    for (std::size_t index = first; index > 0 && least > enough; --index) look(index - 1);
    return least;
}

void WayDeviation::measure(const Driven& driven, std::size_t way) {
    const ProgrammedWay& move = ways_[way];
    const bool one_tool = std::all_of(ways_.begin(), ways_.begin() + static_cast<std::ptrdiff_t>(way),
                                      [&](const ProgrammedWay& other) { return other.tip() == move.tip(); });
    if (!one_tool) return;
    std::size_t near = way_of(near_);
    for (const Vector3d& point : driven.curve()) {
        const double worst = (move.rapid() ? blends_.rapid : blends_.feed).deviation_mm;
        note(off_way(point, way, worst, near), move.rapid(), move.place());
    }
    near_ = ways_[near].id();
}

/// Measures the distance of the driven path from a programmed point of a move, and counts it if the point is
/// the move's end.
void WayDeviation::measure_missed(const Vector3d& point, std::size_t way) {
    const PartTip* const tip = ways_[way].tip().get();
    const ProgrammedWay& next = ways_[std::min(way + 1, ways_.size() - 1)];
    const bool rapid = ways_[way].rapid() && next.rapid();
    const double worst = (rapid ? blends_.rapid : blends_.feed).deviation_mm;
    const double least = run_distance(point, tip, distance_to_chords, worst);
    if (!(least > kMissed_mm) || least == kNowhere) return;
    if (point == ways_[way].end()) ++blends_.count;
    if (least > worst) note(run_distance(point, tip, distance_to_curve, worst), rapid, next.place());
}

/// Returns the distance of a point from the stored run of this tool; if it is missed by no more than
/// `enough`, any value up to it. kNowhere if the run is empty.
double WayDeviation::run_distance(const Vector3d& point, const PartTip* tip, CurveDistance distance,
                                  double enough) const {
    double least = kNowhere;
    for (const Driven& driven : run_) {
        const double of_use = least > enough ? least : kMissed_mm;
        if (driven.tip != tip || driven.box.squaredExteriorDistance(point) > of_use * of_use) continue;
        least = std::min(least, distance(point, driven.curve()));
    }
    return least;
}

/// Checks the ends of moves before this one that the run passes.
void WayDeviation::settle(rrs::TargetId until) {
    for (std::size_t way = 0; way < ways_.size() && ways_[way].id() < until; ++way) {
        if (ways_[way].id() < unsettled_) continue;
        const bool left_out = ways_[way].id() > passed_;
        if (left_out) {
            const std::span<const Vector3d> points = ways_[way].points();
            for (std::size_t i = 1; i + 1 < points.size(); ++i) measure_missed(points[i], way);
        }
        measure_missed(ways_[way].end(), way);
    }
    unsettled_ = std::max(unsettled_, until);
}

void WayDeviation::end_run(rrs::TargetId until) {
    settle(until);
    run_.clear();
}

/// Drops moves that take part in no later comparison.
void WayDeviation::drop_old() {
    const rrs::TargetId first = run_.empty() ? passed_ : std::min(run_.front().id, unsettled_);
    while (!ways_.empty() && ways_.front().id() < first) ways_.pop_front();
}

void WayDeviation::note(double deviation_mm, bool rapid, const Place& place) {
    Deviation& worst = rapid ? blends_.rapid : blends_.feed;
    if (deviation_mm > worst.deviation_mm) worst = {deviation_mm, place};
}

}  // namespace gsim::simulation
