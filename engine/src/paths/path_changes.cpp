#include "engine/src/paths/path_changes.h"

#include <Eigen/Geometry>

#include <fmt/format.h>

#include "base/units.h"
#include "motion/kinematics/pose.h"
#include "toolpath/placement/changes.h"
#include "toolpath/rotary/machine_space.h"

namespace gsim::engine {

namespace {

rrs::CartPos pose_of_frame(const FramePose& frame) {
    const auto& [x_mm, y_mm, z_mm] = frame.origin_mm;
    const auto& [roll_deg, pitch_deg, yaw_deg] = frame.rpy_deg;
    return kinematics::pose_from_rpy(
        {x_mm, y_mm, z_mm, roll_deg * kRadPerDeg, pitch_deg * kRadPerDeg, yaw_deg * kRadPerDeg});
}

bool is_same(const FramePose& one, const FramePose& other) {
    return one.origin_mm == other.origin_mm && one.rpy_deg == other.rpy_deg;
}

bool stays(const PathChanges& changes) {
    return is_same(changes.from, changes.to) && is_same(changes.place, {});
}

using ChangeFault = tl::unexpected<std::string>;

/// Returns the origin of the numbers of a path, X, Y and Z of the machine. The error is a message.
tl::expected<path::Vector, std::string> origin_of(const path::Program& program, const PathSite& site,
                                                  bool turns) {
    const path::WorkFrame& frame = program.paths[program.root].frame;
    if (frame.set_offset_mm) return *frame.set_offset_mm;
    const std::vector<std::string>& systems = site.post.offsets.systems;
    // At the beginning, the machine's position gets its own coordinates.
    if (frame.name.empty() && !site.post.start_position.empty()) return path::Vector{};
    const std::string name = !frame.name.empty() || systems.empty() ? frame.name : systems.front();
    path::Vector origin_mm{};
    if (site.data == nullptr) return origin_mm;
    const auto offset = site.data->offsets.find(name);
    if (offset == site.data->offsets.end()) return origin_mm;
    for (const auto& [letter, value] : offset->second) {
        if (letter >= 'X' && letter <= 'Z') {
            origin_mm[static_cast<std::size_t>(letter - 'X')] = value;
        } else if (turns && value != 0) {
            return ChangeFault(
                fmt::format("the path cannot be turned: its work offset G{} moves {}", name, letter));
        }
    }
    return origin_mm;
}

/// Returns the vector of the TCP from the machine's zero to a position of X, Y and Z.
Eigen::Vector3d way_to(const path::MachineSpace& space, const path::Vector& place_mm) {
    path::AxisValues at = space.home(), zero = at;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(space.machine().find(static_cast<char>('X' + i)).value());
        at[axis] = place_mm[i];
        zero[axis] = 0;
    }
    return space.tip(at) - space.tip(zero);
}

tl::expected<void, std::string> place_path(path::PathFile& file, const PathSite& site,
                                           const path::MachineSpace& space, const PathChanges& changes) {
    const rrs::CartPos motion = pose_of_frame(changes.to) * pose_of_frame(changes.place) *
                                pose_of_frame(changes.from).inverse(Eigen::Isometry);
    const auto origin_mm = origin_of(file.program, site, !motion.linear().isIdentity(1e-12));
    if (!origin_mm) return ChangeFault(file.file_name + ": " + origin_mm.error());
    const Eigen::Translation3d to_work(way_to(space, *origin_mm));
    const rrs::CartPos of_numbers = rrs::CartPos(to_work.inverse()) * motion * rrs::CartPos(to_work);
    return path::place(file.program, of_numbers, space).map_error([&](const path::Fault& fault) {
        return file.located(fault.where, fault.sentence);
    });
}

}  // namespace

tl::expected<void, std::string> change_path(path::PathFile& file, const PathSite& site,
                                            const PathChanges& changes) {
    using Done = tl::expected<void, std::string>;
    const auto located = [&](const path::Fault& fault) { return file.located(fault.where, fault.sentence); };
    for (const PathChanges::Feed& feed : changes.feeds) {
        const auto changed = path::change_feeds(file.program, {feed.path, feed.value, feed.is_factor});
        if (!changed) return ChangeFault(file.file_name + ": " + changed.error());
    }
    if (stays(changes) && changes.order.empty()) return {};
    const auto space = path::MachineSpace::make(site.machine);
    if (!space) return ChangeFault(space.error());
    if (!stays(changes)) {
        if (auto done = place_path(file, site, *space, changes); !done) return done;
    }
    if (changes.order.empty()) return {};
    return path::reorder(file.program, changes.order, *space).map_error(located).and_then([&]() -> Done {
        // Messages name targets by their positions in the file.
        std::vector<path::Place>& places = file.targets[file.program.root];
        const std::vector<path::Place> before = places;
        for (std::size_t i = 0; i < places.size(); ++i) places[i] = before[changes.order[i]];
        return {};
    });
}

}  // namespace gsim::engine
