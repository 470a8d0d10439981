#include "runtime/monitors/effort_monitor.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.h"

namespace gsim::simulation {

using dynamics::EffortSample;
using dynamics::EffortSums;

namespace {

constexpr double kMinSpeedJump = 1e-6;  // mm/s, rad/s: less is rounding at the border of two segments
constexpr double kRelativeSpeedJump = 1e-9;
constexpr double kLimitTolerance = 1e-9;  // a motor that is asked for exactly what it has is within its limit

}  // namespace

double axis_speed(const machine::Axis& axis, double joint_speed) {
    return std::abs(axis.kind == machine::AxisKind::linear ? joint_speed : joint_speed / kRadPerDeg);
}

double motor_peak(const machine::Drive& drive, double speed) {
    const std::vector<double>& speeds = drive.curve_speeds;
    if (speeds.empty()) return drive.peak;
    const auto above = std::upper_bound(speeds.begin(), speeds.end(), speed);
    const auto i = static_cast<std::size_t>(above - speeds.begin());
    if (i == 0) return std::min(drive.peak, drive.curve_peaks.front());
    if (i == speeds.size()) return speed > speeds.back() ? 0 : std::min(drive.peak, drive.curve_peaks.back());
    const double share = (speed - speeds[i - 1]) / (speeds[i] - speeds[i - 1]);
    return std::min(drive.peak, std::lerp(drive.curve_peaks[i - 1], drive.curve_peaks[i], share));
}

std::string excess_text(const EffortExcess& excess) {
    const char* unit = excess.rotary ? "Nm" : "N";
    if (excess.continuous) {
        return fmt::format(
            "axis {} needs {:.4g} {} as a root mean square of the complete run, of {:.4g} {} continuous of "
            "its motor",
            excess.letter, excess.effort, unit, excess.limit, unit);
    }
    std::string text = fmt::format("axis {} needs {:.4g} {} of {:.4g} {}", excess.letter, excess.effort, unit,
                                   excess.limit, unit);
    if (!excess.acceleration_share)
        return text + "; weight, friction and speed alone exceed it, with any acceleration";
    // Rounded down, so that the reported share is enough.
    return text + fmt::format("; {:.2f} of its acceleration is possible",
                              std::floor(*excess.acceleration_share * 100) / 100);
}

EffortMonitor::EffortMonitor(const machine::Machine& machine, const dynamics::Dynamics& dynamics)
    : machine_(machine),
      dynamics_(dynamics),
      segments_(dynamics),
      sums_(machine.axes.size()),
      velocity_(rrs::JointPos::Zero(dynamics.joint_count())),
      worst_excesses_(machine.axes.size()) {
    for (const machine::Axis& axis : machine.axes) {
        report_.axes.push_back({.letter = axis.letter,
                                .rotary = axis.kind == machine::AxisKind::rotary,
                                .motor_peak = axis.drive.peak,
                                .motor_continuous = axis.drive.continuous});
    }
}

void EffortMonitor::begin(const rrs::JointPos& start) {
    at_ = start;
}

EffortMonitor::Program& EffortMonitor::program_entry(std::uint16_t program) {
    const auto found = std::find_if(programs_.begin(), programs_.end(),
                                    [program](const Program& one) { return one.program == program; });
    if (found != programs_.end()) return *found;
    return programs_.emplace_back(
        Program{.program = program, .time_s = {}, .drive_j = {}, .regenerated_j = {}});
}

void EffortMonitor::on_segment(const motion::Segment& segment, const MoveInfo& info) {
    if (info.target_id != move_.target_id) end_move();
    move_ = info;
    Program& program = program_entry(info.program);
    if (segment.duration_s > 0) jump(segment.start, segment.at(0).velocity, program, info.location);
    const EffortSums sums = segments_.sums(
        segment, [&](const EffortSample& sample) { inspect_sample(sample, segment.start_s, info.location); });
    for (std::size_t axis = 0; axis < sums_.size(); ++axis) {
        const auto joint = static_cast<Eigen::Index>(axis);
        sums_[axis].squares.add(sums.squares[joint]);
        sums_[axis].drive_j.add(sums.drive_j[joint]);
        sums_[axis].regenerated_j.add(sums.regenerated_j[joint]);
        sums_[axis].friction_j.add(sums.friction_j[joint]);
    }
    program.time_s.add(segment.duration_s);
    program.drive_j.add(sums.drive_j.sum());
    program.regenerated_j.add(sums.regenerated_j.sum());
    time_s_ += segment.duration_s;
    end_s_ = segment.end_s();
    at_ = segment.end_position();
    if (segment.duration_s > 0) velocity_ = segment.at(segment.duration_s).velocity;
}

void EffortMonitor::end(double /*end_s*/) {
    jump(at_, rrs::JointPos::Zero(dynamics_.joint_count()), program_entry(move_.program), move_.location);
    end_move();
}

// Computes the work of an impulse at the mean of the speeds before and after it: over all joints that is the
// change of kinetic energy.
void EffortMonitor::jump(const rrs::JointPos& position, const rrs::JointPos& to, Program& program,
                         const SourceLocation& location) {
    const rrs::JointPos change = to - velocity_;
    const double fastest = std::max(to.cwiseAbs().maxCoeff(), velocity_.cwiseAbs().maxCoeff());
    if (change.cwiseAbs().maxCoeff() <= kMinSpeedJump + kRelativeSpeedJump * fastest) return;
    ++report_.jumps;
    const dynamics::Efforts impulses = dynamics_.inertial_efforts(position, change);
    const rrs::JointPos work_by_axis_j = dynamics_.powers_w(impulses, (to + velocity_) / 2);
    for (std::size_t axis = 0; axis < sums_.size(); ++axis) {
        const double work_j = work_by_axis_j[static_cast<Eigen::Index>(axis)];
        (work_j > 0 ? sums_[axis].drive_j : sums_[axis].regenerated_j).add(std::abs(work_j));
        (work_j > 0 ? program.drive_j : program.regenerated_j).add(std::abs(work_j));
        const double impulse = std::abs(impulses[static_cast<Eigen::Index>(axis)]);
        if (impulse <= report_.axes[axis].impulse) continue;
        report_.axes[axis].impulse = impulse;
        report_.axes[axis].impulse_location = location;
    }
    velocity_ = to;
}

void EffortMonitor::inspect_sample(const EffortSample& sample, double start_s,
                                   const SourceLocation& location) {
    const double power_w = sample.powers_w.sum();
    if (power_w > report_.peak_power_w) {
        report_.peak_power_w = power_w;
        report_.peak_power_t_s = start_s + sample.t_s;
        report_.peak_power_location = location;
    }
    for (std::size_t axis = 0; axis < sums_.size(); ++axis) {
        AxisEffort& effort = report_.axes[axis];
        const double value = sample.efforts[static_cast<Eigen::Index>(axis)];
        effort.peak_power_w = std::max(effort.peak_power_w, sample.powers_w[static_cast<Eigen::Index>(axis)]);
        if (std::abs(value) > std::abs(effort.peak)) {
            effort.peak = value;
            effort.peak_t_s = start_s + sample.t_s;
            effort.peak_location = location;
        }
        check_motor(axis, sample, start_s);
    }
}

// Reports the instant of a move that needs the smallest acceleration.
void EffortMonitor::check_motor(std::size_t axis, const EffortSample& sample, double start_s) {
    const machine::Axis& of = machine_.axes[axis];
    const auto joint = static_cast<Eigen::Index>(axis);
    const double limit = motor_peak(of.drive, axis_speed(of, sample.motion.velocity[joint]));
    const double effort = std::abs(sample.efforts[joint]);
    if (effort <= limit * (1 + kLimitTolerance)) return;
    const double share = acceleration_share(axis, sample, limit);
    EffortExcess& worst = worst_excesses_[axis];
    const double reported_share = worst.effort == 0 ? 2 : worst.acceleration_share.value_or(-1);
    if (share > reported_share || (share == reported_share && effort <= worst.effort)) return;
    worst = {.t_s = start_s + sample.t_s,
             .location = move_.location,
             .letter = of.letter,
             .rotary = of.kind == machine::AxisKind::rotary,
             .effort = effort,
             .limit = limit,
             .acceleration_share = share < 0 ? std::nullopt : std::optional(share)};
}

// Splits the efforts into what the state and the speed need and, in proportion to it, what the acceleration
// needs.
double EffortMonitor::acceleration_share(std::size_t axis, const EffortSample& sample, double limit) const {
    const auto joint = static_cast<Eigen::Index>(axis);
    const double moving =
        dynamics_.inertial_efforts(sample.motion.position, sample.motion.acceleration)[joint];
    const double static_effort = sample.efforts[joint] - moving;
    if (std::abs(static_effort) >= limit || moving == 0) return -1;
    return (std::copysign(limit, sample.efforts[joint]) - static_effort) / moving;
}

void EffortMonitor::end_move() {
    for (EffortExcess& worst : worst_excesses_) {
        if (worst.effort == 0) continue;
        ++report_.excess_count;
        if (report_.excesses.size() < kMaxExcesses) report_.excesses.push_back(worst);
        worst = {};
    }
}

void EffortMonitor::add_rms_excesses(EffortReport& report) const {
    for (const AxisEffort& axis : report.axes) {
        if (axis.rms <= axis.motor_continuous * (1 + kLimitTolerance)) continue;
        ++report.excess_count;
        report.excesses.push_back({.t_s = end_s_,
                                   .letter = axis.letter,
                                   .rotary = axis.rotary,
                                   .effort = axis.rms,
                                   .limit = axis.motor_continuous,
                                   .continuous = true});
    }
}

EffortReport EffortMonitor::report(const std::vector<std::string>& programs) const {
    EffortReport report = report_;
    for (std::size_t axis = 0; axis < sums_.size(); ++axis) {
        const Sums& sums = sums_[axis];
        report.axes[axis].rms = time_s_ > 0 ? std::sqrt(std::max(0.0, sums.squares.value()) / time_s_) : 0;
        report.axes[axis].drive_j = sums.drive_j.value();
        report.axes[axis].regenerated_j = sums.regenerated_j.value();
        report.axes[axis].friction_j = sums.friction_j.value();
        report.drive_j += sums.drive_j.value();
        report.regenerated_j += sums.regenerated_j.value();
        report.friction_j += sums.friction_j.value();
    }
    for (const Program& program : programs_) {
        report.programs.push_back(
            {.program = program.program < programs.size() ? programs[program.program] : "",
             .time_s = program.time_s.value(),
             .drive_j = program.drive_j.value(),
             .regenerated_j = program.regenerated_j.value()});
    }
    add_rms_excesses(report);
    return report;
}

}  // namespace gsim::simulation
