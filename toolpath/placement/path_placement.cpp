#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/units.h"
#include "motion/kinematics/pose.h"
#include "toolpath/model/arc_shape.h"
#include "toolpath/placement/changes.h"

namespace gsim::path {

namespace {

using Eigen::Vector3d;
using Refused = tl::unexpected<TargetError>;

constexpr double kAxisTolerance = 1e-9;

Vector to_vector(const Vector3d& from) {
    return {from.x(), from.y(), from.z()};
}

/// Rotary axis that turns the complete tool of a machine, with an angle about an axis of the work.
class TurningAxis {
  public:
    /// Returns the rotary axis that does so whatever the others do; nullopt if none does.
    static std::optional<TurningAxis> find(const MachineSpace& space, const Eigen::Matrix3d& turn) {
        const Eigen::AngleAxisd angle_axis(turn);
        for (std::size_t i = 0; i < space.rotary_count(); ++i) {
            for (const double sign : {1.0, -1.0}) {
                const TurningAxis axis{space.rotary_axis(i).letter, sign * angle_axis.angle() / kRadPerDeg};
                if (axis.rotates_tool(space, i, turn)) return axis;
            }
        }
        return std::nullopt;
    }

    char letter = 0;
    double angle_deg = 0;

  private:
    bool rotates_tool(const MachineSpace& space, std::size_t axis, const Eigen::Matrix3d& turn) const {
        for (const double rotary_deg : {25.0, -40.0}) {
            AxisValues rotary =
                AxisValues::Constant(static_cast<Eigen::Index>(space.rotary_count()), rotary_deg);
            const Vector3d before = space.tool_axis(space.axes(Vector3d::Zero(), rotary));
            rotary[static_cast<Eigen::Index>(axis)] += angle_deg;
            const Vector3d axis_after = space.tool_axis(space.axes(Vector3d::Zero(), rotary));
            if ((turn * before - axis_after).norm() > kAxisTolerance) return false;
        }
        return true;
    }

    TurningAxis(char axis_letter, double axis_angle_deg) : letter(axis_letter), angle_deg(axis_angle_deg) {}
};

bool has_machine_points(const Program& program) {
    for (const Path& path : program.paths) {
        for (const Target& target : path.targets) {
            if (std::holds_alternative<MachinePoint>(target)) return true;
        }
    }
    return false;
}

class PathTransformer {
  public:
    PathTransformer(Program& program, const rrs::CartPos& motion, const MachineSpace& space)
        : program_(program),
          motion_(motion),
          space_(space),
          has_rotation_(!motion.linear().isIdentity(kAxisTolerance)),
          has_machine_points_(has_machine_points(program)),
          axis_(has_rotation_ ? TurningAxis::find(space, motion.linear()) : std::nullopt) {}

    tl::expected<void, TargetError> run() {
        if (auto error = find_error()) return Refused(*std::move(error));
        for (std::size_t path = 0; path < program_.paths.size(); ++path) {
            std::vector<Target>& targets = program_.paths[path].targets;
            bool is_axis_known = false;
            for (std::size_t i = 0; i < targets.size(); ++i) {
                auto* point = std::get_if<Point>(&targets[i]);
                // Fixed and reference points stay, and so do the axis values that follow them.
                if (point == nullptr) {
                    is_axis_known = is_axis_known && !has_machine_points_;
                    continue;
                }
                if (auto done = turn(*point, is_axis_known); !done)
                    return Refused(TargetError{{path, i}, std::move(done.error().message)});
                move(*point);
            }
        }
        return {};
    }

  private:
    std::optional<TargetError> find_error() const {
        const auto error = [&](const char* reason) {
            return TargetError{{program_.root, std::nullopt},
                               fmt::format("the path cannot be placed: {}", reason)};
        };
        if (program_.is_recorded()) return error("it was recorded and has the position of the run");
        const Vector3d home_axis = space_.tool_axis(space_.home());
        if (space_.rotary_count() == 0 && (motion_.linear() * home_axis - home_axis).norm() > kAxisTolerance)
            return error(
                "it would be tilted, but the machine has no rotary axis that tilts its tool or its table");
        const WorkFrame& root_frame = program_.paths[program_.root].frame;
        const auto is_root_frame = [&](const WorkFrame& frame) {
            return frame.touches.empty() && (frame.name.empty() || frame.name == root_frame.name);
        };
        for (const Path& path : program_.paths) {
            bool all = is_root_frame(path.frame);
            for (const Target& target : path.targets) {
                const auto* sub_path_call = std::get_if<SubPath>(&target);
                all = all && (sub_path_call == nullptr || is_root_frame(sub_path_call->frame));
            }
            if (!all) return error("it is in several work frames, or measures them by touches");
        }
        return std::nullopt;
    }

    void move(Point& point) const {
        point.position_mm = moved(point.position_mm);
        if (auto* via = std::get_if<ViaPoint>(&point.arc)) {
            via->via_mm = moved(via->via_mm);
        } else if (auto* about = std::get_if<CenterArc>(&point.arc)) {
            about->center_mm = moved(about->center_mm);
            about->normal = turned(about->normal);
        }
    }

    Result<void> turn(Point& point, bool& is_axis_known) const {
        if (!has_rotation_ || !point.orientation) return {};
        if (auto* axis = std::get_if<ToolAxis>(&*point.orientation)) {
            axis->direction = turned(axis->direction);
        } else if (auto* rpy = std::get_if<RollPitchYaw>(&*point.orientation)) {
            *rpy = turned(*rpy);
        } else {
            return rotate_orientation(point, is_axis_known);
        }
        return {};
    }

    Result<void> rotate_orientation(Point& point, bool& is_axis_known) const {
        auto& values = std::get<RotaryAxes>(*point.orientation);
        const auto error = [&](std::string letters) {
            return Unexpected(fmt::format(
                "the path cannot be rotated: the point must define the positions of the rotary axes {}",
                letters));
        };
        if (axis_) {
            const auto named = values.find(axis_->letter);
            if (named != values.end()) named->second += axis_->angle_deg;
            is_axis_known = is_axis_known || named != values.end();
            if (!is_axis_known) return error(std::string(1, axis_->letter));
            return {};
        }
        AxisValues rotary = space_.home_rotary();
        for (std::size_t i = 0; i < space_.rotary_count(); ++i) {
            const auto named = values.find(space_.rotary_axis(i).letter);
            if (named == values.end()) return error(letters());
            rotary[static_cast<Eigen::Index>(i)] = named->second;
        }
        const Vector3d axis = space_.tool_axis(space_.axes(to_eigen(point.position_mm), rotary));
        point.orientation = ToolAxis{turned(to_vector(axis))};
        return {};
    }

    std::string letters() const {
        std::string all;
        for (std::size_t i = 0; i < space_.rotary_count(); ++i)
            all += fmt::format("{}{}", all.empty() ? "" : ", ", space_.rotary_axis(i).letter);
        return all;
    }

    Vector moved(const Vector& point_mm) const { return to_vector(motion_ * to_eigen(point_mm)); }
    Vector turned(const Vector& direction) const { return to_vector(motion_.linear() * to_eigen(direction)); }
    RollPitchYaw turned(const RollPitchYaw& rpy) const {
        rrs::CartPos pose = kinematics::pose_from_rpy(
            {0, 0, 0, rpy.roll_deg * kRadPerDeg, rpy.pitch_deg * kRadPerDeg, rpy.yaw_deg * kRadPerDeg});
        pose.linear() = motion_.linear() * pose.linear();
        const kinematics::Rpy angles = kinematics::rpy_from_pose(pose);
        return {angles.roll_rad / kRadPerDeg, angles.pitch_rad / kRadPerDeg, angles.yaw_rad / kRadPerDeg};
    }

    Program& program_;
    const rrs::CartPos& motion_;
    const MachineSpace& space_;
    bool has_rotation_;
    bool has_machine_points_;
    std::optional<TurningAxis> axis_;
};

}  // namespace

tl::expected<void, TargetError> place(Program& program, const rrs::CartPos& motion,
                                      const MachineSpace& space) {
    if (motion.isApprox(rrs::CartPos::Identity(), 0)) return {};
    return PathTransformer(program, motion, space).run();
}

}  // namespace gsim::path
