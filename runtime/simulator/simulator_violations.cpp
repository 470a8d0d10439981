// Violations of limits and zones, after which a run continues.

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "motion/planner/range_check.h"
#include "runtime/simulator/simulator.h"

namespace gsim::simulation {

namespace {

constexpr double kParallelTolerance = 1e-9;  // mm or rad
constexpr const char* kByControllerModule = ", by a step of the controller module, not by a target";

std::string violation_message(const Violation& violation) {
    const char* unit = violation.rotary ? "deg" : "mm";
    return fmt::format("axis {} goes to {:.10g} {}, {:.10g} {} past its limit of {:.10g} {}", violation.axis,
                       violation.value, unit, violation.amount(), unit, violation.limit, unit);
}

std::string violation_message(const ZoneHit& hit, const Violation& violation) {
    const char* location = hit.stay_inside ? "inside" : "outside";
    const std::string what =
        hit.is_initial ? fmt::format("the tool is not {} {} when that comes into force", location, hit.zone)
                       : fmt::format("the tool {} {}", hit.stay_inside ? "leaves" : "enters", hit.zone);
    return fmt::format("{}: it goes {:.10g} mm past the wall at {} {:.10g} mm, and must stay {}", what,
                       violation.amount(), violation.axis, violation.limit, location);
}

}  // namespace

void Simulator::select_work_offset(const WorkOffset& offset) {
    selected_offset_ = offset;
    if (observer_ != nullptr) observer_->work_offset(offset);
    const std::string code = "G" + offset.name;
    const auto found = std::find(work_offsets_.begin(), work_offsets_.end(), code);
    work_offset_ = static_cast<std::uint16_t>(found - work_offsets_.begin());
    if (found == work_offsets_.end()) work_offsets_.push_back(code);
}

/// Returns the notes that let the present move pass ranges; null if moves may not.
motion::OvertravelLog* Simulator::begin_move() {
    if (limits_.stop_at_first) return nullptr;
    move_start_ = motion_->position();
    return setup_.overtravel_log.get();
}

/// A controller module rejects a target past a range, or moves there.
motion::PlanResult Simulator::check_target(const rrs::JointPos& joints) const {
    if (!is_sampled()) return {};
    return motion::check_target_ranges(setup_, joints);
}

/// A move that leads back from past an end of a range moves no farther there.
bool Simulator::returns_to_range(const motion::Overtravel& overtravel) const {
    const bool below = overtravel.value < overtravel.limit;
    const auto excess = [&](double value) {
        return below ? overtravel.limit - value : value - overtravel.limit;
    };
    return excess(motion_->position()[overtravel.joint]) <= kParallelTolerance &&
           overtravel.excess() <= excess(move_start_[overtravel.joint]) + kParallelTolerance;
}

Violation Simulator::make_violation(std::size_t axis, double value, double limit) const {
    Violation violation{.axis = machine_.axes[axis].letter,
                        .rotary = machine_.axes[axis].kind == machine::AxisKind::rotary,
                        .value = value,
                        .limit = limit};
    violation.message = violation_message(violation);
    return violation;
}

void Simulator::add_violations(const SourceLocation& location) {
    if (!setup_.overtravel_log->accepts_excursions() || setup_.overtravel_log->overtravels().empty()) return;
    std::array<const motion::Overtravel*, rrs::kMaxJoints> farthest{};
    for (const motion::Overtravel& overtravel : setup_.overtravel_log->overtravels()) {
        const motion::Overtravel*& known = farthest[static_cast<std::size_t>(overtravel.joint)];
        if (returns_to_range(overtravel) || (known != nullptr && known->excess() >= overtravel.excess()))
            continue;
        known = &overtravel;
    }
    std::uint16_t excess = 0;
    for (std::size_t joint = 0; joint < machine_.axes.size(); ++joint) {
        if (farthest[joint] == nullptr) continue;
        excess = static_cast<std::uint16_t>(excess | 1U << joint);
        const machine::Axis& axis = machine_.axes[joint];
        Violation violation = make_violation(joint, machine::axis_value(axis, farthest[joint]->value),
                                             machine::axis_value(axis, farthest[joint]->limit));
        violation.location = location;
        violation.calls = calls_.now();
        violation.offset = work_offsets_[work_offset_];
        violations_.add_before(next_id_ - 1, std::move(violation));
    }
    axes_out_of_range_ |= excess;
    recorder_.mark_last(excess);
}

bool Simulator::fail_out_of_range(const RangeExcess& step) {
    const Violation violation = make_violation(step.axis, step.value, step.limit);
    fail_during_motion(step.move, text::DiagnosticKind::axis_limit, violation.message + kByControllerModule);
    alarm_->axis = violation.axis;
    alarm_->value = violation.value;
    alarm_->limit = violation.limit;
    return false;
}

/// The steps to a target past a range belong to that target, which is recorded by itself.
void Simulator::add_range_excess_steps() {
    for (const RangeExcess& step : steps_.found()) {
        if (limits_.stop_at_first) {
            fail_out_of_range(step);
            return;
        }
        if ((axes_out_of_range_ >> step.axis & 1U) != 0) continue;
        Violation violation = make_violation(step.axis, step.value, step.limit);
        violation.t_s = step.t_s;
        violation.location = source_location(step.move);
        violation.calls = calls_.at(step.move.target_id);
        violation.message += kByControllerModule;
        violations_.add(std::move(violation));
    }
}

/// Records the point at which the tool begins to violate a zone's rule; the depth is known later.
void Simulator::add_zone_violation(const ZoneHit& hit) {
    const MoveInfo& move = recorder_.move();
    zone_violations_.push_back({.t_s = hit.time_s,
                                .location = source_location(move),
                                .calls = calls_.at(move.target_id),
                                .zone = hit.zone,
                                .forbidden_zone = !hit.stay_inside,
                                .axis = static_cast<char>('X' + hit.axis),
                                .limit = hit.wall_mm,
                                .offset = work_offsets_[move.offset]});
}

Violations Simulator::release_violations() {
    for (std::size_t i = 0; i < zone_violations_.size(); ++i) {
        const ZoneHit& hit = zones_.hits()[i];
        Violation& violation = zone_violations_[i];
        violation.value = hit.wall_mm + (hit.upwards ? hit.excess_mm : -hit.excess_mm);
        violation.message = violation_message(hit, violation);
        violations_.add(std::move(violation));
    }
    return violations_.release(zones_.further_hits());
}

}  // namespace gsim::simulation
