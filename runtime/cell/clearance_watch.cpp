#include "runtime/cell/clearance_watch.h"

#include <algorithm>
#include <utility>

namespace gsim::cell {

namespace {

constexpr double kLeastCutoff_mm = 2 * kContact_mm;
constexpr int kOverlapLooks = 24;

}  // namespace

ClearanceWatch::ClearanceWatch(const Cell& cell, const machine::Machine& machine)
    : cell_(cell), kinematics_(machine::make_kinematics(machine)) {
    make_pairs();
}

void ClearanceWatch::make_pairs() {
    parents_ = carried_parents(cell_);
    pairs_.clear();
    for (MeetingPair& pair : meeting_pairs(cell_, *kinematics_)) pairs_.push_back({std::move(pair)});
}

void ClearanceWatch::frames_changed() {
    if (parents_.size() != cell_.carried.size()) return make_pairs();
    for (Watched& pair : pairs_) {
        pair.bodies.first = body_of(cell_, pair.items.first);
        pair.bodies.second = body_of(cell_, pair.items.second);
        pair.at_least_mm = 0;
        pair.contact.reset();
    }
}

void ClearanceWatch::take(const motion::Segment& segment, bool jet_on) {
    double from_s = 0;
    double to_s = 0;
    do {
        to_s = stretch_end_s(segment, from_s);
        const std::vector<DriftingLink> links = drifting(segment.start_s + from_s + (to_s - from_s) / 2);
        const SegmentMotion motion(*kinematics_, segment, links);
        const MotionPart stretch = motion.between(from_s, to_s);
        for (Watched& pair : pairs_) {
            if (pair.with_jet && !jet_on) {
                pair.at_least_mm = 0;
                pair.contact.reset();
            } else {
                watch(motion, stretch, pair);
            }
        }
        from_s = to_s;
    } while (to_s < segment.duration_s);
}

/// Where links that go by themselves next go otherwise, or the segment ends.
double ClearanceWatch::stretch_end_s(const motion::Segment& segment, double from_s) const {
    double end_s = segment.duration_s;
    for (const CarriedFrame& carried : cell_.carried) {
        const auto change_s = carried.carrier.next_change_s(segment.start_s + from_s);
        if (change_s && *change_s - segment.start_s > from_s)
            end_s = std::min(end_s, *change_s - segment.start_s);
    }
    return end_s;
}

/// What goes otherwise than before may have jumped: distances are not known then.
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
        for (Watched& pair : pairs_) pair.at_least_mm = 0;
        drifts_since_s_ = std::move(since_s);
    }
    return links;
}

void ClearanceWatch::watch(const SegmentMotion& motion, const MotionPart& whole, Watched& pair) {
    if (pair.contact) return go_on_in_contact(motion, whole, pair, 0);
    const double least_mm = nearest_ ? nearest_->distance_mm : cell_.clearance_mm;
    const double cutoff_mm = std::max(least_mm, kLeastCutoff_mm);
    const double way_mm = pair.bodies.bound(whole).way_mm;
    if (pair.at_least_mm - way_mm > cutoff_mm) {
        pair.at_least_mm -= way_mm;
        return;
    }
    const Nearness nearness = pair.bodies.nearest(motion, whole, cutoff_mm);
    pair.at_least_mm = nearness.lower_mm;
    if (nearness.lower_mm <= kContact_mm) begin_contact(motion, whole, pair);
    note(nearness, pair);
}

void ClearanceWatch::note(const Nearness& nearness, const Watched& pair) {
    const double least_mm = nearest_ ? nearest_->distance_mm : cell_.clearance_mm;
    if (nearness.upper_mm < least_mm) nearest_ = {nearness.upper_mm, pair.items, nearness.point_mm};
}

void ClearanceWatch::begin_contact(const SegmentMotion& motion, const MotionPart& whole, Watched& pair) {
    const auto touch = pair.bodies.first_touch(motion, whole);
    if (!touch) return;
    note({0, 0, touch->point_mm}, pair);
    pair.contact = contacts_.size();
    pair.normal = touch->normal;
    contacts_.push_back({motion.segment().start_s + touch->t_s, pair.items, touch->point_mm, !touch->normal});
    go_on_in_contact(motion, whole, pair, touch->t_s);
}

// In a contact the distance tells no more; whether it goes deeper does, and whether it has ended. Most that
// goes deeper does so soon, so that looks are the closer to each other the sooner they are.
void ClearanceWatch::go_on_in_contact(const SegmentMotion& motion, const MotionPart& whole, Watched& pair,
                                      double from_s) {
    Contact& contact = contacts_[*pair.contact];
    note({0, 0, contact.point_mm}, pair);
    double look_s = whole.to_s - from_s;
    for (int look = 0; look < kOverlapLooks && !contact.penetrating; ++look, look_s /= 2)
        contact.penetrating = pair.bodies.overlaps(motion.links_at(from_s + look_s), *pair.normal);
    pair.at_least_mm = 0;
    if (pair.bodies.nearness_at(whole.to, kLeastCutoff_mm).upper_mm > kContact_mm) pair.contact.reset();
}

}  // namespace gsim::cell
