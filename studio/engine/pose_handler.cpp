// Computes the pose of a machine, by its axes or by its TCP, and its contacts there.

#include <utility>

#include "engine/machine.h"
#include "engine/pose.h"
#include "studio/engine/key_reader.h"
#include "studio/engine/message.h"
#include "studio/engine/request_handlers.h"

namespace gsim::studio {

using nlohmann::json;

namespace {

constexpr double kMaxCoordinate = 1e9;  // mm and deg

void read_values(KeyReader& keys, const char* key, std::optional<std::vector<double>>& target) {
    std::vector<double> values;
    if (keys.any(key) == nullptr) return;
    keys.numbers(key, -kMaxCoordinate, kMaxCoordinate, values);
    target = std::move(values);
}

tl::expected<engine::PoseRequest, engine::Error> pose_options(const json& parameters) {
    engine::PoseRequest pose_request;
    KeyReader keys(parameters, "a pose");
    read_values(keys, "joints", pose_request.joints);
    read_values(keys, "near", pose_request.near);
    keys.point("tip_mm", -kMaxCoordinate, kMaxCoordinate, pose_request.tcp_mm);
    keys.point("tool_axis", -kMaxCoordinate, kMaxCoordinate, pose_request.tool_axis);
    keys.point("rpy_deg", -kMaxCoordinate, kMaxCoordinate, pose_request.rpy_deg);
    keys.number("tool_mm", -kMaxCoordinate, kMaxCoordinate, pose_request.tool_mm);
    return finish_keys(keys).map([&] { return std::move(pose_request); });
}

}  // namespace

VoidResult handle_pose(const json& parameters, const engine::Request& request, const Post& post) {
    const auto pose_request = pose_options(parameters);
    if (!pose_request) return tl::unexpected(pose_request.error());
    auto machine = engine::Machine::read(request);
    if (!machine) return tl::unexpected(machine.error());
    if (auto read = machine->read_bodies(); !read) return read;
    const auto pose = engine::solve_pose(*machine, *pose_request);
    if (!pose) return tl::unexpected(pose.error());
    Message message("pose");
    message.header().update({{"joints", pose->joints},
                             {"tip_mm", pose->tcp_mm},
                             {"tool_axis", pose->tool_axis},
                             {"rpy_deg", pose->rpy_deg},
                             {"solutions", pose->solutions},
                             {"beyond", pose->out_of_range},
                             {"collisions", pose->collisions}});
    post(message.bytes());
    return {};
}

}  // namespace gsim::studio
