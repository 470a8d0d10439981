#include "runtime/cell/clearance_watch.h"

#include <algorithm>
#include <utility>

namespace gsim::cell {

namespace {

constexpr double kLeastCutoff_mm = 2 * kContact_mm;
constexpr int kOverlapLooks = 24;

bool moves_with_links(Role role) {
    return role == Role::machine || role == Role::jet;
}

}  // namespace

ClearanceWatch::ClearanceWatch(const Cell& cell, const machine::Machine& machine)
    : cell_(cell), kinematics_(machine::make_kinematics(machine)) {
    make_pairs();
}

void ClearanceWatch::make_pairs() {
    pairs_.clear();
    parents_.clear();
    for (const CarriedFrame& carried : cell_.carried)
        parents_.push_back(cell_.frames.link(cell_.frames.parent(carried.frame)));
    for (std::size_t a = 0; a < cell_.items.size(); ++a) {
        for (std::size_t b = a + 1; b < cell_.items.size(); ++b) add_pair(a, b);
    }
}

Body ClearanceWatch::body(std::size_t item) const {
    const Item& of = cell_.items[item];
    return {&of.shape, cell_.frames.link(of.frame), cell_.frames.in_link(of.frame)};
}

bool ClearanceWatch::is_ignored(std::size_t a, std::size_t b) const {
    return std::any_of(cell_.ignored.begin(), cell_.ignored.end(), [&](const auto& pair) {
        return (pair.first == a && pair.second == b) || (pair.first == b && pair.second == a);
    });
}

// Bodies that do not move against each other cannot meet. Parts of the machine next to each other in the
// chain are made to touch.
void ClearanceWatch::add_pair(std::size_t a, std::size_t b) {
    const Body of_a = body(a);
    const Body of_b = body(b);
    const Role role_a = cell_.items[a].role;
    const Role role_b = cell_.items[b].role;
    const std::vector<int> between = joints_between(*kinematics_, of_a.link, of_b.link, parents_);
    if (between.empty() || is_ignored(a, b)) return;
    if (between.size() == 1 && moves_with_links(role_a) && moves_with_links(role_b)) return;
    const bool jet = role_a == Role::jet || role_b == Role::jet;
    if (jet && (role_a == Role::workpiece || role_b == Role::workpiece)) return;
    // What stands in the world is the one at rest.
    if (of_b.link == 0) {
        pairs_.push_back({{a, b}, jet, {of_a, of_b, between}, 0, std::nullopt});
    } else {
        pairs_.push_back({{b, a}, jet, {of_b, of_a, {between.rbegin(), between.rend()}}, 0, std::nullopt});
    }
}

void ClearanceWatch::frames_changed() {
    if (parents_.size() != cell_.carried.size()) return make_pairs();
    for (Watched& pair : pairs_) {
        pair.bodies.first = body(pair.items.first);
        pair.bodies.second = body(pair.items.second);
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
