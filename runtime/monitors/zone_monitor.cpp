#include "runtime/monitors/zone_monitor.h"

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

ZoneMonitor::ZoneMonitor(const machine::Machine& machine, motion::SegmentSink& next)
    : machine_(machine), next_(next), joints_(position_joints(machine)) {}

void ZoneMonitor::add_zones(const machine::MachineData& data) {
    for (const auto& [number, zone] : data.security_zones)
        add_zone(fmt::format("security zone {}", number), zone);
    if (data.working_zone) add_zone("the working zone", *data.working_zone);
    rebuild_boxes();
}

std::vector<ZoneRule> ZoneMonitor::rules() const {
    std::vector<ZoneRule> rules;
    rules.reserve(zones_.size());
    for (const ZoneState& zone : zones_) rules.push_back({zone.name, zone.limits, zone.stay_inside, zone.on});
    return rules;
}

void ZoneMonitor::add_zone(std::string name, const machine::Zone& zone) {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const char letter = static_cast<char>('X' + i);
        if (zone.limits[i] && joints_[i] < 0 && missing_axes_.find(letter) == std::string::npos)
            missing_axes_ += letter;
    }
    zones_.push_back({std::move(name), zone.limits, zone.kind != machine::ZoneKind::enter_forbidden,
                      zone.active_at_start, zone.switch_number});
}

// The program is read ahead of the motion. So a change by a word holds from the next move on, wherever the
// machine is when the word is read.
bool ZoneMonitor::switch_zones(int switch_number, bool on, rrs::TargetId from) {
    const auto has_number = [switch_number](const ZoneState& zone) {
        return zone.switch_number == switch_number;
    };
    if (std::none_of(zones_.begin(), zones_.end(), has_number)) return false;
    pending_changes_.push_back({from, [this, has_number, on](const rrs::JointPos&) {
                                    for (ZoneState& zone : zones_) zone.on = has_number(zone) ? on : zone.on;
                                }});
    return true;
}

void ZoneMonitor::set_programmed(const std::optional<ZoneWalls>& limits, rrs::TargetId from) {
    pending_changes_.push_back({from, [this, limits](const rrs::JointPos& at) {
                                    programmed_.reset();
                                    if (!limits) return;
                                    // G22 keeps the tool in or out, depending on the side of the machine when
                                    // it takes effect.
                                    const bool inside = make_zone_box(*limits, false).contains(at);
                                    programmed_ = {"the zone of G22", *limits, inside, true, {}};
                                }});
}

void ZoneMonitor::set_tool_offset(const Eigen::Vector3d& offset_mm, rrs::TargetId from) {
    pending_changes_.push_back(
        {from, [this, offset_mm](const rrs::JointPos&) { tool_offset_mm_ = offset_mm; }});
}

void ZoneMonitor::apply_changes(const Segment& segment) {
    if (pending_changes_.front().from > segment.target_id) return;
    while (!pending_changes_.empty() && pending_changes_.front().from <= segment.target_id) {
        pending_changes_.front().make(segment.start);
        pending_changes_.pop_front();
    }
    rebuild_boxes();
}

void ZoneMonitor::rebuild_boxes() {
    active_.clear();
    for (ZoneState& zone : zones_) {
        if (zone.on) active_.push_back(&zone);
        if (!zone.on) zone.violation_period.reset();
    }
    if (programmed_) active_.push_back(&*programmed_);
    // Walls are at those of the work frame, shifted by the tool: a box for each tool, not a sum for each
    // segment.
    for (ZoneState* zone : active_) zone->box = make_zone_box(zone->limits, zone->stay_inside);
    const auto has_no_walls = [](const ZoneState* zone) { return zone->box.sides().empty(); };
    active_.erase(std::remove_if(active_.begin(), active_.end(), has_no_walls), active_.end());
}

ZoneBox ZoneMonitor::make_zone_box(const ZoneWalls& limits, bool stay_inside) const {
    ZoneBox box(stay_inside);
    for (std::size_t i = 0; i < limits.size(); ++i) {
        if (!limits[i] || joints_[i] < 0) continue;
        const machine::Axis& axis = machine_.axes[static_cast<std::size_t>(joints_[i])];
        const double offset = tool_offset_mm_[static_cast<Eigen::Index>(i)];
        box.add_side({i,
                      joints_[i],
                      {machine::joint_value(axis, limits[i]->min_mm + offset),
                       machine::joint_value(axis, limits[i]->max_mm + offset)}});
    }
    return box;
}

void ZoneMonitor::on_segment(const Segment& segment) {
    if (hit_) return;
    if (!pending_changes_.empty()) apply_changes(segment);
    if (on_hit_) {
        next_.on_segment(segment);
        for (ZoneState* zone : active_) update_violations(*zone, segment);
        return;
    }
    if (active_.empty() || !find_hit(segment)) return next_.on_segment(segment);
    next_.on_segment(cut(segment, hit_->time_s - segment.start_s));
}

void ZoneMonitor::update_violations(ZoneState& zone, const Segment& segment) {
    const bool was_open = zone.violation_period.has_value();
    const std::vector<BoxViolationPeriod> violation_periods =
        zone.box.violation_periods(segment, zone.violation_period);
    for (std::size_t i = 0; i < violation_periods.size(); ++i) {
        if (i > 0 || !was_open) add_hit(zone, violation_periods[i], segment);
        if (zone.hit) hits_[*zone.hit].excess_mm = violation_periods[i].excess_mm;
    }
    const bool continues = !violation_periods.empty() && !violation_periods.back().has_ended;
    zone.violation_period = continues ? std::optional(violation_periods.back()) : std::nullopt;
}

void ZoneMonitor::add_hit(ZoneState& zone, const BoxViolationPeriod& violation_period,
                          const Segment& segment) {
    zone.hit.reset();
    if (hits_.size() >= kMaxViolations) {
        ++further_hits_;
        return;
    }
    zone.hit = hits_.size();
    hits_.push_back(describe(zone, violation_period.entry, segment));
    on_hit_(hits_.back());
}

bool ZoneMonitor::find_hit(const Segment& segment) {
    std::optional<BoxViolation> first;
    const ZoneState* violated_zone = nullptr;
    for (const ZoneState* zone : active_) {
        const std::optional<BoxViolation> violation = zone->box.first_violation(segment);
        if (!violation || (first && first->t_s <= violation->t_s)) continue;
        first = violation;
        violated_zone = zone;
    }
    if (!first) return false;
    hit_ = describe(*violated_zone, *first, segment);
    return true;
}

ZoneHit ZoneMonitor::describe(const ZoneState& zone, const BoxViolation& violation,
                              const Segment& segment) const {
    const machine::ZoneLimits walls = zone.limits[violation.axis].value_or(machine::ZoneLimits{});
    ZoneHit hit{.zone = zone.name,
                .stay_inside = zone.stay_inside,
                .is_initial = violation.at_start,
                .time_s = segment.start_s + violation.t_s,
                .limits = zone.limits,
                .tool_mm = {},
                .axis = violation.axis,
                .wall_mm = violation.upper ? walls.max_mm : walls.min_mm,
                .upwards = violation.upper == zone.stay_inside,
                .excess_mm = 0};
    const rrs::JointPos at = segment.position_at(violation.t_s);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        if (joints_[i] < 0) continue;
        hit.tool_mm[i] =
            machine::axis_value(machine_.axes[static_cast<std::size_t>(joints_[i])], at[joints_[i]]) -
            tool_offset_mm_[static_cast<Eigen::Index>(i)];
    }
    return hit;
}

}  // namespace gsim::simulation
