#include "engine/pose.h"

#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "base/text/number.h"
#include "base/units.h"
#include "collision/monitor/touching.h"
#include "engine/src/guarded.h"
#include "engine/src/machine/machine_parts.h"
#include "engine/src/values.h"
#include "motion/kinematics/pose.h"

namespace gsim::engine {

using Eigen::Vector3d;
using text::DiagnosticKind;

namespace {

constexpr double kSlack = 1e-6;  // mm or deg that an axis may be beyond its range by rounding
constexpr double kDigits = 1e9;  // digits shown of mm and deg; further digits are only rounding errors
constexpr double kDigitsOfDirections = 1e15;
constexpr double kParallel = 1e-12;

double rounded(double value, double digits = kDigits) {
    return text::unsigned_zero(std::round(value * digits) / digits);
}

std::array<double, 3> three(const Vector3d& values, double digits = kDigits) {
    return {rounded(values.x(), digits), rounded(values.y(), digits), rounded(values.z(), digits)};
}

Vector3d vector(const std::array<double, 3>& values) {
    return {values[0], values[1], values[2]};
}

/// Returns the smallest rotation from one direction to another, both of length 1.
Eigen::Matrix3d least_turn(const Vector3d& from, const Vector3d& to) {
    const Vector3d across = from.cross(to);
    const Vector3d about = across.norm() > kParallel ? across.normalized() : from.unitOrthogonal();
    return Eigen::AngleAxisd(std::atan2(across.norm(), from.dot(to)), about).toRotationMatrix();
}

class PoseSearch {
  public:
    PoseSearch(const Machine::Parts& parts, const PoseChoice& choice)
        : machine_(parts.input.machine),
          bodies_(parts.bodies.get()),
          choice_(choice),
          kinematics_(machine::make_kinematics(machine_)) {}

    tl::expected<Pose, Failure> run() const {
        if (auto fault = find_fault()) return refused(*std::move(fault));
        return choice_.joints ? of_joints(*choice_.joints) : of_tip();
    }

  private:
    static tl::unexpected<Failure> refused(std::string sentence) {
        return tl::unexpected(failure_of(DiagnosticKind::usage, std::move(sentence)));
    }

    std::optional<std::string> fault_of_values(const char* what,
                                               const std::optional<std::vector<double>>& values) const {
        if (!values || values->size() == machine_.axes.size()) return std::nullopt;
        return fmt::format("'{}' should have {} values, one for each axis of the machine, not {}", what,
                           machine_.axes.size(), values->size());
    }

    std::optional<std::string> find_fault() const {
        const PoseChoice& of = choice_;
        if (of.joints.has_value() == of.tip_mm.has_value())
            return "a pose is told by 'joints' or by 'tip_mm', by one of them";
        if (of.joints && (of.tool_axis || of.rpy_deg))
            return "'tool_axis' and 'rpy_deg' go with 'tip_mm', not with 'joints'";
        if (of.tool_axis && of.rpy_deg) return "'tool_axis' and 'rpy_deg' do not go together";
        if (of.tool_axis && vector(*of.tool_axis).norm() < kParallel)
            return "'tool_axis' has no length, so that it has no direction";
        if (auto fault = fault_of_values("joints", of.joints)) return fault;
        return fault_of_values("near", of.near);
    }

    rrs::JointPos joints_of(const std::vector<double>& values) const {
        rrs::JointPos joints(static_cast<Eigen::Index>(values.size()));
        for (std::size_t i = 0; i < values.size(); ++i)
            joints[static_cast<Eigen::Index>(i)] = machine::joint_value(machine_.axes[i], values[i]);
        return joints;
    }

    std::vector<double> values_of(const rrs::JointPos& joints) const {
        std::vector<double> values;
        for (std::size_t i = 0; i < machine_.axes.size(); ++i) {
            values.push_back(
                rounded(machine::axis_value(machine_.axes[i], joints[static_cast<Eigen::Index>(i)])));
        }
        return values;
    }

    std::vector<std::vector<double>> lists_of(const std::vector<rrs::JointPos>& all) const {
        std::vector<std::vector<double>> lists;
        lists.reserve(all.size());
        for (const rrs::JointPos& joints : all) lists.push_back(values_of(joints));
        return lists;
    }

    rrs::JointPos near() const {
        if (choice_.near) return joints_of(*choice_.near);
        return choice_.joints ? joints_of(*choice_.joints) : machine::home_position(machine_);
    }

    tl::expected<Pose, Failure> of_joints(const std::vector<double>& values) const {
        const rrs::JointPos joints = joints_of(values);
        const auto all = kinematics_->solutions(kinematics_->forward(joints), near());
        return pose(joints, values, all ? lists_of(*all) : std::vector<std::vector<double>>{values});
    }

    tl::expected<Pose, Failure> of_tip() const {
        rrs::CartPos wanted = rrs::CartPos::Identity();
        wanted.linear() = orientation();
        wanted.translation() = vector(*choice_.tip_mm) + wanted.linear().col(2) * choice_.tool_mm;
        const auto all = kinematics_->solutions(wanted, near());
        if (!all) return tl::unexpected(failure_of(DiagnosticKind::unreachable, all.error()));
        return pose(all->front(), values_of(all->front()), lists_of(*all));
    }

    Eigen::Matrix3d orientation() const {
        if (choice_.rpy_deg) {
            const Vector3d rpy = vector(*choice_.rpy_deg) * kRadPerDeg;
            return kinematics::pose_from_rpy({0, 0, 0, rpy.x(), rpy.y(), rpy.z()}).linear();
        }
        Eigen::Matrix3d now = kinematics_->forward(near()).linear();
        if (!choice_.tool_axis) return now;
        return least_turn(now.col(2), vector(*choice_.tool_axis).normalized()) * now;
    }

    Pose pose(const rrs::JointPos& joints, std::vector<double> values,
              std::vector<std::vector<double>> solutions) const {
        const rrs::CartPos at = kinematics_->forward(joints);
        const kinematics::Rpy rpy = kinematics::rpy_from_pose(at);
        const Vector3d axis = at.linear().col(2);
        Pose pose{.joints = std::move(values),
                  .tip_mm = three(at.translation() - axis * choice_.tool_mm),
                  .tool_axis = three(axis, kDigitsOfDirections),
                  .rpy_deg = three(Vector3d(rpy.roll_rad, rpy.pitch_rad, rpy.yaw_rad) * kDegPerRad),
                  .solutions = std::move(solutions)};
        for (std::size_t i = 0; i < machine_.axes.size(); ++i)
            pose.beyond.push_back(beyond(machine_.axes[i], pose.joints[i]));
        if (bodies_ == nullptr) return pose;
        for (const cell::ItemPair& pair : cell::touching_pairs(*bodies_, machine_, joints))
            pose.collisions.emplace_back(bodies_->items[pair.first].name, bodies_->items[pair.second].name);
        return pose;
    }

    static int beyond(const machine::Axis& axis, double value) {
        if (value < axis.min - kSlack) return -1;
        return value > axis.max + kSlack ? 1 : 0;
    }

    const machine::Machine& machine_;
    const cell::Cell* bodies_;
    const PoseChoice& choice_;
    std::shared_ptr<const kinematics::Kinematics> kinematics_;
};

}  // namespace

tl::expected<Pose, Failure> pose_of(const Machine& machine, const PoseChoice& choice) {
    return guarded([&] { return PoseSearch(machine.parts(), choice).run(); });
}

}  // namespace gsim::engine
