// Violations of limits and zones, after which a run continues.

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "motion/planner/range_check.h"
#include "runtime/simulator/simulator.h"

namespace gsim::simulation {

namespace {

constexpr double kSameWay = 1e-9;  // mm or rad
constexpr const char* kByModule = ", by a step of the controller module, not by a target";

std::string message_of(const Violation& violation) {
    const char* unit = violation.rotary ? "deg" : "mm";
    return fmt::format("axis {} goes to {:.10g} {}, {:.10g} {} past its limit of {:.10g} {}", violation.axis,
                       violation.value, unit, violation.amount(), unit, violation.limit, unit);
}

std::string message_of(const ZoneHit& hit, const Violation& violation) {
    const char* place = hit.stay_inside ? "inside" : "outside";
    const std::string what =
        hit.stands ? fmt::format("the tool is not {} {} when that comes into force", place, hit.zone)
                   : fmt::format("the tool {} {}", hit.stay_inside ? "leaves" : "enters", hit.zone);
    return fmt::format("{}: it goes {:.10g} mm past the wall at {} {:.10g} mm, and must stay {}", what,
                       violation.amount(), violation.axis, violation.limit, place);
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
motion::RangeNotes* Simulator::begin_move() {
    if (limits_.stop_at_first) return nullptr;
    move_start_ = motion_->position();
    return setup_.range_notes.get();
}

/// A controller module rejects a target past a range, or moves there.
motion::Planned Simulator::check_target(const rrs::JointPos& joints) const {
    if (!sampled()) return {};
    return motion::check_target_ranges(setup_, joints);
}

/// A move that leads back from past an end of a range moves no farther there.
bool Simulator::comes_back(const motion::Excursion& excursion) const {
    const bool below = excursion.value < excursion.limit;
    const auto beyond = [&](double value) {
        return below ? excursion.limit - value : value - excursion.limit;
    };
    return beyond(motion_->position()[excursion.joint]) <= kSameWay &&
           excursion.beyond() <= beyond(move_start_[excursion.joint]) + kSameWay;
}

Violation Simulator::violation_of(std::size_t axis, double value, double limit) const {
    Violation violation{.axis = machine_.axes[axis].letter,
                        .rotary = machine_.axes[axis].kind == machine::AxisKind::rotary,
                        .value = value,
                        .limit = limit};
    violation.message = message_of(violation);
    return violation;
}

void Simulator::add_violations(const Place& place) {
    if (!setup_.range_notes->passing() || setup_.range_notes->excursions().empty()) return;
    std::array<const motion::Excursion*, rrs::kMaxJoints> farthest{};
    for (const motion::Excursion& excursion : setup_.range_notes->excursions()) {
        const motion::Excursion*& known = farthest[static_cast<std::size_t>(excursion.joint)];
        if (comes_back(excursion) || (known != nullptr && known->beyond() >= excursion.beyond())) continue;
        known = &excursion;
    }
    std::uint16_t beyond = 0;
    for (std::size_t joint = 0; joint < machine_.axes.size(); ++joint) {
        if (farthest[joint] == nullptr) continue;
        beyond = static_cast<std::uint16_t>(beyond | 1U << joint);
        const machine::Axis& axis = machine_.axes[joint];
        Violation violation = violation_of(joint, machine::axis_value(axis, farthest[joint]->value),
                                           machine::axis_value(axis, farthest[joint]->limit));
        violation.place = place;
        violation.calls = calls_.now();
        violation.offset = work_offsets_[work_offset_];
        violations_.add_before(next_id_ - 1, std::move(violation));
    }
    axes_past_ranges_ |= beyond;
    recorder_.mark_last(beyond);
}

bool Simulator::fail_past_range(const StepPastRange& step) {
    const Violation violation = violation_of(step.axis, step.value, step.limit);
    fail_under_way(step.move, text::DiagnosticKind::axis_limit, violation.message + kByModule);
    alarm_->axis = violation.axis;
    alarm_->value = violation.value;
    alarm_->limit = violation.limit;
    return false;
}

/// The steps to a target past a range belong to that target, which is recorded by itself.
void Simulator::add_steps_past_ranges() {
    for (const StepPastRange& step : steps_.found()) {
        if (limits_.stop_at_first) {
            fail_past_range(step);
            return;
        }
        if ((axes_past_ranges_ >> step.axis & 1U) != 0) continue;
        Violation violation = violation_of(step.axis, step.value, step.limit);
        violation.t_s = step.t_s;
        violation.place = place_of(step.move);
        violation.calls = calls_.at(step.move.target_id);
        violation.message += kByModule;
        violations_.add(std::move(violation));
    }
}

/// Records the point at which the tool begins to violate a zone's rule; the depth is known later.
void Simulator::add_zone_violation(const ZoneHit& hit) {
    const MoveInfo& move = recorder_.move();
    zone_violations_.push_back({.t_s = hit.time_s,
                                .place = place_of(move),
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
        violation.value = hit.wall_mm + (hit.upwards ? hit.beyond_mm : -hit.beyond_mm);
        violation.message = message_of(hit, violation);
        violations_.add(std::move(violation));
    }
    return violations_.release(zones_.further_hits());
}

}  // namespace gsim::simulation
