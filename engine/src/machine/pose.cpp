#include "engine/pose.h"

#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "base/text/number.h"
#include "base/units.h"
#include "collision/monitor/touching_pairs.h"
#include "engine/src/conversions.h"
#include "engine/src/guard_exceptions.h"
#include "engine/src/machine/machine_parts.h"
#include "motion/kinematics/pose.h"

namespace gsim::engine {

using Eigen::Vector3d;
using text::DiagnosticKind;

namespace {

constexpr double kRangeTolerance = 1e-6;  // mm or deg that an axis may be beyond its range by rounding
constexpr double kDigits = 1e9;  // digits shown of mm and deg; further digits are only rounding errors
constexpr double kDirectionDigits = 1e15;
constexpr double kParallel = 1e-12;

double rounded(double value, double digits = kDigits) {
    return text::unsigned_zero(std::round(value * digits) / digits);
}

std::array<double, 3> round_components(const Vector3d& values, double digits = kDigits) {
    return {rounded(values.x(), digits), rounded(values.y(), digits), rounded(values.z(), digits)};
}

Vector3d vector(const std::array<double, 3>& values) {
    return {values[0], values[1], values[2]};
}

/// Returns the smallest rotation from one direction to another, both of length 1.
Eigen::Matrix3d min_rotation(const Vector3d& from, const Vector3d& to) {
    const Vector3d across = from.cross(to);
    const Vector3d about = across.norm() > kParallel ? across.normalized() : from.unitOrthogonal();
    return Eigen::AngleAxisd(std::atan2(across.norm(), from.dot(to)), about).toRotationMatrix();
}

class PoseSolver {
  public:
    PoseSolver(const Machine::Parts& parts, const PoseRequest& pose_request)
        : machine_(parts.input.machine),
          bodies_(parts.bodies.get()),
          options_(pose_request),
          kinematics_(machine::make_kinematics(machine_)) {}

    tl::expected<Pose, Error> run() const {
        if (auto error = find_error()) return unexpected_error(*std::move(error));
        return options_.joints ? pose_from_joints(*options_.joints) : tcp_pose();
    }

  private:
    static tl::unexpected<Error> unexpected_error(const gsim::Error& error) {
        return tl::unexpected(make_error(DiagnosticKind::usage, error));
    }

    std::optional<gsim::Error> find_value_error(const char* what,
                                                const std::optional<std::vector<double>>& values) const {
        if (!values || values->size() == machine_.axes.size()) return std::nullopt;
        return fmt::format("'{}' must have {} values, one for each axis of the machine, not {}", what,
                           machine_.axes.size(), values->size());
    }

    std::optional<gsim::Error> find_error() const {
        const PoseRequest& of = options_;
        if (of.joints.has_value() == of.tcp_mm.has_value())
            return "a pose must have either 'joints' or 'tip_mm'";
        if (of.joints && (of.tool_axis || of.rpy_deg))
            return "'tool_axis' and 'rpy_deg' require 'tip_mm', not 'joints'";
        if (of.tool_axis && of.rpy_deg) return "'tool_axis' and 'rpy_deg' cannot be combined";
        if (of.tool_axis && vector(*of.tool_axis).norm() < kParallel)
            return "'tool_axis' must have a length greater than 0";
        if (auto error = find_value_error("joints", of.joints)) return error;
        return find_value_error("near", of.near);
    }

    rrs::JointPos joints_of(const std::vector<double>& values) const {
        rrs::JointPos joints(static_cast<Eigen::Index>(values.size()));
        for (std::size_t i = 0; i < values.size(); ++i)
            joints[static_cast<Eigen::Index>(i)] = machine::joint_value(machine_.axes[i], values[i]);
        return joints;
    }

    std::vector<double> axis_values(const rrs::JointPos& joints) const {
        std::vector<double> values;
        for (std::size_t i = 0; i < machine_.axes.size(); ++i) {
            values.push_back(
                rounded(machine::axis_value(machine_.axes[i], joints[static_cast<Eigen::Index>(i)])));
        }
        return values;
    }

    std::vector<std::vector<double>> to_value_lists(const std::vector<rrs::JointPos>& all) const {
        std::vector<std::vector<double>> value_lists;
        value_lists.reserve(all.size());
        for (const rrs::JointPos& joints : all) value_lists.push_back(axis_values(joints));
        return value_lists;
    }

    rrs::JointPos near() const {
        if (options_.near) return joints_of(*options_.near);
        return options_.joints ? joints_of(*options_.joints) : machine::home_position(machine_);
    }

    tl::expected<Pose, Error> pose_from_joints(const std::vector<double>& values) const {
        const rrs::JointPos joints = joints_of(values);
        const auto all = kinematics_->solutions(kinematics_->forward(joints), near());
        return pose(joints, values, all ? to_value_lists(*all) : std::vector<std::vector<double>>{values});
    }

    tl::expected<Pose, Error> tcp_pose() const {
        rrs::CartPos requested = rrs::CartPos::Identity();
        requested.linear() = orientation();
        requested.translation() = vector(*options_.tcp_mm) + requested.linear().col(2) * options_.tool_mm;
        const auto all = kinematics_->solutions(requested, near());
        if (!all) return tl::unexpected(make_error(DiagnosticKind::unreachable, all.error()));
        return pose(all->front(), axis_values(all->front()), to_value_lists(*all));
    }

    Eigen::Matrix3d orientation() const {
        if (options_.rpy_deg) {
            const Vector3d rpy = vector(*options_.rpy_deg) * kRadPerDeg;
            return kinematics::pose_from_rpy({0, 0, 0, rpy.x(), rpy.y(), rpy.z()}).linear();
        }
        Eigen::Matrix3d now = kinematics_->forward(near()).linear();
        if (!options_.tool_axis) return now;
        return min_rotation(now.col(2), vector(*options_.tool_axis).normalized()) * now;
    }

    Pose pose(const rrs::JointPos& joints, std::vector<double> values,
              std::vector<std::vector<double>> solutions) const {
        const rrs::CartPos at = kinematics_->forward(joints);
        const kinematics::Rpy rpy = kinematics::rpy_from_pose(at);
        const Vector3d axis = at.linear().col(2);
        Pose pose{
            .joints = std::move(values),
            .tcp_mm = round_components(at.translation() - axis * options_.tool_mm),
            .tool_axis = round_components(axis, kDirectionDigits),
            .rpy_deg = round_components(Vector3d(rpy.roll_rad, rpy.pitch_rad, rpy.yaw_rad) * kDegPerRad),
            .solutions = std::move(solutions)};
        for (std::size_t i = 0; i < machine_.axes.size(); ++i)
            pose.out_of_range.push_back(out_of_range(machine_.axes[i], pose.joints[i]));
        if (bodies_ == nullptr) return pose;
        for (const cell::ItemPair& pair : cell::touching_pairs(*bodies_, machine_, joints))
            pose.collisions.emplace_back(bodies_->items[pair.first].name, bodies_->items[pair.second].name);
        return pose;
    }

    static int out_of_range(const machine::Axis& axis, double value) {
        if (value < axis.min - kRangeTolerance) return -1;
        return value > axis.max + kRangeTolerance ? 1 : 0;
    }

    const machine::Machine& machine_;
    const cell::Cell* bodies_;
    const PoseRequest& options_;
    std::shared_ptr<const kinematics::Kinematics> kinematics_;
};

}  // namespace

tl::expected<Pose, Error> solve_pose(const Machine& machine, const PoseRequest& pose_request) {
    return guard_exceptions([&] { return PoseSolver(machine.parts(), pose_request).run(); });
}

}  // namespace gsim::engine
