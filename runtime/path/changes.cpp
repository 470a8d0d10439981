#include "runtime/path/changes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "base/text/nearest_name.h"
#include "base/units.h"
#include "runtime/kinematics/pose.h"
#include "runtime/path/arc_shape.h"
#include "runtime/path/states.h"

namespace gsim::path {

namespace {

using Eigen::Vector3d;
using Refused = tl::unexpected<Fault>;

constexpr double kSameAxis = 1e-9;

Vector vector_of(const Vector3d& from) {
    return {from.x(), from.y(), from.z()};
}

/// Rotary values that the whole of a machine's tool turns along with, by an angle about an axis of the work.
class TurningAxis {
  public:
    /// The rotary axis that does it whatever the others do; nothing: none does.
    static std::optional<TurningAxis> find(const MachineSpace& space, const Eigen::Matrix3d& turn) {
        const Eigen::AngleAxisd angle_axis(turn);
        for (std::size_t i = 0; i < space.rotary_count(); ++i) {
            for (const double sign : {1.0, -1.0}) {
                const TurningAxis axis{space.rotary_axis(i).letter, sign * angle_axis.angle() / kRadPerDeg};
                if (axis.turns_all(space, i, turn)) return axis;
            }
        }
        return std::nullopt;
    }

    char letter = 0;
    double by_deg = 0;

  private:
    bool turns_all(const MachineSpace& space, std::size_t axis, const Eigen::Matrix3d& turn) const {
        for (const double lean_deg : {25.0, -40.0}) {
            AxisValues rotary =
                AxisValues::Constant(static_cast<Eigen::Index>(space.rotary_count()), lean_deg);
            const Vector3d before = space.tool_axis(space.axes(Vector3d::Zero(), rotary));
            rotary[static_cast<Eigen::Index>(axis)] += by_deg;
            const Vector3d behind = space.tool_axis(space.axes(Vector3d::Zero(), rotary));
            if ((turn * before - behind).norm() > kSameAxis) return false;
        }
        return true;
    }

    TurningAxis(char its_letter, double its_angle_deg) : letter(its_letter), by_deg(its_angle_deg) {}
};

class Placing {
  public:
    Placing(Program& program, const rrs::CartPos& motion, const MachineSpace& space)
        : program_(program),
          motion_(motion),
          space_(space),
          turns_(!motion.linear().isIdentity(kSameAxis)),
          axis_(turns_ ? TurningAxis::find(space, motion.linear()) : std::nullopt) {}

    tl::expected<void, Fault> run() {
        if (auto fault = fault_of_frames()) return Refused(*std::move(fault));
        for (std::size_t path = 0; path < program_.paths.size(); ++path) {
            std::vector<Target>& targets = program_.paths[path].targets;
            bool knows_axis = false;
            for (std::size_t i = 0; i < targets.size(); ++i) {
                auto* point = std::get_if<Point>(&targets[i]);
                if (point == nullptr) continue;
                if (auto fault = turn(*point, knows_axis))
                    return Refused(Fault{{path, i}, *std::move(fault)});
                move(*point);
            }
        }
        return {};
    }

  private:
    std::optional<Fault> fault_of_frames() const {
        const auto fault = [&](const char* why) {
            return Fault{{program_.root, std::nullopt}, fmt::format("the path cannot be placed: {}", why)};
        };
        if (program_.is_recorded()) return fault("it was recorded, and is where the run was");
        const WorkFrame& own = program_.paths[program_.root].frame;
        const auto is_own = [&](const WorkFrame& frame) {
            return frame.touches.empty() && (frame.name.empty() || frame.name == own.name);
        };
        for (const Path& path : program_.paths) {
            bool all = is_own(path.frame);
            for (const Target& target : path.targets) {
                const auto* use = std::get_if<SubPath>(&target);
                all = all && (use == nullptr || is_own(use->frame));
            }
            if (!all) return fault("it is in several work frames, or finds them by touches");
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

    /// Why it cannot be turned.
    std::optional<std::string> turn(Point& point, bool& knows_axis) const {
        if (!turns_ || !point.orientation) return std::nullopt;
        if (auto* axis = std::get_if<ToolAxis>(&*point.orientation)) {
            axis->direction = turned(axis->direction);
        } else if (auto* rpy = std::get_if<RollPitchYaw>(&*point.orientation)) {
            *rpy = turned(*rpy);
        } else {
            return turn_rotary(point, knows_axis);
        }
        return std::nullopt;
    }

    std::optional<std::string> turn_rotary(Point& point, bool& knows_axis) const {
        auto& values = std::get<RotaryAxes>(*point.orientation);
        const auto fault = [&](std::string letters) {
            return fmt::format(
                "the path cannot be turned: the point should say where the rotary axes {} stand", letters);
        };
        if (axis_) {
            const auto named = values.find(axis_->letter);
            if (named != values.end()) named->second += axis_->by_deg;
            knows_axis = knows_axis || named != values.end();
            return knows_axis ? std::nullopt : std::optional(fault(std::string(1, axis_->letter)));
        }
        AxisValues rotary = space_.home_rotary();
        for (std::size_t i = 0; i < space_.rotary_count(); ++i) {
            const auto named = values.find(space_.rotary_axis(i).letter);
            if (named == values.end()) return fault(letters());
            rotary[static_cast<Eigen::Index>(i)] = named->second;
        }
        const Vector3d axis = space_.tool_axis(space_.axes(to_eigen(point.position_mm), rotary));
        point.orientation = ToolAxis{turned(vector_of(axis))};
        return std::nullopt;
    }

    std::string letters() const {
        std::string all;
        for (std::size_t i = 0; i < space_.rotary_count(); ++i)
            all += fmt::format("{}{}", all.empty() ? "" : ", ", space_.rotary_axis(i).letter);
        return all;
    }

    Vector moved(const Vector& point_mm) const { return vector_of(motion_ * to_eigen(point_mm)); }
    Vector turned(const Vector& direction) const { return vector_of(motion_.linear() * to_eigen(direction)); }
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
    bool turns_;
    std::optional<TurningAxis> axis_;
};

/// The first point of a path and of those that it begins with; null: it begins with no point.
const Point* first_point(const Program& program, std::size_t path) {
    const std::vector<Target>& targets = program.paths[path].targets;
    if (targets.empty()) return nullptr;
    if (const auto* use = std::get_if<SubPath>(&targets.front())) return first_point(program, use->path);
    return std::get_if<Point>(&targets.front());
}

/// Whether a path says itself what feed its first cut has.
bool has_own_feed(const Program& program, std::size_t path, bool& known) {
    for (const Target& target : program.paths[path].targets) {
        if (const auto* use = std::get_if<SubPath>(&target)) {
            if (!has_own_feed(program, use->path, known)) return false;
        } else if (const auto* point = std::get_if<Point>(&target)) {
            known = known || point->feed_mm_min || point->feed_deg_min;
            const bool cuts = point->motion == MotionType::linear || point->motion == MotionType::circular;
            if (cuts && !known && !point->duration_s) return false;
        }
        if (known) return true;
    }
    return true;
}

bool names_acceleration(const Program& program) {
    for (const Path& path : program.paths) {
        for (const Target& target : path.targets) {
            const auto* point = std::get_if<Point>(&target);
            if (point != nullptr && point->acceleration_mm_s2) return true;
        }
    }
    return false;
}

/// Whether the same runs: what was never turned on is off.
bool runs_alike(const Inherited<std::string>& one, const Inherited<std::string>& other) {
    const auto is_off = [](const Inherited<std::string>& each) {
        return !each.differs() && (!each.value() || each.value()->ends_with("_off"));
    };
    return one == other || (is_off(one) && is_off(other));
}

bool runs_alike(const Running& one, const Running& other) {
    const bool spindle = runs_alike(one.spindle, other.spindle);
    const bool stands = spindle && runs_alike(one.spindle, Inherited<std::string>());
    return spindle && (stands || one.speed == other.speed) && runs_alike(one.flood, other.flood) &&
           runs_alike(one.mist, other.mist);
}

/// What a sub-path takes over, but for where the tool stands and how fast it goes.
bool begins_alike(const State& one, const State& other) {
    return one.jet_on == other.jet_on && one.abrasive_on == other.abrasive_on &&
           runs_alike(one.running, other.running) && one.frame == other.frame && one.tool == other.tool &&
           one.work_offset == other.work_offset && one.at_machine_point == other.at_machine_point;
}

/// Why a target of the root cannot stand elsewhere.
std::optional<std::string> fault_of_moving(const Program& program, const Target& target,
                                           bool needs_orientation) {
    const auto* use = std::get_if<SubPath>(&target);
    if (use == nullptr) return "what is put in another order must be sub-paths";
    const std::string& name = program.paths[use->path].name;
    const Point* first = first_point(program, use->path);
    if (first == nullptr || first->motion == MotionType::circular || first->motion == MotionType::none)
        return fmt::format("the sub-path '{}' should begin with a straight motion or a rapid", name);
    if (needs_orientation && !first->orientation)
        return fmt::format("the first point of the sub-path '{}' should have an orientation of its own",
                           name);
    bool known = false;
    if (!has_own_feed(program, use->path, known))
        return fmt::format("the sub-path '{}' should have a feed of its own before it cuts", name);
    return std::nullopt;
}

std::size_t change_feeds(Path& path, const FeedChange& change) {
    std::size_t changed = 0;
    for (Target& target : path.targets) {
        auto* point = std::get_if<Point>(&target);
        if (point == nullptr || !point->feed_mm_min) continue;
        *point->feed_mm_min = change.is_factor ? *point->feed_mm_min * change.value : change.value;
        ++changed;
    }
    return changed;
}

}  // namespace

tl::expected<void, Fault> place(Program& program, const rrs::CartPos& motion, const MachineSpace& space) {
    if (motion.isApprox(rrs::CartPos::Identity(), 0)) return {};
    return Placing(program, motion, space).run();
}

tl::expected<void, Fault> reorder(Program& program, std::span<const std::size_t> order,
                                  bool needs_orientation) {
    const std::vector<Target> targets = program.paths[program.root].targets;
    const auto refused = [&](std::optional<std::size_t> target, std::string why) {
        return Refused(Fault{{program.root, target}, std::move(why)});
    };
    std::vector<std::size_t> all(targets.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    if (!std::is_permutation(order.begin(), order.end(), all.begin(), all.end()))
        return refused(std::nullopt,
                       fmt::format("the order should have each of 0 to {} once", targets.size() - 1));
    for (const std::size_t i : all) {
        if (auto fault = fault_of_moving(program, targets[i], needs_orientation)) return refused(i, *fault);
    }
    if (names_acceleration(program))
        return refused(std::nullopt, "a path that says accelerations has an order that counts");
    const States before(program);
    Program changed = program;
    for (std::size_t i = 0; i < order.size(); ++i) changed.paths[program.root].targets[i] = targets[order[i]];
    const States behind(changed);
    for (const std::size_t i : all) {
        const std::size_t path = std::get<SubPath>(targets[i]).path;
        if (!begins_alike(before.entry(path), behind.entry(path)))
            return refused(i, fmt::format("the sub-path '{}' begins with something else running there",
                                          program.paths[path].name));
    }
    program = std::move(changed);
    return {};
}

tl::expected<void, std::string> change_feeds(Program& program, const FeedChange& change) {
    std::size_t changed = 0;
    bool found = change.path.empty();
    std::vector<std::string_view> names;
    for (Path& path : program.paths) {
        names.emplace_back(path.name);
        if (!change.path.empty() && path.name != change.path) continue;
        found = true;
        changed += change_feeds(path, change);
    }
    if (!found) {
        const auto nearest = text::nearest_name(change.path, names);
        return tl::unexpected(fmt::format("there is no path '{}'{}", change.path,
                                          nearest ? fmt::format("; did you mean '{}'?", *nearest) : ""));
    }
    if (changed == 0) {
        return tl::unexpected(change.path.empty() ? std::string("no point of the path has a feed")
                                                  : fmt::format("no point of '{}' has a feed", change.path));
    }
    return {};
}

}  // namespace gsim::path
