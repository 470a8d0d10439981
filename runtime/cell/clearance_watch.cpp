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
    for (std::size_t a = 0; a < cell.items.size(); ++a) {
        for (std::size_t b = a + 1; b < cell.items.size(); ++b) add_pair(a, b);
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
    const std::vector<int> between = joints_between(*kinematics_, of_a.link, of_b.link);
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
    for (Watched& pair : pairs_) {
        pair.bodies.first = body(pair.items.first);
        pair.bodies.second = body(pair.items.second);
        pair.at_least_mm = 0;
        pair.contact.reset();
    }
}

void ClearanceWatch::take(const motion::Segment& segment, bool jet_on) {
    const SegmentMotion motion(*kinematics_, segment);
    const MotionPart whole = motion.whole();
    for (Watched& pair : pairs_) {
        if (pair.with_jet && !jet_on) {
            pair.at_least_mm = 0;
            pair.contact.reset();
        } else {
            watch(motion, whole, pair);
        }
    }
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
