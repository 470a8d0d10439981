#include "calibrate/geometry/deviation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "base/units.h"
#include "machine/model/frame_pose.h"
#include "motion/kinematics/chain.h"
#include "motion/kinematics/pose.h"

namespace gsim::calibrate {

namespace {

using Of = Deviation::Of;

constexpr double kPerMillion = 1e-6;
constexpr std::array kAxisNames{'x', 'y', 'z'};

machine::Frame frame_of(const rrs::CartPos& pose) {
    const kinematics::Rpy rpy = kinematics::rpy_from_pose(pose);
    // Adding 0 turns -0 into 0, because -0 would confuse users.
    return {.x_mm = rpy.x_mm + 0,
            .y_mm = rpy.y_mm + 0,
            .z_mm = rpy.z_mm + 0,
            .roll_deg = rpy.roll_rad / kRadPerDeg + 0,
            .pitch_deg = rpy.pitch_rad / kRadPerDeg + 0,
            .yaw_deg = rpy.yaw_rad / kRadPerDeg + 0};
}

/// Small motion: the rotation about the origin, then the translation.
struct Motion {
    Eigen::Vector3d way_mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d turn_deg = Eigen::Vector3d::Zero();

    bool is_none() const { return way_mm.isZero(0) && turn_deg.isZero(0); }
    void add(const Deviation& deviation, double value) {
        (deviation.is_turn() ? turn_deg : way_mm) += value * deviation.direction;
    }
    Eigen::Matrix3d rotation() const {
        const double angle_deg = turn_deg.norm();
        if (angle_deg == 0) return Eigen::Matrix3d::Identity();
        return Eigen::AngleAxisd(angle_deg * kRadPerDeg, turn_deg / angle_deg).toRotationMatrix();
    }
    rrs::CartPos pose() const {
        rrs::CartPos pose = rrs::CartPos::Identity();
        pose.linear() = rotation();
        pose.translation() = way_mm;
        return pose;
    }
    /// Returns the motion of a line through the origin of `joint`, given in world axes, as a motion in that
    /// frame.
    rrs::CartPos in(const rrs::CartPos& joint) const {
        const Eigen::Matrix3d axes = joint.linear();
        rrs::CartPos pose = rrs::CartPos::Identity();
        pose.linear() = axes.transpose() * rotation() * axes;
        pose.translation() = axes.transpose() * way_mm;
        return pose;
    }
    /// Returns the frame moved in world axes and rotated about its origin.
    rrs::CartPos moved(const rrs::CartPos& frame) const {
        rrs::CartPos pose = rrs::CartPos::Identity();
        pose.linear() = rotation() * frame.linear();
        pose.translation() = frame.translation() + way_mm;
        return pose;
    }
};

/// Motions that result from the values of deviations.
struct Motions {
    std::vector<Motion> axes;
    Motion base, tool, work, instrument;

    Motion& of(const Deviation& deviation) {
        switch (deviation.of) {
            case Of::base: return base;
            case Of::tool: return tool;
            case Of::work: return work;
            case Of::instrument: return instrument;
            default: return axes[deviation.axis];
        }
    }
};

void add_frame(std::vector<Deviation>& list, std::string_view frame, Of of, bool turns) {
    for (std::size_t i = 0; i < kAxisNames.size(); ++i) {
        list.push_back({.name = turns ? fmt::format("{} turn_{}_deg", frame, kAxisNames[i])
                                      : fmt::format("{} {}_mm", frame, kAxisNames[i]),
                        .of = of,
                        .unit = turns ? DeviationUnit::deg : DeviationUnit::mm,
                        .direction = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(i))});
    }
}

void add_zero(std::vector<Deviation>& list, const machine::Machine& machine, std::size_t axis) {
    const bool linear = machine.axes[axis].kind == machine::AxisKind::linear;
    list.push_back({.name = fmt::format("{} zero_{}", machine.axes[axis].letter, linear ? "mm" : "deg"),
                    .of = Of::zero,
                    .unit = linear ? DeviationUnit::mm : DeviationUnit::deg,
                    .axis = axis});
}

/// Adds the two world axes most perpendicular to a joint's line, orthogonalised to it.
void add_across(std::vector<Deviation>& list, const machine::Machine& machine, std::size_t axis, Of of,
                const Eigen::Vector3d& line) {
    Eigen::Index along = 0;
    line.cwiseAbs().maxCoeff(&along);
    const bool tilt = of == Of::tilt;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < 3; ++i) {
        if (i == along) continue;
        Eigen::Vector3d direction = Eigen::Vector3d::Unit(i);
        direction -= direction.dot(line) * line + direction.dot(first) * first;
        direction.normalize();
        if (first.isZero(0)) first = direction;
        list.push_back({.name = fmt::format("{} {}_{}_{}", machine.axes[axis].letter, tilt ? "tilt" : "shift",
                                            kAxisNames[static_cast<std::size_t>(i)], tilt ? "deg" : "mm"),
                        .of = of,
                        .unit = tilt ? DeviationUnit::deg : DeviationUnit::mm,
                        .axis = axis,
                        .direction = direction});
    }
}

bool is_held(const Deviation& deviation, const std::vector<std::string>& held) {
    return std::any_of(held.begin(), held.end(), [&](const std::string& words) {
        return (" " + deviation.name).find(" " + words) != std::string::npos;
    });
}

machine::Machine without_bodies(machine::Machine machine) {
    machine.shapes.clear();
    machine.ignored.clear();
    machine.dynamics.reset();
    machine.inverse = machine::InverseKind::none;
    return machine;
}

rrs::CartPos place_of(const machine::Axis& axis) {
    return axis.frame ? machine::frame_pose(*axis.frame) : rrs::CartPos::Identity();
}

}  // namespace

double usual_size(const Deviation& deviation) {
    constexpr double kUsual_mm = 0.5, kUsual_deg = 0.1, kUsual_ppm = 1000;
    switch (deviation.unit) {
        case DeviationUnit::mm: return kUsual_mm;
        case DeviationUnit::deg: return kUsual_deg;
        case DeviationUnit::ppm: break;
    }
    return kUsual_ppm;
}

// Users expect offsets first, then the machine's pose, then lines of axes from the tool (or the work) back to
// the world. So of three slides that are not square the first one defines the direction.
std::vector<Deviation> all_deviations(const machine::Machine& machine, const DeviationChoice& choice) {
    std::vector<Deviation> list;
    const auto frames =
        machine::make_kinematics(without_bodies(machine))
            ->chain()
            .joint_frames(rrs::JointPos::Zero(static_cast<Eigen::Index>(machine.axes.size())));
    std::vector<std::size_t> rotary, linear;
    for (std::size_t i = machine.axes.size(); i-- > 0;) {
        if (machine.axes[i].carries == machine::Carries::nothing) continue;
        (machine.axes[i].kind == machine::AxisKind::rotary ? rotary : linear).push_back(i);
    }
    const auto line = [&](std::size_t axis) -> Eigen::Vector3d { return frames[axis].linear().col(2); };
    if (choice.own_frame) {
        add_frame(list, "instrument", Of::instrument, true);
        add_frame(list, "instrument", Of::instrument, false);
    }
    for (std::size_t i = 0; i < machine.axes.size(); ++i)
        if (machine.axes[i].carries != machine::Carries::nothing) add_zero(list, machine, i);
    add_frame(list, "tool", Of::tool, false);
    add_frame(list, "base", Of::base, true);
    for (const std::size_t axis : rotary) {
        add_across(list, machine, axis, Of::shift, line(axis));
        add_across(list, machine, axis, Of::tilt, line(axis));
    }
    for (const std::size_t axis : linear) add_across(list, machine, axis, Of::tilt, line(axis));
    for (auto axis = linear.rbegin(); axis != linear.rend(); ++axis)
        list.push_back({.name = fmt::format("{} scale_ppm", machine.axes[*axis].letter),
                        .of = Of::scale,
                        .unit = DeviationUnit::ppm,
                        .axis = *axis});
    add_frame(list, "tool", Of::tool, true);
    add_frame(list, "base", Of::base, false);
    for (const bool turns : {false, true}) add_frame(list, "work", Of::work, turns);
    std::erase_if(list, [&](const Deviation& deviation) { return is_held(deviation, choice.held); });
    return list;
}

std::optional<std::string> unknown_held(const machine::Machine& machine, const DeviationChoice& choice) {
    const auto all = all_deviations(machine, {.own_frame = choice.own_frame, .held = {}});
    for (const std::string& words : choice.held) {
        if (std::none_of(all.begin(), all.end(), [&](const Deviation& one) { return is_held(one, {words}); }))
            return words;
    }
    return std::nullopt;
}

DeviatedMachine::DeviatedMachine(Geometry nominal) : nominal_(std::move(nominal)) {
    const std::size_t count = nominal_.machine.axes.size();
    nominal_.scales.resize(count, 1);
    const auto made = machine::make_kinematics(without_bodies(nominal_.machine));
    const kinematics::Chain& chain = made->chain();
    joints_ = chain.joint_frames(rrs::JointPos::Zero(static_cast<Eigen::Index>(count)));
    behind_.resize(count, rrs::CartPos::Identity());
    for (const kinematics::Branch* side : {&chain.tool_side(), &chain.work_side()}) {
        for (const kinematics::Link& link : side->links)
            behind_[static_cast<std::size_t>(link.joint)] = link.after;
    }
}

Geometry DeviatedMachine::at(std::span<const Deviation> deviations, const Eigen::VectorXd& values) const {
    Geometry found = nominal_;
    Motions motions{
        .axes = std::vector<Motion>(joints_.size()), .base = {}, .tool = {}, .work = {}, .instrument = {}};
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        const Deviation& deviation = deviations[i];
        const double value = values[static_cast<Eigen::Index>(i)];
        if (deviation.of == Of::zero) {
            found.machine.axes[deviation.axis].zero += value;
        } else if (deviation.of == Of::scale) {
            found.scales[deviation.axis] += value * kPerMillion;
        } else {
            motions.of(deviation).add(deviation, value);
        }
    }
    // Motions that the next frame of each side must undo.
    std::array<rrs::CartPos, 2> back{rrs::CartPos::Identity(), rrs::CartPos::Identity()};
    std::array<bool, 2> moved{};
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        machine::Axis& axis = found.machine.axes[i];
        if (axis.carries == machine::Carries::nothing) continue;
        const std::size_t side = axis.carries == machine::Carries::work ? 1 : 0;
        if (motions.axes[i].is_none() && !moved[side]) continue;
        const rrs::CartPos line = motions.axes[i].in(joints_[i]);
        const rrs::CartPos taken_back = behind_[i].inverse() * line.inverse() * behind_[i];
        axis.frame = frame_of(back[side] * place_of(axis) * (axis.direction ? taken_back.inverse() : line));
        back[side] = taken_back;
        moved[side] = !motions.axes[i].is_none();
    }
    machine::Machine& machine = found.machine;
    if (!motions.base.is_none())
        machine.base = frame_of(motions.base.moved(machine::frame_pose(machine.base)));
    if (moved[0] || !motions.tool.is_none())
        machine.tool = frame_of(back[0] * machine::frame_pose(machine.tool) * motions.tool.pose());
    if (moved[1] || !motions.work.is_none())
        machine.work = frame_of(back[1] * machine::frame_pose(machine.work) * motions.work.pose());
    found.instrument = motions.instrument.moved(found.instrument);
    return found;
}

Geometry DeviatedMachine::with_nominal_turn(Geometry geometry) const {
    const rrs::JointPos zero = rrs::JointPos::Zero(static_cast<Eigen::Index>(joints_.size()));
    const auto turn = [&](const machine::Machine& machine) -> Eigen::Matrix3d {
        return machine::make_kinematics(without_bodies(machine))->forward(zero).linear();
    };
    rrs::CartPos tool = machine::frame_pose(geometry.machine.tool);
    tool.linear() = tool.linear() * turn(geometry.machine).transpose() * turn(nominal_.machine);
    geometry.machine.tool = frame_of(tool);
    return geometry;
}

TipFinder::TipFinder(const Geometry& geometry)
    : kinematics_(machine::make_kinematics(without_bodies(geometry.machine))),
      axes_(geometry.machine.axes),
      scales_(geometry.scales),
      instrument_(geometry.instrument) {}

rrs::CartPos TipFinder::tip(std::span<const double> readings) const {
    rrs::JointPos joints(static_cast<Eigen::Index>(axes_.size()));
    for (std::size_t i = 0; i < axes_.size(); ++i)
        joints[static_cast<Eigen::Index>(i)] = machine::joint_value(axes_[i], readings[i] * scales_[i]);
    return instrument_ * kinematics_->forward(joints);
}

}  // namespace gsim::calibrate
