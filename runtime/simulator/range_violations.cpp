#include "runtime/simulator/range_violations.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "motion/planner/range_check.h"

namespace gsim::simulation {

namespace {

constexpr double kParallelTolerance = 1e-9;  // mm or rad
constexpr const char* kControllerModuleStepText = ", by a step of the controller module, not by a target";

std::string range_message(const Violation& violation) {
    const char* unit = violation.rotary ? "deg" : "mm";
    return fmt::format("axis {} moves to {:.10g} {}, {:.10g} {} past its limit of {:.10g} {}", violation.axis,
                       violation.value, unit, violation.amount(), unit, violation.limit, unit);
}

}  // namespace

RangeViolations::RangeViolations(const machine::Machine& machine, MachineMotion& motion,
                                 const ProgramState& program, RunOutcome& outcome, ViolationLog& log)
    : machine_(machine), motion_(motion), program_(program), outcome_(outcome), log_(log), steps_(machine) {
    if (motion.source().is_sampled()) motion.recorder().add_output(steps_);
}

motion::OvertravelLog* RangeViolations::begin_move() {
    if (outcome_.limits().stop_at_first) return nullptr;
    move_start_ = motion_.source().position();
    return motion_.setup().overtravel_log.get();
}

motion::PlanResult RangeViolations::check_target(const rrs::JointPos& joints) const {
    if (!motion_.source().is_sampled()) return {};
    return motion::check_target_ranges(motion_.setup(), joints);
}

/// A move that leads back from past an end of a range moves no farther there.
bool RangeViolations::returns_to_range(const motion::Overtravel& overtravel) const {
    const bool below = overtravel.value < overtravel.limit;
    const auto excess = [&](double value) {
        return below ? overtravel.limit - value : value - overtravel.limit;
    };
    return excess(motion_.source().position()[overtravel.joint]) <= kParallelTolerance &&
           overtravel.excess() <= excess(move_start_[overtravel.joint]) + kParallelTolerance;
}

Violation RangeViolations::make_violation(std::size_t axis, double value, double limit) const {
    Violation violation{.axis = machine_.axes[axis].letter,
                        .rotary = machine_.axes[axis].kind == machine::AxisKind::rotary,
                        .value = value,
                        .limit = limit};
    violation.message = range_message(violation);
    return violation;
}

void RangeViolations::add_last(const SourceLocation& location) {
    const motion::OvertravelLog& overtravels = *motion_.setup().overtravel_log;
    if (!overtravels.accepts_excursions() || overtravels.overtravels().empty()) return;
    std::array<const motion::Overtravel*, rrs::kMaxJoints> farthest{};
    for (const motion::Overtravel& overtravel : overtravels.overtravels()) {
        const motion::Overtravel*& known = farthest[static_cast<std::size_t>(overtravel.joint)];
        if (returns_to_range(overtravel) || (known != nullptr && known->excess() >= overtravel.excess()))
            continue;
        known = &overtravel;
    }
    const WorkOffsets& offsets = program_.work_offsets();
    std::uint16_t excess = 0;
    for (std::size_t joint = 0; joint < machine_.axes.size(); ++joint) {
        if (farthest[joint] == nullptr) continue;
        excess = static_cast<std::uint16_t>(excess | 1U << joint);
        const machine::Axis& axis = machine_.axes[joint];
        Violation violation = make_violation(joint, machine::axis_value(axis, farthest[joint]->value),
                                             machine::axis_value(axis, farthest[joint]->limit));
        violation.location = location;
        violation.calls = program_.calls().open().now();
        violation.offset = offsets.code(offsets.index());
        log_.add_before(program_.ids().next() - 1, std::move(violation));
    }
    axes_out_of_range_ |= excess;
    motion_.recorder().mark_last_out_of_range(excess);
}

bool RangeViolations::fail_out_of_range(const RangeExcess& step) {
    const Violation violation = make_violation(step.axis, step.value, step.limit);
    return outcome_.fail_during(step.move, {.kind = text::DiagnosticKind::axis_limit,
                                            .message = violation.message + kControllerModuleStepText,
                                            .axis = violation.axis,
                                            .value = violation.value,
                                            .limit = violation.limit});
}

bool RangeViolations::check_steps() {
    return !outcome_.limits().stop_at_first || steps_.found().empty() ||
           fail_out_of_range(steps_.found().front());
}

/// The steps to a target past a range belong to that target, which is recorded by itself.
void RangeViolations::add_steps() {
    for (const RangeExcess& step : steps_.found()) {
        if (outcome_.limits().stop_at_first) {
            fail_out_of_range(step);
            return;
        }
        if ((axes_out_of_range_ >> step.axis & 1U) != 0) continue;
        Violation violation = make_violation(step.axis, step.value, step.limit);
        violation.t_s = step.t_s;
        violation.location = program_.ids().location_of(step.move);
        violation.calls = program_.calls().open().at(step.move.target_id);
        violation.message += kControllerModuleStepText;
        log_.add(std::move(violation));
    }
}

}  // namespace gsim::simulation
