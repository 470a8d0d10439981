#include "collision/monitor/neighbour_monitor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/kinematics/chain.h"

namespace gsim::cell {

namespace {

constexpr double kContactDistance_mm = 2 * kContactTolerance_mm;
// Distances are searched up to the travel of this many stretches like the current one.
constexpr double kSubSegmentsAhead = 64;
// Min and max of that search distance. The minimum avoids repeated checks of pairs that hardly move.
constexpr double kMinAhead_mm = 1;
constexpr double kMaxAhead_mm = 1000;

bool has_jet(const CarriedBody& body) {
    return body.role == Role::jet;
}

// Excludes jet and workpiece, because it may cut this, and two jets, which are not bodies.
bool can_collide(const CarriedBody& first, const CarriedBody& second) {
    if (first.joints.empty() && second.joints.empty()) return false;
    if (has_jet(first)) return second.role != Role::workpiece && !has_jet(second);
    return !has_jet(second) || first.role != Role::workpiece;
}

}  // namespace

void NeighbourMonitor::set_bodies(std::shared_ptr<const MachineBodies> first,
                                  std::shared_ptr<const MachineBodies> second) {
    machines_ = {std::move(first), std::move(second)};
    pairs_.clear();
    for (const CarriedBody& first_body : machines_[0]->bodies) {
        for (const CarriedBody& second_body : machines_[1]->bodies) {
            if (can_collide(first_body, second_body)) add_pair(first_body, second_body);
        }
    }
    reset_distances();
}

/// Numbers links and joints of the second machine on from those of the first (TwoMachinesMotion).
void NeighbourMonitor::add_pair(const CarriedBody& first, const CarriedBody& second) {
    const int joints = machines_[0]->kinematics->chain().joint_count();
    Body trailing_body = second.body;
    trailing_body.link += joints + 1;
    std::vector<int> between = first.joints;
    for (auto joint = second.joints.rbegin(); joint != second.joints.rend(); ++joint)
        between.push_back(joints + *joint);
    pairs_.push_back({{first.item, second.item},
                      {first.body, trailing_body, std::move(between)},
                      {has_jet(first), has_jet(second)}});
}

/// Discards all distances between bodies, which are no longer known. Pairs with a jet that is off wait for
/// it.
void NeighbourMonitor::reset_distances() {
    std::vector<ScheduledPair> all;
    all.reserve(pairs_.size());
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        MonitoredPair& pair = pairs_[i];
        const bool is_off = (pair.jets[0] && !jets_[0]) || (pair.jets[1] && !jets_[1]);
        if (is_off) {
            pair.contact.reset();
        } else {
            all.push_back({0, i});
        }
    }
    travelled_mm_ = 0;
    scheduled_pairs_ = ScheduleQueue(std::greater<>(), std::move(all));
}

void NeighbourMonitor::on_segment(double start_s, double duration_s, const ActiveSegment& first,
                                  const ActiveSegment& second) {
    if (pairs_.empty() || (cpu_limit_ != nullptr && cpu_limit_->reached())) return;
    const std::array jets{first.process_on, second.process_on};
    if (std::exchange(jets_, jets) != jets) reset_distances();
    const std::array motion_parts{
        MachineMotion{*machines_[0]->kinematics, world_frames_[0], first.segment, first.from_s},
        MachineMotion{*machines_[1]->kinematics, world_frames_[1], second.segment, second.from_s}};
    const std::array travels{motion_parts[0].travel(0, duration_s), motion_parts[1].travel(0, duration_s)};
    if (stays_clear(travels)) return;
    measure_reaches(motion_parts, 0);
    if (stays_clear(travels)) return;
    const double travel_mm = reaches_[0].travel_mm(travels[0]) + reaches_[1].travel_mm(travels[1]);
    for (std::size_t i = 0; i < 2; ++i) reaches_[i].advance(reaches_[i].travel_mm(travels[i]));
    const TwoMachinesMotion motion(motion_parts[0], motion_parts[1]);
    check_pairs(start_s, motion, motion.between(0, duration_s), travel_mm);
    if (!std::isfinite(travel_mm)) measure_reaches(motion_parts, duration_s);
}

/// Returns true if no pair can touch meanwhile; the distance is then counted as travelled.
bool NeighbourMonitor::stays_clear(const std::array<JointTravel, 2>& travels) {
    if (scheduled_pairs_.empty()) return true;
    const std::array travels_mm{reaches_[0].travel_mm(travels[0]), reaches_[1].travel_mm(travels[1])};
    const double travel_mm = travels_mm[0] + travels_mm[1];
    if (!(travelled_mm_ + travel_mm + kContactDistance_mm < scheduled_pairs_.top().at_mm)) return false;
    travelled_mm_ += travel_mm;
    for (std::size_t i = 0; i < 2; ++i) reaches_[i].advance(travels_mm[i]);
    return true;
}

void NeighbourMonitor::measure_reaches(const std::array<MachineMotion, 2>& motion_parts, double t_s) {
    for (std::size_t i = 0; i < 2; ++i)
        reaches_[i].measure(joint_reach(*machines_[i], motion_parts[i].joints_at(t_s)), 0);
}

/// Checks all pairs if the machines turn so far that ReachBound gives no distance.
void NeighbourMonitor::check_pairs(double start_s, const TwoMachinesMotion& motion,
                                   const MotionPart& full_motion, double travel_mm) {
    if (std::isfinite(travel_mm)) {
        travelled_mm_ += travel_mm;
    } else {
        reset_distances();
    }
    due_pairs_.clear();
    for (; !scheduled_pairs_.empty() && scheduled_pairs_.top().at_mm <= travelled_mm_ + kContactDistance_mm;
         scheduled_pairs_.pop())
        due_pairs_.push_back(scheduled_pairs_.top().pair);
    std::sort(due_pairs_.begin(), due_pairs_.end());
    const double search_limit_mm = std::clamp(kSubSegmentsAhead * travel_mm, kMinAhead_mm, kMaxAhead_mm);
    for (const std::size_t i : due_pairs_)
        scheduled_pairs_.push(
            {travelled_mm_ + check_ahead(start_s, motion, full_motion, pairs_[i], search_limit_mm), i});
}

/// Returns a lower bound of their distance at the end.
double NeighbourMonitor::check_ahead(double start_s, const TwoMachinesMotion& motion,
                                     const MotionPart& full_motion, MonitoredPair& pair,
                                     double search_limit_mm) {
    double from_s = 0;
    if (!pair.contact) {
        const auto touch = pair.bodies.first_touch(motion, full_motion);
        if (!touch) {
            const double separation_mm = pair.bodies.box_separation_mm(full_motion.to);
            if (separation_mm >= search_limit_mm) return separation_mm;
            return pair.bodies.distance_at(full_motion.to, search_limit_mm).lower_mm;
        }
        from_s = touch->t_s;
        pair.contact = contacts_.size();
        pair.normal = touch->normal;
        contacts_.push_back({start_s + from_s, pair.items, touch->point_mm, !touch->normal});
    }
    Contact& contact = contacts_[*pair.contact];
    contact.penetrating = contact.penetrating ||
                          pair.bodies.penetration_increases(motion, from_s, full_motion.to_s, *pair.normal);
    if (!pair.bodies.are_in_contact(full_motion.to)) pair.contact.reset();
    return 0;
}

}  // namespace gsim::cell
