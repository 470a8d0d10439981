#include "analysis/check/axis_motion.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "motion/kinematics/chain.h"

namespace gsim::check {

namespace {

constexpr double kDirectionTolerance =
    1e-6;  // what a direction may be off an axis of the frame, as a share of its length
constexpr double kFlatTolerance = 1e-3;  // three directions in a plane have no hand

// Direction of the work frame, as seen from the front.
struct Side {
    const char* sign;            // "+x"
    const char* direction_text;  // "moves ... to the right"
    const char* turn;            // sense of a turn about it, seen from the best side
};

// Sides of x, y and z: towards plus, and towards minus.
constexpr std::array<std::array<Side, 2>, 3> kSides{{
    {{{"+x", "to the right", "counter-clockwise seen from the right"},
      {"-x", "to the left", "clockwise seen from the right"}}},
    {{{"+y", "to the back", "clockwise seen from the front"},
      {"-y", "to the front", "counter-clockwise seen from the front"}}},
    {{{"+z", "up", "counter-clockwise seen from above"}, {"-z", "down", "clockwise seen from above"}}},
}};

// Returns the side that a direction points to; null if it lies between them.
const Side* find_view_direction(const Eigen::Vector3d& direction) {
    Eigen::Index largest = 0;
    if (direction.cwiseAbs().maxCoeff(&largest) < 1 - kDirectionTolerance) return nullptr;
    return &kSides[static_cast<std::size_t>(largest)][direction[largest] < 0 ? 1 : 0];
}

std::string coordinates(const Eigen::Vector3d& direction) {
    const auto rounded = [](double value) { return std::round(value * 1e3) / 1e3 + 0.0; };
    return fmt::format("({:.3g} {:.3g} {:.3g})", rounded(direction.x()), rounded(direction.y()),
                       rounded(direction.z()));
}

std::string direction_text(const Eigen::Vector3d& direction) {
    if (const Side* side = find_view_direction(direction))
        return fmt::format("{} ({})", side->direction_text, side->sign);
    return "along " + coordinates(direction);
}

std::string turn(const Eigen::Vector3d& direction) {
    if (const Side* side = find_view_direction(direction))
        return fmt::format("{} (about {})", side->turn, side->sign);
    return fmt::format("counter-clockwise about {}", coordinates(direction));
}

const AxisMotion* find_motion(const std::vector<AxisMotion>& motions, char letter, bool is_rotary) {
    for (const AxisMotion& motion : motions) {
        if (motion.letter == letter && motion.is_rotary == is_rotary) return &motion;
    }
    return nullptr;
}

}  // namespace

std::vector<AxisMotion> axis_motions(const machine::Machine& machine) {
    const auto kinematics = machine::make_kinematics(machine);
    const kinematics::Chain& chain = kinematics->chain();
    const rrs::JointPos home = machine::home_position(machine);
    const std::vector<rrs::CartPos> frames = chain.joint_frames(home);
    const Eigen::Matrix3d to_work = chain.work_frames(home).back().linear().transpose();
    std::vector<AxisMotion> motions;
    motions.reserve(machine.axes.size());
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
        const machine::Axis& axis = machine.axes[i];
        if (axis.carries == machine::CarriedPart::none) continue;
        const bool work = axis.carries == machine::CarriedPart::work;
        const Eigen::Vector3d of_joint = to_work * frames[i].linear().col(2);
        motions.push_back({.letter = axis.letter,
                           .is_rotary = axis.kind == machine::AxisKind::rotary,
                           .carries_work = work,
                           .direction = work ? Eigen::Vector3d(-of_joint) : of_joint});
    }
    return motions;
}

std::string to_message(const AxisMotion& motion) {
    const Eigen::Vector3d work_direction = -motion.direction;
    if (motion.is_rotary) {
        if (!motion.carries_work)
            return fmt::format("+{} turns the tool {}", motion.letter, turn(motion.direction));
        return fmt::format(
            "+{} turns the workpiece {}, so the tool moves around it in the opposite direction",
            motion.letter, turn(work_direction));
    }
    if (!motion.carries_work)
        return fmt::format("+{} moves the tool {}", motion.letter, direction_text(motion.direction));
    return fmt::format("+{} moves the workpiece {}, so the tool moves {} relative to it", motion.letter,
                       direction_text(work_direction), direction_text(motion.direction));
}

std::vector<std::string> find_left_handed_axes(const std::vector<AxisMotion>& motions) {
    std::vector<std::string> found;
    for (const std::string_view set : {"XYZ", "UVW"}) {
        const AxisMotion* first = find_motion(motions, set[0], false);
        const AxisMotion* second = find_motion(motions, set[1], false);
        const AxisMotion* third = find_motion(motions, set[2], false);
        if (first == nullptr || second == nullptr || third == nullptr) continue;
        if (first->direction.cross(second->direction).dot(third->direction) > -kFlatTolerance) continue;
        found.push_back(
            fmt::format("{0} {1} {2} are left-handed: turning +{0} to +{1} advances a right-hand screw "
                        "against +{2}, so parts are mirrored; reverse one axis, or exchange two letters",
                        set[0], set[1], set[2]));
    }
    return found;
}

std::vector<std::string> find_left_handed_rotations(const std::vector<AxisMotion>& motions) {
    std::vector<std::string> found;
    for (const std::string_view pair : {"AX", "BY", "CZ"}) {
        const AxisMotion* rotary = find_motion(motions, pair[0], true);
        const AxisMotion* line = find_motion(motions, pair[1], false);
        if (rotary == nullptr || line == nullptr ||
            rotary->direction.dot(line->direction) > kDirectionTolerance - 1)
            continue;
        found.push_back(fmt::format(
            "+{0} turns against the right-hand rule about +{1}; ISO 841 requires the opposite direction",
            pair[0], pair[1]));
    }
    return found;
}

}  // namespace gsim::check
