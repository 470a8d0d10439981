#include "collision/monitor/clearance_monitor.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "collision/cell/placed_kinematics.h"
#include "collision/monitor/touch_search.h"

namespace gsim::cell {

namespace {

constexpr double kMinCutoff_mm = 2 * kContactTolerance_mm;
constexpr int kMaxDepthChecks = 24;
// Number of motions like this one for which a separation budget is sought.
constexpr double kMotionsAhead = 64;

}  // namespace

ClearanceMonitor::ClearanceMonitor(const Cell& cell, const machine::Machine& machine)
    : cell_(cell),
      machine_kinematics_(machine::make_kinematics(machine)),
      kinematics_(placed_kinematics(machine_kinematics_, cell.frames)) {
    make_pairs();
}

void ClearanceMonitor::make_pairs() {
    parents_ = moving_frame_parents(cell_);
    pairs_.clear();
    for (CandidatePair& pair : candidate_pairs(cell_, *kinematics_)) {
        const bool has_probe = is_probe(cell_, pair.items.first) != is_probe(cell_, pair.items.second);
        const bool feels = has_probe && !pair.includes_jet;
        pairs_.push_back({std::move(pair), feels});
    }
    make_clusters();
}

// Each pair joins the larger of its two clusters: many bodies at standstill may meet one that moves, or many
// that move one at standstill.
void ClearanceMonitor::make_clusters() {
    using Key = std::tuple<std::size_t, int, bool>;  // an item, a link, with the jet
    const auto first_body_key = [](const MonitoredPair& pair) {
        return Key{pair.items.first, pair.bodies.second.link, pair.includes_jet};
    };
    const auto second_body_key = [](const MonitoredPair& pair) {
        return Key{pair.items.second, pair.bodies.first.link, pair.includes_jet};
    };
    std::map<Key, std::size_t> sizes;
    for (const MonitoredPair& pair : pairs_) {
        ++sizes[first_body_key(pair)];
        ++sizes[second_body_key(pair)];
    }
    std::map<Key, std::size_t> clusters;
    clusters_.clear();
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        MonitoredPair& pair = pairs_[i];
        const bool second = sizes[second_body_key(pair)] > sizes[first_body_key(pair)];
        const auto [cluster, is_new] =
            clusters.try_emplace(second ? second_body_key(pair) : first_body_key(pair), clusters_.size());
        if (is_new) {
            std::vector<int> between = pair.bodies.between;
            if (second) std::reverse(between.begin(), between.end());
            clusters_.push_back(
                {second ? pair.bodies.second : pair.bodies.first, std::move(between), pair.includes_jet});
        }
        pair.cluster = cluster->second;
        clusters_[pair.cluster].pairs.push_back(i);
    }
    for (PairCluster& cluster : clusters_) reset_distances(cluster);
}

/// The distances of the cluster's pairs are no longer known.
void ClearanceMonitor::reset_distances(PairCluster& cluster) {
    cluster.travelled_mm = 0;
    std::vector<ScheduledPair> all;
    all.reserve(cluster.pairs.size());
    for (const std::size_t i : cluster.pairs) {
        pairs_[i].min_distance_mm = 0;
        all.push_back({0, i});
    }
    cluster.scheduled_pairs = std::priority_queue<ScheduledPair, std::vector<ScheduledPair>, std::greater<>>(
        std::greater<>(), std::move(all));
}

void ClearanceMonitor::deactivate(PairCluster& cluster) {
    if (cluster.is_off) return;
    cluster.is_off = true;
    for (const std::size_t i : cluster.pairs) pairs_[i].contact.reset();
    reset_distances(cluster);
}

void ClearanceMonitor::on_frames_changed() {
    add_budget_travel();
    kinematics_ = placed_kinematics(machine_kinematics_, cell_.frames);
    if (parents_.size() != cell_.moving_frames.size()) return make_pairs();
    for (MonitoredPair& pair : pairs_) {
        pair.bodies.first = make_body(cell_, pair.items.first);
        pair.bodies.second = make_body(cell_, pair.items.second);
        pair.contact.reset();
        pair.probe_touch.reset();
    }
    make_clusters();
}

void ClearanceMonitor::on_segment(const motion::Segment& segment, bool process_on, bool probing) {
    if (has_ended()) return;
    is_probing_ = probing;
    if (fits_budget(segment, process_on)) {
        ++sub_segment_number_;
        return;
    }
    add_budget_travel();
    double from_s = 0;
    double to_s = 0;
    do {
        to_s = sub_segment_end_s(segment, from_s);
        const std::vector<MovingLink> links =
            update_moving_links(segment.start_s + from_s + (to_s - from_s) / 2);
        const SegmentMotion motion(*kinematics_, segment, links);
        check_sub_segment(motion, motion.between(from_s, to_s), process_on);
        from_s = to_s;
    } while (to_s < segment.duration_s);
}

bool ClearanceMonitor::fits_budget(const motion::Segment& segment, bool process_on) {
    return process_on == budget_with_jet_ && budget_.spend(joint_travel(segment, 0, segment.duration_s));
}

/// Motion that stayed far from everything counts for all pairs.
void ClearanceMonitor::add_budget_travel() {
    const double travelled_mm = budget_.release_travelled_mm();
    budget_.clear();
    for (PairCluster& cluster : clusters_) cluster.travelled_mm += travelled_mm;
}

/// No separation budget exists next to something, which is checked the more seldom the longer it lasts.
/// Independent motion is not counted.
bool ClearanceMonitor::should_search_budget() {
    return cell_.moving_frames.empty() && budget_backoff_.is_due();
}

/// Sets how far all may move after a stretch before one of the pairs is due.
void ClearanceMonitor::update_budget(const MotionPart& motion_part, bool process_on) {
    const double near_mm = std::max(cell_.clearance_mm, kMinCutoff_mm);
    double budget_mm = std::numeric_limits<double>::infinity();
    double travel_mm = 0;
    for (const PairCluster& cluster : clusters_) {
        if (cluster.is_off) continue;
        budget_mm = std::min(budget_mm, cluster.scheduled_pairs.top().at_mm - cluster.travelled_mm - near_mm);
        travel_mm = std::max(travel_mm, cluster.travel_mm);
    }
    if (!SeparationBudget::is_worthwhile(budget_mm, travel_mm)) return;
    JointReach reach_mm{};
    for (const PairCluster& cluster : clusters_) {
        if (!cluster.is_off)
            motion_part.chain.expand(reach_mm, cluster.body.ball(motion_part.from), cluster.between);
    }
    budget_.set(budget_mm, reach_mm, travel_mm);
    budget_with_jet_ = process_on;
    budget_backoff_.reset();
}

void ClearanceMonitor::check_sub_segment(const SegmentMotion& motion, const MotionPart& motion_part,
                                         bool process_on) {
    ++sub_segment_number_;
    const bool searches_budget = should_search_budget();
    collect_due_pairs(motion_part, process_on, searches_budget);
    for (const std::size_t i : due_pairs_) {
        MonitoredPair& pair = pairs_[i];
        PairCluster& cluster = clusters_[pair.cluster];
        if (pair.checked_sub_segment + 1 != sub_segment_number_)
            pair.was_probed = false;  // it was far meanwhile
        pair.checked_sub_segment = sub_segment_number_;
        monitor_pair(motion, motion_part, pair);
        cluster.scheduled_pairs.push({cluster.travelled_mm + pair.min_distance_mm, i});
    }
    if (searches_budget) update_budget(motion_part, process_on);
}

/// Takes the pairs that may come near in a stretch out of their clusters.
void ClearanceMonitor::collect_due_pairs(const MotionPart& motion_part, bool process_on, bool with_margin) {
    due_pairs_.clear();
    double max_travel_mm = 0;
    for (PairCluster& cluster : clusters_) {
        if (cluster.includes_jet && !process_on) {
            deactivate(cluster);
            continue;
        }
        cluster.is_off = false;
        cluster.travel_mm =
            motion_part.chain.bound(cluster.body.ball(motion_part.from), cluster.between).travel_mm;
        max_travel_mm = std::max(max_travel_mm, cluster.travel_mm);
    }
    margin_mm_ = with_margin ? kMotionsAhead * max_travel_mm : 0;
    for (PairCluster& cluster : clusters_) {
        if (!cluster.is_off) collect_due_pairs(cluster);
    }
    std::sort(due_pairs_.begin(), due_pairs_.end());
}

void ClearanceMonitor::collect_due_pairs(PairCluster& cluster) {
    const double before_mm = cluster.travelled_mm;
    cluster.travelled_mm += cluster.travel_mm;
    const double near_mm = cutoff_mm() + margin_mm_;
    for (; !cluster.scheduled_pairs.empty() &&
           cluster.scheduled_pairs.top().at_mm - cluster.travelled_mm <= near_mm;
         cluster.scheduled_pairs.pop()) {
        const ScheduledPair& scheduled_pairs = cluster.scheduled_pairs.top();
        pairs_[scheduled_pairs.pair].min_distance_mm = scheduled_pairs.at_mm - before_mm;
        due_pairs_.push_back(scheduled_pairs.pair);
    }
}

/// Returns the distance below which something counts.
double ClearanceMonitor::cutoff_mm() const {
    return std::max(nearest_ ? nearest_->distance_mm : cell_.clearance_mm, kMinCutoff_mm);
}

/// Returns the time at which independent links next change their motion, or the segment ends.
double ClearanceMonitor::sub_segment_end_s(const motion::Segment& segment, double from_s) const {
    double end_s = segment.duration_s;
    for (const MovingFrame& moving_frames : cell_.moving_frames) {
        const auto change_s = moving_frames.trajectory.next_change_s(segment.start_s + from_s);
        if (change_s && *change_s - segment.start_s > from_s)
            end_s = std::min(end_s, *change_s - segment.start_s);
    }
    return end_s;
}

/// A link that changes its motion may have jumped: distances are not known then.
std::vector<MovingLink> ClearanceMonitor::update_moving_links(double time_s) {
    std::vector<MovingLink> links;
    std::vector<double> motion_starts_s;
    links.reserve(cell_.moving_frames.size());
    motion_starts_s.reserve(cell_.moving_frames.size());
    for (const MovingFrame& moving_frames : cell_.moving_frames) {
        const std::size_t parent = cell_.frames.parent(moving_frames.frame);
        links.push_back({cell_.frames.link(parent), cell_.frames.pose_in_link(parent),
                         moving_frames.trajectory.uniform_motion_at(time_s)});
        motion_starts_s.push_back(links.back().uniform_motion.from_s);
    }
    if (motion_starts_s != motion_starts_s_) {
        for (PairCluster& cluster : clusters_) reset_distances(cluster);
        motion_starts_s_ = std::move(motion_starts_s);
    }
    return links;
}

void ClearanceMonitor::monitor_pair(const SegmentMotion& motion, const MotionPart& full_motion,
                                    MonitoredPair& pair) {
    if (pair.contact) return continue_contact(motion, full_motion, pair, 0);
    if (pair.probe_touch) return continue_probe_contact(motion, full_motion, pair);
    const double near_mm = cutoff_mm();
    const double travel_mm = clusters_[pair.cluster].travel_mm;
    if (pair.min_distance_mm - travel_mm > near_mm) {
        pair.min_distance_mm -= travel_mm;
        pair.was_probed = false;
        return raise_min_distance(full_motion, pair);
    }
    if (has_ended()) return;
    const DistanceBounds distance_bounds = pair.bodies.nearest(motion, full_motion, near_mm);
    pair.min_distance_mm = distance_bounds.lower_mm;
    const bool is_exempt = is_exempt_probe_pair(full_motion, pair);
    if (distance_bounds.lower_mm <= kContactTolerance_mm) {
        if (is_probing_ && pair.has_probe) {
            begin_probe_contact(motion, full_motion, pair);
        } else {
            begin_contact(motion, full_motion, pair);
        }
    }
    if (!is_exempt) note(distance_bounds, pair, motion, full_motion);
    if (distance_bounds.lower_mm >= near_mm) raise_min_distance(full_motion, pair);
}

/// Sets, at the end of a part, how far a pair that is not near may move until it has to be checked, as far as
/// that is sought.
void ClearanceMonitor::raise_min_distance(const MotionPart& full_motion, MonitoredPair& pair) const {
    if (!(margin_mm_ > 0) || pair.min_distance_mm >= cutoff_mm() + margin_mm_) return;
    pair.min_distance_mm = std::max(pair.min_distance_mm, pair.bodies.box_separation_mm(full_motion.to));
}

void ClearanceMonitor::note(const DistanceBounds& distance_bounds, const MonitoredPair& pair,
                            const SegmentMotion& motion, const MotionPart& full_motion) {
    const double min_mm = nearest_ ? nearest_->distance_mm : cell_.clearance_mm;
    if (distance_bounds.upper_mm >= min_mm) return;
    nearest_ = Clearance{distance_bounds.upper_mm, pair.items, distance_bounds.point_mm};
    if (!records_times_) return;
    const auto within_s = pair.bodies.first_within_s(motion, full_motion, distance_bounds.upper_mm);
    if (within_s) nearest_->t_s = motion.segment().start_s + *within_s;
}

/// True if a pair may come near in a part because of the probe.
bool ClearanceMonitor::is_exempt_probe_pair(const MotionPart& full_motion, MonitoredPair& pair) const {
    if (!pair.has_probe || !(is_probing_ || pair.was_probed)) return false;
    const double clearance_mm = std::max(cell_.clearance_mm, kMinCutoff_mm);
    pair.was_probed =
        is_probing_ || pair.bodies.distance_at(full_motion.from, clearance_mm).lower_mm < clearance_mm;
    return pair.was_probed;
}

void ClearanceMonitor::begin_contact(const SegmentMotion& motion, const MotionPart& full_motion,
                                     MonitoredPair& pair) {
    const auto touch = pair.bodies.first_touch(motion, full_motion);
    if (!touch) return;
    note({0, 0, touch->point_mm}, pair, motion, full_motion);
    pair.contact = contacts_.size();
    pair.normal = touch->normal;
    contacts_.push_back({motion.segment().start_s + touch->t_s, pair.items, touch->point_mm, !touch->normal});
    continue_contact(motion, full_motion, pair, touch->t_s);
}

// The relative position of bodies that touched before the probing began is not known.
void ClearanceMonitor::begin_probe_contact(const SegmentMotion& motion, const MotionPart& full_motion,
                                           MonitoredPair& pair) {
    const auto touch = pair.bodies.first_touch(motion, full_motion);
    if (!touch || !touch->normal) return;
    const LinkFrames links = motion.links_at(touch->t_s);
    pair.probe_touch =
        ProbeContact{*touch->normal, pair.bodies.first.pose_in_world(links).inverse() * touch->point_mm,
                     pair.bodies.second.pose_in_world(links).inverse() * touch->point_mm};
    continue_probe_contact(motion, full_motion, pair);
}

void ClearanceMonitor::continue_probe_contact(const SegmentMotion& motion, const MotionPart& full_motion,
                                              MonitoredPair& pair) {
    pair.min_distance_mm = 0;
    const ProbeContact& contact_state = *pair.probe_touch;
    if (!is_probing_ && pair.bodies.penetration_increases(motion, full_motion.from_s, full_motion.to_s,
                                                          contact_state.normal, contact_state.depth_mm)) {
        pair.normal = pair.probe_touch->normal;
        pair.contact = contacts_.size();
        const Eigen::Vector3d point =
            pair.bodies.second.pose_in_world(full_motion.from) * pair.probe_touch->point_on_second_mm;
        contacts_.push_back({motion.segment().start_s + full_motion.from_s, pair.items, point, true});
        pair.probe_touch.reset();
        return continue_contact(motion, full_motion, pair, full_motion.from_s);
    }
    if (!pair.bodies.are_in_contact(full_motion.to)) {
        pair.probe_touch.reset();
    } else if (is_probing_) {
        ProbeContact& probe_touch = *pair.probe_touch;
        const Eigen::Isometry3d pose = pair.bodies.second.pose_in_world(full_motion.to).inverse() *
                                       pair.bodies.first.pose_in_world(full_motion.to);
        const double offset_mm =
            (pose * probe_touch.point_on_first_mm - probe_touch.point_on_second_mm).dot(probe_touch.normal);
        probe_touch.depth_mm = std::max(probe_touch.depth_mm, -offset_mm);
        // The path along the surface also runs deeper in a hollow.
        for (int sample = 0; sample < kMaxDepthChecks; ++sample) {
            if (!pair.bodies.overlaps(full_motion.to, probe_touch.normal, probe_touch.depth_mm)) break;
            probe_touch.depth_mm = 2 * probe_touch.depth_mm + kContactTolerance_mm;
        }
    }
}

// The distance is meaningless during a contact. So this checks if it becomes deeper, and if it has ended.
void ClearanceMonitor::continue_contact(const SegmentMotion& motion, const MotionPart& full_motion,
                                        MonitoredPair& pair, double from_s) {
    Contact& contact = contacts_[*pair.contact];
    note({0, 0, contact.point_mm}, pair, motion, full_motion);
    contact.penetrating = contact.penetrating ||
                          pair.bodies.penetration_increases(motion, from_s, full_motion.to_s, *pair.normal);
    pair.min_distance_mm = 0;
    if (!pair.bodies.are_in_contact(full_motion.to)) pair.contact.reset();
}

}  // namespace gsim::cell
