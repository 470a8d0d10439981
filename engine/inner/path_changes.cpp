#include "engine/inner/path_changes.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "runtime/kinematics/pose.h"
#include "runtime/path/changes.h"
#include "runtime/path/machine_space.h"

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

}  // namespace

tl::expected<void, std::string> change_path(path::PathFile& file, const machine::Machine& machine,
                                            const PathChanges& changes) {
    using Done = tl::expected<void, std::string>;
    const auto located = [&](const path::Fault& fault) { return file.located(fault.where, fault.sentence); };
    for (const PathChanges::Feed& feed : changes.feeds) {
        if (auto done = path::change_feeds(file.program, {feed.path, feed.value, feed.is_factor}); !done)
            return tl::unexpected(file.file_name + ": " + done.error());
    }
    if (stays(changes) && changes.order.empty()) return {};
    const auto space = path::MachineSpace::make(machine);
    if (!space) return tl::unexpected(space.error());
    if (!stays(changes)) {
        const rrs::CartPos motion = pose_of_frame(changes.to) * pose_of_frame(changes.place) *
                                    pose_of_frame(changes.from).inverse(Eigen::Isometry);
        if (auto done = path::place(file.program, motion, *space); !done)
            return tl::unexpected(located(done.error()));
    }
    if (changes.order.empty()) return {};
    const bool turns = space->rotary_count() > 0;
    return path::reorder(file.program, changes.order, turns).map_error(located).and_then([&]() -> Done {
        // Messages name targets by their places in the file.
        std::vector<path::Place>& places = file.targets[file.program.root];
        const std::vector<path::Place> before = places;
        for (std::size_t i = 0; i < places.size(); ++i) places[i] = before[changes.order[i]];
        return {};
    });
}

}  // namespace gsim::engine
