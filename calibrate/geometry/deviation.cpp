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

using Kind = Deviation::Kind;

constexpr double kPerMillion = 1e-6;
constexpr std::array kAxisNames{'x', 'y', 'z'};

machine::Frame to_frame(const rrs::CartPos& pose) {
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
    Eigen::Vector3d translation_mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d rotation_deg = Eigen::Vector3d::Zero();

    bool is_identity() const { return translation_mm.isZero(0) && rotation_deg.isZero(0); }
    void add(const Deviation& deviation, double value) {
        (deviation.is_rotation_error() ? rotation_deg : translation_mm) += value * deviation.direction;
    }
    Eigen::Matrix3d rotation() const {
        const double angle_deg = rotation_deg.norm();
        if (angle_deg == 0) return Eigen::Matrix3d::Identity();
        return Eigen::AngleAxisd(angle_deg * kRadPerDeg, rotation_deg / angle_deg).toRotationMatrix();
    }
    rrs::CartPos pose() const {
        rrs::CartPos pose = rrs::CartPos::Identity();
        pose.linear() = rotation();
        pose.translation() = translation_mm;
        return pose;
    }
    /// Returns the motion of a line through the origin of `joint`, given in world axes, as a motion in that
    /// frame.
    rrs::CartPos in_joint_frame(const rrs::CartPos& joint) const {
        const Eigen::Matrix3d axes = joint.linear();
        rrs::CartPos pose = rrs::CartPos::Identity();
        pose.linear() = axes.transpose() * rotation() * axes;
        pose.translation() = axes.transpose() * translation_mm;
        return pose;
    }
    /// Returns the frame moved in world axes and rotated about its origin.
    rrs::CartPos moved(const rrs::CartPos& frame) const {
        rrs::CartPos pose = rrs::CartPos::Identity();
        pose.linear() = rotation() * frame.linear();
        pose.translation() = frame.translation() + translation_mm;
        return pose;
    }
};

/// Motions that result from the values of deviations.
struct SmallMotions {
    std::vector<Motion> axes;
    Motion base, tool, work, instrument;

    Motion& of(const Deviation& deviation) {
        switch (deviation.kind) {
            case Kind::base: return base;
            case Kind::tool: return tool;
            case Kind::work: return work;
            case Kind::instrument: return instrument;
            default: return axes[deviation.axis];
        }
    }
};

void add_frame(std::vector<Deviation>& list, std::string_view frame, Kind kind, bool is_rotation) {
    for (std::size_t i = 0; i < kAxisNames.size(); ++i) {
        list.push_back({.name = is_rotation ? fmt::format("{} turn_{}_deg", frame, kAxisNames[i])
                                            : fmt::format("{} {}_mm", frame, kAxisNames[i]),
                        .kind = kind,
                        .unit = is_rotation ? DeviationUnit::deg : DeviationUnit::mm,
                        .direction = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(i))});
    }
}

void add_zero(std::vector<Deviation>& list, const machine::Machine& machine, std::size_t axis) {
    const bool linear = machine.axes[axis].kind == machine::AxisKind::linear;
    list.push_back({.name = fmt::format("{} zero_{}", machine.axes[axis].letter, linear ? "mm" : "deg"),
                    .kind = Kind::zero,
                    .unit = linear ? DeviationUnit::mm : DeviationUnit::deg,
                    .axis = axis});
}

/// Adds the two world axes most perpendicular to a joint's line, orthogonalised to it.
void add_perpendicular(std::vector<Deviation>& list, const machine::Machine& machine, std::size_t axis,
                       Kind kind, const Eigen::Vector3d& line) {
    Eigen::Index along = 0;
    line.cwiseAbs().maxCoeff(&along);
    const bool tilt = kind == Kind::tilt;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < 3; ++i) {
        if (i == along) continue;
        Eigen::Vector3d direction = Eigen::Vector3d::Unit(i);
        direction -= direction.dot(line) * line + direction.dot(first) * first;
        direction.normalize();
        if (first.isZero(0)) first = direction;
        list.push_back({.name = fmt::format("{} {}_{}_{}", machine.axes[axis].letter, tilt ? "tilt" : "shift",
                                            kAxisNames[static_cast<std::size_t>(i)], tilt ? "deg" : "mm"),
                        .kind = kind,
                        .unit = tilt ? DeviationUnit::deg : DeviationUnit::mm,
                        .axis = axis,
                        .direction = direction});
    }
}

bool is_fixed(const Deviation& deviation, const std::vector<std::string>& fixed) {
    return std::any_of(fixed.begin(), fixed.end(), [&](const std::string& words) {
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

rrs::CartPos axis_pose(const machine::Axis& axis) {
    return axis.frame ? machine::frame_pose(*axis.frame) : rrs::CartPos::Identity();
}

}  // namespace

double typical_size(const Deviation& deviation) {
    constexpr double kTypical_mm = 0.5, kTypical_deg = 0.1, kTypical_ppm = 1000;
    switch (deviation.unit) {
        case DeviationUnit::mm: return kTypical_mm;
        case DeviationUnit::deg: return kTypical_deg;
        case DeviationUnit::ppm: break;
    }
    return kTypical_ppm;
}

// Users expect offsets first, then the machine's pose, then lines of axes from the tool (or the work) back to
// the world. So of three slides that are not square the first one defines the direction.
std::vector<Deviation> all_deviations(const machine::Machine& machine,
                                      const DeviationOptions& deviation_options) {
    std::vector<Deviation> list;
    const auto frames =
        machine::make_kinematics(without_bodies(machine))
            ->chain()
            .joint_frames(rrs::JointPos::Zero(static_cast<Eigen::Index>(machine.axes.size())));
    std::vector<std::size_t> rotary, linear;
    for (std::size_t i = machine.axes.size(); i-- > 0;) {
        if (machine.axes[i].carries == machine::CarriedPart::none) continue;
        (machine.axes[i].kind == machine::AxisKind::rotary ? rotary : linear).push_back(i);
    }
    const auto line = [&](std::size_t axis) -> Eigen::Vector3d { return frames[axis].linear().col(2); };
    if (deviation_options.instrument_frame) {
        add_frame(list, "instrument", Kind::instrument, true);
        add_frame(list, "instrument", Kind::instrument, false);
    }
    for (std::size_t i = 0; i < machine.axes.size(); ++i)
        if (machine.axes[i].carries != machine::CarriedPart::none) add_zero(list, machine, i);
    add_frame(list, "tool", Kind::tool, false);
    add_frame(list, "base", Kind::base, true);
    for (const std::size_t axis : rotary) {
        add_perpendicular(list, machine, axis, Kind::shift, line(axis));
        add_perpendicular(list, machine, axis, Kind::tilt, line(axis));
    }
    for (const std::size_t axis : linear) add_perpendicular(list, machine, axis, Kind::tilt, line(axis));
    for (auto axis = linear.rbegin(); axis != linear.rend(); ++axis)
        list.push_back({.name = fmt::format("{} scale_ppm", machine.axes[*axis].letter),
                        .kind = Kind::scale,
                        .unit = DeviationUnit::ppm,
                        .axis = *axis});
    add_frame(list, "tool", Kind::tool, true);
    add_frame(list, "base", Kind::base, false);
    for (const bool is_rotation : {false, true}) add_frame(list, "work", Kind::work, is_rotation);
    std::erase_if(list,
                  [&](const Deviation& deviation) { return is_fixed(deviation, deviation_options.fixed); });
    return list;
}

std::optional<std::string> find_unknown_fixed(const machine::Machine& machine,
                                              const DeviationOptions& deviation_options) {
    const auto all =
        all_deviations(machine, {.instrument_frame = deviation_options.instrument_frame, .fixed = {}});
    for (const std::string& words : deviation_options.fixed) {
        if (std::none_of(all.begin(), all.end(),
                         [&](const Deviation& one) { return is_fixed(one, {words}); }))
            return words;
    }
    return std::nullopt;
}

DeviatedMachine::DeviatedMachine(Geometry nominal) : nominal_(std::move(nominal)) {
    const std::size_t count = nominal_.machine.axes.size();
    nominal_.scales.resize(count, 1);
    const auto kinematics_model = machine::make_kinematics(without_bodies(nominal_.machine));
    const kinematics::Chain& chain = kinematics_model->chain();
    joints_ = chain.joint_frames(rrs::JointPos::Zero(static_cast<Eigen::Index>(count)));
    after_joints_.resize(count, rrs::CartPos::Identity());
    for (const kinematics::Branch* side : {&chain.tool_side(), &chain.work_side()}) {
        for (const kinematics::Link& link : side->links)
            after_joints_[static_cast<std::size_t>(link.joint)] = link.after;
    }
}

Geometry DeviatedMachine::at(std::span<const Deviation> deviations, const Eigen::VectorXd& values) const {
    Geometry found = nominal_;
    SmallMotions motions{
        .axes = std::vector<Motion>(joints_.size()), .base = {}, .tool = {}, .work = {}, .instrument = {}};
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        const Deviation& deviation = deviations[i];
        const double value = values[static_cast<Eigen::Index>(i)];
        if (deviation.kind == Kind::zero) {
            found.machine.axes[deviation.axis].zero += value;
        } else if (deviation.kind == Kind::scale) {
            found.scales[deviation.axis] += value * kPerMillion;
        } else {
            motions.of(deviation).add(deviation, value);
        }
    }
    // Motions that the next frame of each side must undo.
    std::array<rrs::CartPos, 2> inverse_motions{rrs::CartPos::Identity(), rrs::CartPos::Identity()};
    std::array<bool, 2> moved{};
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        machine::Axis& axis = found.machine.axes[i];
        if (axis.carries == machine::CarriedPart::none) continue;
        const std::size_t side = axis.carries == machine::CarriedPart::work ? 1 : 0;
        if (motions.axes[i].is_identity() && !moved[side]) continue;
        const rrs::CartPos line = motions.axes[i].in_joint_frame(joints_[i]);
        const rrs::CartPos inverse_motion = after_joints_[i].inverse() * line.inverse() * after_joints_[i];
        axis.frame = to_frame(inverse_motions[side] * axis_pose(axis) *
                              (axis.direction ? inverse_motion.inverse() : line));
        inverse_motions[side] = inverse_motion;
        moved[side] = !motions.axes[i].is_identity();
    }
    machine::Machine& machine = found.machine;
    if (!motions.base.is_identity())
        machine.base = to_frame(motions.base.moved(machine::frame_pose(machine.base)));
    if (moved[0] || !motions.tool.is_identity())
        machine.tool = to_frame(inverse_motions[0] * machine::frame_pose(machine.tool) * motions.tool.pose());
    if (moved[1] || !motions.work.is_identity())
        machine.work = to_frame(inverse_motions[1] * machine::frame_pose(machine.work) * motions.work.pose());
    found.instrument = motions.instrument.moved(found.instrument);
    return found;
}

Geometry DeviatedMachine::with_nominal_orientation(Geometry geometry) const {
    const rrs::JointPos zero = rrs::JointPos::Zero(static_cast<Eigen::Index>(joints_.size()));
    const auto orientation = [&](const machine::Machine& machine) -> Eigen::Matrix3d {
        return machine::make_kinematics(without_bodies(machine))->forward(zero).linear();
    };
    rrs::CartPos tool = machine::frame_pose(geometry.machine.tool);
    tool.linear() = tool.linear() * orientation(geometry.machine).transpose() * orientation(nominal_.machine);
    geometry.machine.tool = to_frame(tool);
    return geometry;
}

TcpCalculator::TcpCalculator(const Geometry& geometry)
    : kinematics_(machine::make_kinematics(without_bodies(geometry.machine))),
      axes_(geometry.machine.axes),
      scales_(geometry.scales),
      instrument_(geometry.instrument) {}

rrs::CartPos TcpCalculator::tcp(std::span<const double> readings) const {
    rrs::JointPos joints(static_cast<Eigen::Index>(axes_.size()));
    for (std::size_t i = 0; i < axes_.size(); ++i)
        joints[static_cast<Eigen::Index>(i)] = machine::joint_value(axes_[i], readings[i] * scales_[i]);
    return instrument_ * kinematics_->forward(joints);
}

}  // namespace gsim::calibrate
