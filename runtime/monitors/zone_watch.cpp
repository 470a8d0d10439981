#include "runtime/monitors/zone_watch.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "motion/planner/stop.h"

namespace gsim::simulation {

using motion::Segment;

namespace {

std::array<int, 3> position_joints(const machine::Machine& machine) {
    std::array<int, 3> joints{-1, -1, -1};
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const auto axis = machine.find(static_cast<char>('X' + i));
        if (axis && machine.axes[*axis].kind == machine::AxisKind::linear)
            joints[i] = static_cast<int>(*axis);
    }
    return joints;
}

/// Returns the first `t_s` of a segment, however long that may be.
Segment cut(const Segment& segment, double t_s) {
    if (t_s > 0) return t_s < segment.duration_s ? motion::segment_until(segment, t_s) : segment;
    Segment none;
    none.target_id = segment.target_id;
    none.start_s = segment.start_s;
    none.start = none.end = segment.start;
    none.reaches_target = false;
    return none;
}

}  // namespace

ZoneWatch::ZoneWatch(const machine::Machine& machine, motion::SegmentSink& next)
    : machine_(machine), next_(next), joints_(position_joints(machine)) {}

void ZoneWatch::add_zones(const machine::MachineData& data) {
    for (const auto& [number, zone] : data.security_zones)
        add_zone(fmt::format("security zone {}", number), zone);
    if (data.working_zone) add_zone("the working zone", *data.working_zone);
    renew_boxes();
}

std::vector<ZoneRule> ZoneWatch::rules() const {
    std::vector<ZoneRule> rules;
    rules.reserve(zones_.size());
    for (const Known& zone : zones_) rules.push_back({zone.name, zone.limits, zone.stay_inside, zone.on});
    return rules;
}

void ZoneWatch::add_zone(std::string name, const machine::Zone& zone) {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const char letter = static_cast<char>('X' + i);
        if (zone.limits[i] && joints_[i] < 0 && missing_axes_.find(letter) == std::string::npos)
            missing_axes_ += letter;
    }
    zones_.push_back({std::move(name), zone.limits, zone.kind != machine::ZoneKind::enter_forbidden,
                      zone.active_at_start, zone.switch_number});
}

// The program is read ahead of the motion. So a change by a word holds from the first move after it, wherever
// the machine is when the word is read.
bool ZoneWatch::switch_zones(int switch_number, bool on, rrs::TargetId from) {
    const auto has_number = [switch_number](const Known& zone) {
        return zone.switch_number == switch_number;
    };
    if (std::none_of(zones_.begin(), zones_.end(), has_number)) return false;
    changes_.push_back({from, [this, has_number, on](const rrs::JointPos&) {
                            for (Known& zone : zones_) zone.on = has_number(zone) ? on : zone.on;
                        }});
    return true;
}

void ZoneWatch::set_programmed(const std::optional<ZoneWalls>& limits, rrs::TargetId from) {
    changes_.push_back({from, [this, limits](const rrs::JointPos& at) {
                            programmed_.reset();
                            if (!limits) return;
                            // G22 keeps the tool in or out, depending on the side of the machine when it
                            // takes effect.
                            const bool inside = box_of(*limits, false).contains(at);
                            programmed_ = {"the zone of G22", *limits, inside, true, {}};
                        }});
}

void ZoneWatch::set_tool_offset(const Eigen::Vector3d& offset_mm, rrs::TargetId from) {
    changes_.push_back({from, [this, offset_mm](const rrs::JointPos&) { offset_mm_ = offset_mm; }});
}

void ZoneWatch::make_changes(const Segment& segment) {
    if (changes_.front().from > segment.target_id) return;
    while (!changes_.empty() && changes_.front().from <= segment.target_id) {
        changes_.front().make(segment.start);
        changes_.pop_front();
    }
    renew_boxes();
}

void ZoneWatch::renew_boxes() {
    active_.clear();
    for (Known& zone : zones_) {
        if (zone.on) active_.push_back(&zone);
        if (!zone.on) zone.stay.reset();
    }
    if (programmed_) active_.push_back(&*programmed_);
    // Walls are at those of the work frame, shifted by the tool: a box for each tool, not a sum for each
    // segment.
    for (Known* zone : active_) zone->box = box_of(zone->limits, zone->stay_inside);
    const auto has_no_walls = [](const Known* zone) { return zone->box.sides().empty(); };
    active_.erase(std::remove_if(active_.begin(), active_.end(), has_no_walls), active_.end());
}

ZoneBox ZoneWatch::box_of(const ZoneWalls& limits, bool stay_inside) const {
    ZoneBox box(stay_inside);
    for (std::size_t i = 0; i < limits.size(); ++i) {
        if (!limits[i] || joints_[i] < 0) continue;
        const machine::Axis& axis = machine_.axes[static_cast<std::size_t>(joints_[i])];
        const double offset = offset_mm_[static_cast<Eigen::Index>(i)];
        box.add_side({i,
                      joints_[i],
                      {machine::joint_value(axis, limits[i]->min_mm + offset),
                       machine::joint_value(axis, limits[i]->max_mm + offset)}});
    }
    return box;
}

void ZoneWatch::take(const Segment& segment) {
    if (hit_) return;
    if (!changes_.empty()) make_changes(segment);
    if (on_hit_) {
        next_.take(segment);
        for (Known* zone : active_) follow(*zone, segment);
        return;
    }
    if (active_.empty() || !find_hit(segment)) return next_.take(segment);
    next_.take(cut(segment, hit_->time_s - segment.start_s));
}

void ZoneWatch::follow(Known& zone, const Segment& segment) {
    const bool was_open = zone.stay.has_value();
    const std::vector<BoxStay> stays = zone.box.stays(segment, zone.stay);
    for (std::size_t i = 0; i < stays.size(); ++i) {
        if (i > 0 || !was_open) add_hit(zone, stays[i], segment);
        if (zone.hit) hits_[*zone.hit].beyond_mm = stays[i].beyond_mm;
    }
    const bool goes_on = !stays.empty() && !stays.back().has_ended;
    zone.stay = goes_on ? std::optional(stays.back()) : std::nullopt;
}

void ZoneWatch::add_hit(Known& zone, const BoxStay& stay, const Segment& segment) {
    zone.hit.reset();
    if (hits_.size() >= kMostViolations) {
        ++further_hits_;
        return;
    }
    zone.hit = hits_.size();
    hits_.push_back(describe(zone, stay.began, segment));
    on_hit_(hits_.back());
}

bool ZoneWatch::find_hit(const Segment& segment) {
    std::optional<BoxOffence> first;
    const Known* broken = nullptr;
    for (const Known* zone : active_) {
        const std::optional<BoxOffence> offence = zone->box.first_offence(segment);
        if (!offence || (first && first->t_s <= offence->t_s)) continue;
        first = offence;
        broken = zone;
    }
    if (!first) return false;
    hit_ = describe(*broken, *first, segment);
    return true;
}

ZoneHit ZoneWatch::describe(const Known& zone, const BoxOffence& offence, const Segment& segment) const {
    const machine::ZoneLimits walls = zone.limits[offence.axis].value_or(machine::ZoneLimits{});
    ZoneHit hit{.zone = zone.name,
                .stay_inside = zone.stay_inside,
                .stands = offence.at_start,
                .time_s = segment.start_s + offence.t_s,
                .limits = zone.limits,
                .tool_mm = {},
                .axis = offence.axis,
                .wall_mm = offence.upper ? walls.max_mm : walls.min_mm,
                .upwards = offence.upper == zone.stay_inside,
                .beyond_mm = 0};
    const rrs::JointPos at = segment.position_at(offence.t_s);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        if (joints_[i] < 0) continue;
        hit.tool_mm[i] =
            machine::axis_value(machine_.axes[static_cast<std::size_t>(joints_[i])], at[joints_[i]]) -
            offset_mm_[static_cast<Eigen::Index>(i)];
    }
    return hit;
}

}  // namespace gsim::simulation
