#include "collision/monitor/neighbour_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/kinematics/chain.h"

namespace gsim::cell {

namespace {

constexpr double kNear_mm = 2 * kContact_mm;
// Distances are searched up to the travel of this many stretches like the current one.
constexpr double kStretchesAhead = 64;
// Min and max of that search distance. The minimum avoids repeated checks of pairs that hardly move.
constexpr double kLeastAhead_mm = 1;
constexpr double kMostAhead_mm = 1000;

bool has_jet(const CarriedBody& body) {
    return body.role == Role::jet;
}

// Excludes jet and workpiece, because it may cut this, and two jets, which are not bodies.
bool may_meet(const CarriedBody& first, const CarriedBody& second) {
    if (first.joints.empty() && second.joints.empty()) return false;
    if (has_jet(first)) return second.role != Role::workpiece && !has_jet(second);
    return !has_jet(second) || first.role != Role::workpiece;
}

}  // namespace

void NeighbourWatch::set_bodies(std::shared_ptr<const MachineBodies> first,
                                std::shared_ptr<const MachineBodies> second) {
    machines_ = {std::move(first), std::move(second)};
    pairs_.clear();
    for (const CarriedBody& of_first : machines_[0]->bodies) {
        for (const CarriedBody& of_second : machines_[1]->bodies) {
            if (may_meet(of_first, of_second)) add_pair(of_first, of_second);
        }
    }
    forget_distances();
}

/// Numbers links and joints of the second machine after those of the first (TwoMachinesMotion).
void NeighbourWatch::add_pair(const CarriedBody& first, const CarriedBody& second) {
    const int joints = machines_[0]->kinematics->chain().joint_count();
    Body behind = second.body;
    behind.link += joints + 1;
    std::vector<int> between = first.joints;
    for (auto joint = second.joints.rbegin(); joint != second.joints.rend(); ++joint)
        between.push_back(joints + *joint);
    pairs_.push_back({{first.item, second.item},
                      {first.body, behind, std::move(between)},
                      {has_jet(first), has_jet(second)}});
}

/// Discards all distances between bodies, which are no longer known. Pairs with a jet that is off wait for
/// it.
void NeighbourWatch::forget_distances() {
    std::vector<Due> all;
    all.reserve(pairs_.size());
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        Watched& pair = pairs_[i];
        const bool is_off = (pair.jets[0] && !jets_[0]) || (pair.jets[1] && !jets_[1]);
        if (is_off) {
            pair.contact.reset();
        } else {
            all.push_back({0, i});
        }
    }
    gone_mm_ = 0;
    due_ = DueQueue(std::greater<>(), std::move(all));
}

void NeighbourWatch::take(double start_s, double duration_s, const Going& first, const Going& second) {
    if (pairs_.empty() || (cpu_ != nullptr && cpu_->reached())) return;
    const std::array jets{first.jet_on, second.jet_on};
    if (std::exchange(jets_, jets) != jets) forget_distances();
    const std::array stretches{
        MachineStretch{*machines_[0]->kinematics, worlds_[0], first.segment, first.from_s},
        MachineStretch{*machines_[1]->kinematics, worlds_[1], second.segment, second.from_s}};
    const std::array travels{stretches[0].travel(0, duration_s), stretches[1].travel(0, duration_s)};
    if (goes_on_far(travels)) return;
    measure_reaches(stretches, 0);
    if (goes_on_far(travels)) return;
    const double way_mm = reaches_[0].way_mm(travels[0]) + reaches_[1].way_mm(travels[1]);
    for (std::size_t i = 0; i < 2; ++i) reaches_[i].go_on(reaches_[i].way_mm(travels[i]));
    const TwoMachinesMotion motion(stretches[0], stretches[1]);
    look(start_s, motion, motion.between(0, duration_s), way_mm);
    if (!std::isfinite(way_mm)) measure_reaches(stretches, duration_s);
}

/// Returns true if no pair can touch meanwhile; the distance is then counted as travelled.
bool NeighbourWatch::goes_on_far(const std::array<JointTravel, 2>& travels) {
    if (due_.empty()) return true;
    const std::array ways_mm{reaches_[0].way_mm(travels[0]), reaches_[1].way_mm(travels[1])};
    const double way_mm = ways_mm[0] + ways_mm[1];
    if (!(gone_mm_ + way_mm + kNear_mm < due_.top().at_mm)) return false;
    gone_mm_ += way_mm;
    for (std::size_t i = 0; i < 2; ++i) reaches_[i].go_on(ways_mm[i]);
    return true;
}

void NeighbourWatch::measure_reaches(const std::array<MachineStretch, 2>& stretches, double t_s) {
    for (std::size_t i = 0; i < 2; ++i)
        reaches_[i].measure(reach_of(*machines_[i], stretches[i].joints_at(t_s)), 0);
}

/// Checks all pairs if the machines turn so far that ReachBound gives no distance.
void NeighbourWatch::look(double start_s, const TwoMachinesMotion& motion, const MotionPart& whole,
                          double way_mm) {
    if (std::isfinite(way_mm)) {
        gone_mm_ += way_mm;
    } else {
        forget_distances();
    }
    now_.clear();
    for (; !due_.empty() && due_.top().at_mm <= gone_mm_ + kNear_mm; due_.pop())
        now_.push_back(due_.top().pair);
    std::sort(now_.begin(), now_.end());
    const double ahead_mm = std::clamp(kStretchesAhead * way_mm, kLeastAhead_mm, kMostAhead_mm);
    for (const std::size_t i : now_)
        due_.push({gone_mm_ + look_at(start_s, motion, whole, pairs_[i], ahead_mm), i});
}

/// Returns a lower bound of their distance at the end.
double NeighbourWatch::look_at(double start_s, const TwoMachinesMotion& motion, const MotionPart& whole,
                               Watched& pair, double ahead_mm) {
    double from_s = 0;
    if (!pair.contact) {
        const auto touch = pair.bodies.first_touch(motion, whole);
        if (!touch) {
            const double apart_mm = pair.bodies.boxes_apart_mm(whole.to);
            if (apart_mm >= ahead_mm) return apart_mm;
            return pair.bodies.nearness_at(whole.to, ahead_mm).lower_mm;
        }
        from_s = touch->t_s;
        pair.contact = contacts_.size();
        pair.normal = touch->normal;
        contacts_.push_back({start_s + from_s, pair.items, touch->point_mm, !touch->normal});
    }
    Contact& contact = contacts_[*pair.contact];
    contact.penetrating =
        contact.penetrating || pair.bodies.goes_deeper(motion, from_s, whole.to_s, *pair.normal);
    if (!pair.bodies.touch_at(whole.to)) pair.contact.reset();
    return 0;
}

}  // namespace gsim::cell
