#include "collision/monitor/clearance_watch.h"

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

constexpr double kLeastCutoff_mm = 2 * kContact_mm;
constexpr int kHollowLooks = 24;
// Number of motions like this one for which a separation budget is sought,
constexpr double kMotionsAhead = 64;
// and the max number of checks until it is sought again.
constexpr int kLongestPause = 64;

}  // namespace

ClearanceWatch::ClearanceWatch(const Cell& cell, const machine::Machine& machine)
    : cell_(cell),
      machine_kinematics_(machine::make_kinematics(machine)),
      kinematics_(placed_kinematics(machine_kinematics_, cell.frames)) {
    make_pairs();
}

void ClearanceWatch::make_pairs() {
    parents_ = carried_parents(cell_);
    pairs_.clear();
    for (MeetingPair& pair : meeting_pairs(cell_, *kinematics_)) {
        const bool by_probe = probes(cell_, pair.items.first) != probes(cell_, pair.items.second);
        const bool feels = by_probe && !pair.with_jet;
        pairs_.push_back({std::move(pair), feels});
    }
    make_crowds();
}

// Each pair joins the larger of its two clusters: many bodies at standstill may meet one that moves, or many
// that move one at standstill.
void ClearanceWatch::make_crowds() {
    using Key = std::tuple<std::size_t, int, bool>;  // an item, a link, with the jet
    const auto by_first = [](const Watched& pair) {
        return Key{pair.items.first, pair.bodies.second.link, pair.with_jet};
    };
    const auto by_second = [](const Watched& pair) {
        return Key{pair.items.second, pair.bodies.first.link, pair.with_jet};
    };
    std::map<Key, std::size_t> sizes;
    for (const Watched& pair : pairs_) {
        ++sizes[by_first(pair)];
        ++sizes[by_second(pair)];
    }
    std::map<Key, std::size_t> crowds;
    crowds_.clear();
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        Watched& pair = pairs_[i];
        const bool second = sizes[by_second(pair)] > sizes[by_first(pair)];
        const auto [crowd, is_new] =
            crowds.try_emplace(second ? by_second(pair) : by_first(pair), crowds_.size());
        if (is_new) {
            std::vector<int> between = pair.bodies.between;
            if (second) std::reverse(between.begin(), between.end());
            crowds_.push_back(
                {second ? pair.bodies.second : pair.bodies.first, std::move(between), pair.with_jet});
        }
        pair.crowd = crowd->second;
        crowds_[pair.crowd].pairs.push_back(i);
    }
    for (Crowd& crowd : crowds_) forget_distances(crowd);
}

/// The distances of the cluster's pairs are no longer known.
void ClearanceWatch::forget_distances(Crowd& crowd) {
    crowd.gone_mm = 0;
    std::vector<Due> all;
    all.reserve(crowd.pairs.size());
    for (const std::size_t i : crowd.pairs) {
        pairs_[i].at_least_mm = 0;
        all.push_back({0, i});
    }
    crowd.due = std::priority_queue<Due, std::vector<Due>, std::greater<>>(std::greater<>(), std::move(all));
}

void ClearanceWatch::switch_off(Crowd& crowd) {
    if (crowd.is_off) return;
    crowd.is_off = true;
    for (const std::size_t i : crowd.pairs) pairs_[i].contact.reset();
    forget_distances(crowd);
}

void ClearanceWatch::frames_changed() {
    go_on_far();
    kinematics_ = placed_kinematics(machine_kinematics_, cell_.frames);
    if (parents_.size() != cell_.carried.size()) return make_pairs();
    for (Watched& pair : pairs_) {
        pair.bodies.first = body_of(cell_, pair.items.first);
        pair.bodies.second = body_of(cell_, pair.items.second);
        pair.contact.reset();
        pair.touched.reset();
    }
    make_crowds();
}

void ClearanceWatch::take(const motion::Segment& segment, bool jet_on, bool probing) {
    if (has_ended()) return;
    probing_ = probing;
    if (is_far(segment, jet_on)) {
        ++stretch_;
        return;
    }
    go_on_far();
    double from_s = 0;
    double to_s = 0;
    do {
        to_s = stretch_end_s(segment, from_s);
        const std::vector<DriftingLink> links = drifting(segment.start_s + from_s + (to_s - from_s) / 2);
        const SegmentMotion motion(*kinematics_, segment, links);
        take_stretch(motion, motion.between(from_s, to_s), jet_on);
        from_s = to_s;
    } while (to_s < segment.duration_s);
}

bool ClearanceWatch::is_far(const motion::Segment& segment, bool jet_on) {
    return jet_on == leeway_with_jet_ && leeway_.take(travel_of(segment, 0, segment.duration_s));
}

/// Motion that stayed far from everything counts for all pairs.
void ClearanceWatch::go_on_far() {
    const double gone_mm = leeway_.release_gone_mm();
    leeway_.clear();
    for (Crowd& crowd : crowds_) crowd.gone_mm += gone_mm;
}

/// No separation budget exists next to something, which is checked the more seldom the longer it lasts.
/// Independent motion is not counted.
bool ClearanceWatch::seeks_leeway() {
    if (!cell_.carried.empty() || leeway_pause_-- > 0) return false;
    leeway_pause_ = next_pause_;
    next_pause_ = std::min(2 * next_pause_, kLongestPause);
    return true;
}

/// Sets how far all may move after a stretch before one of the pairs is due.
void ClearanceWatch::find_leeway(const MotionPart& stretch, bool jet_on) {
    const double near_mm = std::max(cell_.clearance_mm, kLeastCutoff_mm);
    double slack_mm = std::numeric_limits<double>::infinity();
    double way_mm = 0;
    for (const Crowd& crowd : crowds_) {
        if (crowd.is_off) continue;
        slack_mm = std::min(slack_mm, crowd.due.top().at_mm - crowd.gone_mm - near_mm);
        way_mm = std::max(way_mm, crowd.way_mm);
    }
    if (!Leeway::pays(slack_mm, way_mm)) return;
    JointReach reach_mm{};
    for (const Crowd& crowd : crowds_) {
        if (!crowd.is_off) stretch.chain.widen(reach_mm, crowd.body.ball(stretch.from), crowd.between);
    }
    leeway_.set(slack_mm, reach_mm, way_mm);
    leeway_with_jet_ = jet_on;
    leeway_pause_ = 0;
    next_pause_ = 1;
}

void ClearanceWatch::take_stretch(const SegmentMotion& motion, const MotionPart& stretch, bool jet_on) {
    ++stretch_;
    const bool seeks = seeks_leeway();
    collect_due(stretch, jet_on, seeks);
    for (const std::size_t i : due_) {
        Watched& pair = pairs_[i];
        Crowd& crowd = crowds_[pair.crowd];
        if (pair.looked + 1 != stretch_) pair.probed = false;  // it was far meanwhile
        pair.looked = stretch_;
        watch(motion, stretch, pair);
        crowd.due.push({crowd.gone_mm + pair.at_least_mm, i});
    }
    if (seeks) find_leeway(stretch, jet_on);
}

/// Takes the pairs that may come near in a stretch out of their clusters.
void ClearanceWatch::collect_due(const MotionPart& stretch, bool jet_on, bool early) {
    due_.clear();
    double longest_mm = 0;
    for (Crowd& crowd : crowds_) {
        if (crowd.with_jet && !jet_on) {
            switch_off(crowd);
            continue;
        }
        crowd.is_off = false;
        crowd.way_mm = stretch.chain.bound(crowd.body.ball(stretch.from), crowd.between).way_mm;
        longest_mm = std::max(longest_mm, crowd.way_mm);
    }
    early_mm_ = early ? kMotionsAhead * longest_mm : 0;
    for (Crowd& crowd : crowds_) {
        if (!crowd.is_off) collect_due(crowd);
    }
    std::sort(due_.begin(), due_.end());
}

void ClearanceWatch::collect_due(Crowd& crowd) {
    const double before_mm = crowd.gone_mm;
    crowd.gone_mm += crowd.way_mm;
    const double near_mm = cutoff_mm() + early_mm_;
    for (; !crowd.due.empty() && crowd.due.top().at_mm - crowd.gone_mm <= near_mm; crowd.due.pop()) {
        const Due& due = crowd.due.top();
        pairs_[due.pair].at_least_mm = due.at_mm - before_mm;
        due_.push_back(due.pair);
    }
}

/// Returns the distance below which something counts.
double ClearanceWatch::cutoff_mm() const {
    return std::max(nearest_ ? nearest_->distance_mm : cell_.clearance_mm, kLeastCutoff_mm);
}

/// Returns the time at which independent links next change their motion, or the segment ends.
double ClearanceWatch::stretch_end_s(const motion::Segment& segment, double from_s) const {
    double end_s = segment.duration_s;
    for (const CarriedFrame& carried : cell_.carried) {
        const auto change_s = carried.carrier.next_change_s(segment.start_s + from_s);
        if (change_s && *change_s - segment.start_s > from_s)
            end_s = std::min(end_s, *change_s - segment.start_s);
    }
    return end_s;
}

/// A link that changes its motion may have jumped: distances are not known then.
std::vector<DriftingLink> ClearanceWatch::drifting(double time_s) {
    std::vector<DriftingLink> links;
    std::vector<double> since_s;
    links.reserve(cell_.carried.size());
    since_s.reserve(cell_.carried.size());
    for (const CarriedFrame& carried : cell_.carried) {
        const std::size_t parent = cell_.frames.parent(carried.frame);
        links.push_back(
            {cell_.frames.link(parent), cell_.frames.in_link(parent), carried.carrier.drift_at(time_s)});
        since_s.push_back(links.back().drift.from_s);
    }
    if (since_s != drifts_since_s_) {
        for (Crowd& crowd : crowds_) forget_distances(crowd);
        drifts_since_s_ = std::move(since_s);
    }
    return links;
}

void ClearanceWatch::watch(const SegmentMotion& motion, const MotionPart& whole, Watched& pair) {
    if (pair.contact) return go_on_in_contact(motion, whole, pair, 0);
    if (pair.touched) return go_on_touched(motion, whole, pair);
    const double near_mm = cutoff_mm();
    const double way_mm = crowds_[pair.crowd].way_mm;
    if (pair.at_least_mm - way_mm > near_mm) {
        pair.at_least_mm -= way_mm;
        pair.probed = false;
        return look_ahead(whole, pair);
    }
    if (has_ended()) return;
    const Nearness nearness = pair.bodies.nearest(motion, whole, near_mm);
    pair.at_least_mm = nearness.lower_mm;
    const bool let_near = is_let_near(whole, pair);
    if (nearness.lower_mm <= kContact_mm) {
        if (probing_ && pair.by_probe) {
            probe_contact(motion, whole, pair);
        } else {
            begin_contact(motion, whole, pair);
        }
    }
    if (!let_near) note(nearness, pair, motion, whole);
    if (nearness.lower_mm >= near_mm) look_ahead(whole, pair);
}

/// Sets, at the end of a part, how far a pair that is not near may move until it has to be checked, as far as
/// that is sought.
void ClearanceWatch::look_ahead(const MotionPart& whole, Watched& pair) const {
    if (!(early_mm_ > 0) || pair.at_least_mm >= cutoff_mm() + early_mm_) return;
    pair.at_least_mm = std::max(pair.at_least_mm, pair.bodies.boxes_apart_mm(whole.to));
}

void ClearanceWatch::note(const Nearness& nearness, const Watched& pair, const SegmentMotion& motion,
                          const MotionPart& whole) {
    const double least_mm = nearest_ ? nearest_->distance_mm : cell_.clearance_mm;
    if (nearness.upper_mm >= least_mm) return;
    nearest_ = Clearance{nearness.upper_mm, pair.items, nearness.point_mm};
    if (!keeps_times_) return;
    const auto within_s = pair.bodies.first_within_s(motion, whole, nearness.upper_mm);
    if (within_s) nearest_->t_s = motion.segment().start_s + *within_s;
}

/// True if a pair may come near in a part because of the probe.
bool ClearanceWatch::is_let_near(const MotionPart& whole, Watched& pair) const {
    if (!pair.by_probe || !(probing_ || pair.probed)) return false;
    const double clearance_mm = std::max(cell_.clearance_mm, kLeastCutoff_mm);
    pair.probed = probing_ || pair.bodies.nearness_at(whole.from, clearance_mm).lower_mm < clearance_mm;
    return pair.probed;
}

void ClearanceWatch::begin_contact(const SegmentMotion& motion, const MotionPart& whole, Watched& pair) {
    const auto touch = pair.bodies.first_touch(motion, whole);
    if (!touch) return;
    note({0, 0, touch->point_mm}, pair, motion, whole);
    pair.contact = contacts_.size();
    pair.normal = touch->normal;
    contacts_.push_back({motion.segment().start_s + touch->t_s, pair.items, touch->point_mm, !touch->normal});
    go_on_in_contact(motion, whole, pair, touch->t_s);
}

// The relative position of bodies that touched before the probing began is not known.
void ClearanceWatch::probe_contact(const SegmentMotion& motion, const MotionPart& whole, Watched& pair) {
    const auto touch = pair.bodies.first_touch(motion, whole);
    if (!touch || !touch->normal) return;
    const LinkFrames links = motion.links_at(touch->t_s);
    pair.touched = Touched{*touch->normal, pair.bodies.first.in_world(links).inverse() * touch->point_mm,
                           pair.bodies.second.in_world(links).inverse() * touch->point_mm};
    go_on_touched(motion, whole, pair);
}

void ClearanceWatch::go_on_touched(const SegmentMotion& motion, const MotionPart& whole, Watched& pair) {
    pair.at_least_mm = 0;
    const Touched& felt = *pair.touched;
    if (!probing_ && pair.bodies.goes_deeper(motion, whole.from_s, whole.to_s, felt.normal, felt.depth_mm)) {
        pair.normal = pair.touched->normal;
        pair.contact = contacts_.size();
        const Eigen::Vector3d point = pair.bodies.second.in_world(whole.from) * pair.touched->on_second_mm;
        contacts_.push_back({motion.segment().start_s + whole.from_s, pair.items, point, true});
        pair.touched.reset();
        return go_on_in_contact(motion, whole, pair, whole.from_s);
    }
    if (!pair.bodies.touch_at(whole.to)) {
        pair.touched.reset();
    } else if (probing_) {
        Touched& touched = *pair.touched;
        const Eigen::Isometry3d pose =
            pair.bodies.second.in_world(whole.to).inverse() * pair.bodies.first.in_world(whole.to);
        const double out_mm = (pose * touched.on_first_mm - touched.on_second_mm).dot(touched.normal);
        touched.depth_mm = std::max(touched.depth_mm, -out_mm);
        // The path along the surface also runs deeper in a hollow.
        for (int look = 0; look < kHollowLooks; ++look) {
            if (!pair.bodies.overlaps(whole.to, touched.normal, touched.depth_mm)) break;
            touched.depth_mm = 2 * touched.depth_mm + kContact_mm;
        }
    }
}

// The distance is meaningless during a contact. So this checks if it becomes deeper, and if it has ended.
void ClearanceWatch::go_on_in_contact(const SegmentMotion& motion, const MotionPart& whole, Watched& pair,
                                      double from_s) {
    Contact& contact = contacts_[*pair.contact];
    note({0, 0, contact.point_mm}, pair, motion, whole);
    contact.penetrating =
        contact.penetrating || pair.bodies.goes_deeper(motion, from_s, whole.to_s, *pair.normal);
    pair.at_least_mm = 0;
    if (!pair.bodies.touch_at(whole.to)) pair.contact.reset();
}

}  // namespace gsim::cell
