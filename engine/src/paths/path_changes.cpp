#include "engine/src/paths/path_changes.h"

#include <Eigen/Geometry>

#include <fmt/format.h>

#include "base/units.h"
#include "motion/kinematics/pose.h"
#include "toolpath/placement/changes.h"
#include "toolpath/rotary/machine_space.h"

namespace gsim::engine {

namespace {

rrs::CartPos to_pose(const FramePose& frame) {
    const auto& [x_mm, y_mm, z_mm] = frame.origin_mm;
    const auto& [roll_deg, pitch_deg, yaw_deg] = frame.rpy_deg;
    return kinematics::pose_from_rpy(
        {x_mm, y_mm, z_mm, roll_deg * kRadPerDeg, pitch_deg * kRadPerDeg, yaw_deg * kRadPerDeg});
}

bool is_same(const FramePose& one, const FramePose& other) {
    return one.origin_mm == other.origin_mm && one.rpy_deg == other.rpy_deg;
}

bool is_unchanged(const PathChanges& changes) {
    return is_same(changes.from, changes.to) && is_same(changes.place, {});
}

/// Returns the origin of the numbers of a path, X, Y and Z of the machine.
Result<path::Vector> program_origin(const path::Program& program, const PathContext& context, bool turns) {
    const path::WorkFrame& frame = program.paths[program.root].frame;
    if (frame.set_offset_mm) return *frame.set_offset_mm;
    const std::vector<std::string>& systems = context.post.offsets.systems;
    // At the beginning, the machine's position gets its own coordinates.
    if (frame.name.empty() && !context.post.blocks.start_position.empty()) return path::Vector{};
    const std::string name = !frame.name.empty() || systems.empty() ? frame.name : systems.front();
    path::Vector origin_mm{};
    if (context.data == nullptr) return origin_mm;
    const auto offset = context.data->offsets.find(name);
    if (offset == context.data->offsets.end()) return origin_mm;
    for (const auto& [letter, value] : offset->second) {
        if (letter >= 'X' && letter <= 'Z') {
            origin_mm[static_cast<std::size_t>(letter - 'X')] = value;
        } else if (turns && value != 0) {
            return Unexpected(
                fmt::format("the path cannot be rotated: its work offset G{} moves {}", name, letter));
        }
    }
    return origin_mm;
}

/// Returns the vector of the TCP from the machine's zero to a position of X, Y and Z.
Eigen::Vector3d approach_vector(const path::MachineSpace& space, const path::Vector& position_mm) {
    path::AxisValues at = space.home(), zero = at;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(space.machine().find(static_cast<char>('X' + i)).value());
        at[axis] = position_mm[i];
        zero[axis] = 0;
    }
    return space.tcp(at) - space.tcp(zero);
}

Result<void> transform_path(path::PathFile& file, const PathContext& context, const path::MachineSpace& space,
                            const PathChanges& changes) {
    const rrs::CartPos motion =
        to_pose(changes.to) * to_pose(changes.place) * to_pose(changes.from).inverse(Eigen::Isometry);
    const auto origin_mm = program_origin(file.program, context, !motion.linear().isIdentity(1e-12));
    if (!origin_mm) return Unexpected(file.file_name + ": " + origin_mm.error().message);
    const Eigen::Translation3d to_work(approach_vector(space, *origin_mm));
    const rrs::CartPos program_motion = rrs::CartPos(to_work.inverse()) * motion * rrs::CartPos(to_work);
    return path::place(file.program, program_motion, space).map_error([&](const path::TargetError& error) {
        return gsim::Error(file.with_location(error.where, error.message));
    });
}

}  // namespace

Result<void> change_path(path::PathFile& file, const PathContext& context, const PathChanges& changes) {
    const auto with_location = [&](const path::TargetError& error) {
        return gsim::Error(file.with_location(error.where, error.message));
    };
    for (const PathChanges::Feed& feed : changes.feeds) {
        const auto changed = path::change_feeds(file.program, {feed.path, feed.value, feed.is_factor});
        if (!changed) return Unexpected(file.file_name + ": " + changed.error().message);
    }
    if (is_unchanged(changes) && changes.order.empty()) return {};
    const auto space = path::MachineSpace::make(context.machine);
    if (!space) return Unexpected(space.error().message);
    if (!is_unchanged(changes)) {
        if (auto done = transform_path(file, context, *space, changes); !done) return done;
    }
    if (changes.order.empty()) return {};
    return path::reorder(file.program, changes.order, *space)
        .map_error(with_location)
        .and_then([&]() -> Result<void> {
            // Messages name targets by their positions in the file.
            std::vector<path::SourceLocation>& locations = file.targets[file.program.root];
            const std::vector<path::SourceLocation> before = locations;
            for (std::size_t i = 0; i < locations.size(); ++i) locations[i] = before[changes.order[i]];
            return {};
        });
}

}  // namespace gsim::engine
