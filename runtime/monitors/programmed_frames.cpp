#include "runtime/monitors/programmed_frames.h"

#include <utility>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/nearest_name.h"

namespace gsim::simulation {

using motion::PlanError;
using motion::PlanResult;
using rrs::Status;

ProgrammedFrames::ProgrammedFrames(cell::FrameTree frames, motion::MachineFrames machine_frames)
    : frames_(std::move(frames)), machine_frames_(std::move(machine_frames)) {}

tl::expected<std::size_t, PlanError> ProgrammedFrames::find(std::string_view name) const {
    if (const auto found = frames_.find(name)) return *found;
    const std::vector<std::string_view> names = frames_.names();
    const auto nearest = text::nearest_name(name, names);
    return motion::make_plan_error(
        Status::RRS_UNKNOWN_FRAME,
        fmt::format("The cell has no frame '{}'; {}", name,
                    nearest ? fmt::format("did you mean '{}'?", *nearest)
                            : fmt::format("known frames: {}.", text::joined(names, ", "))));
}

tl::expected<motion::WorkFrames, PlanError> ProgrammedFrames::work_frames(
    std::string_view tool_name, std::string_view object_name) const {
    auto tool = tcp_frame(tool_name);
    if (!tool) return tl::unexpected(std::move(tool.error()));
    auto object = object_frame(object_name);
    if (!object) return tl::unexpected(std::move(object.error()));
    return motion::WorkFrames{*tool, *object};
}

PlanResult ProgrammedFrames::check_same_link(std::size_t frame, std::size_t origin) const {
    if (frames_.link(frame) == frames_.link(origin)) return {};
    return motion::make_plan_error(
        Status::RRS_INVALID_PARAMETER,
        fmt::format("The frame '{}' moves relative to the frame '{}', so it would have to be attached to it.",
                    frames_.name(frame), frames_.name(origin)));
}

/// Returns a frame as seen from the tool centre point of the kinematics.
tl::expected<rrs::CartPos, PlanError> ProgrammedFrames::tcp_frame(std::string_view name) const {
    if (name == motion::kToolFrame) return machine_frames_.tool_shift();
    const auto frame = find(name);
    if (!frame) return tl::unexpected(frame.error());
    const std::size_t tool = *frames_.find(motion::kToolFrame);
    return check_same_link(*frame, tool).map([&] {
        return frames_.pose_in_link(tool).inverse() * frames_.pose_in_link(*frame);
    });
}

/// Returns a frame as seen from the work frame of the kinematics; the world moves relative to it if the
/// machine does.
tl::expected<rrs::CartPos, PlanError> ProgrammedFrames::object_frame(std::string_view name) const {
    const auto frame = find(name);
    if (!frame) return tl::unexpected(frame.error());
    const std::size_t work = *frames_.find("work");
    if (*frame == work) return machine_frames_.work_frames().object;
    return check_same_link(*frame, work).map([&]() -> rrs::CartPos {
        const rrs::CartPos origin = frames_.pose_in_link(work);
        if (frames_.link(work) != 0) return origin.inverse() * frames_.pose_in_link(*frame);
        return origin.inverse() * machine_frames_.base_shift().inverse() * frames_.pose_in_link(*frame);
    });
}

}  // namespace gsim::simulation
