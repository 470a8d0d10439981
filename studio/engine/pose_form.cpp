// Computes the pose of a machine, by its axes or by its TCP, and its contacts there.

#include <utility>

#include "engine/machine.h"
#include "engine/pose.h"
#include "studio/engine/answer.h"
#include "studio/engine/keys.h"
#include "studio/engine/message.h"

namespace gsim::studio {

using nlohmann::json;

namespace {

constexpr double kFarthest = 1e9;  // mm and deg

void take_values(Keys& keys, const char* key, std::optional<std::vector<double>>& place) {
    std::vector<double> values;
    if (keys.any(key) == nullptr) return;
    keys.numbers(key, -kFarthest, kFarthest, values);
    place = std::move(values);
}

tl::expected<engine::PoseChoice, engine::Failure> pose_choice(const json& own) {
    engine::PoseChoice choice;
    Keys keys(own, "a pose");
    take_values(keys, "joints", choice.joints);
    take_values(keys, "near", choice.near);
    keys.point("tip_mm", -kFarthest, kFarthest, choice.tip_mm);
    keys.point("tool_axis", -kFarthest, kFarthest, choice.tool_axis);
    keys.point("rpy_deg", -kFarthest, kFarthest, choice.rpy_deg);
    keys.number("tool_mm", -kFarthest, kFarthest, choice.tool_mm);
    return end_of(keys).map([&] { return std::move(choice); });
}

}  // namespace

Done answer_pose(const json& own, const engine::Request& request, const Post& post) {
    const auto choice = pose_choice(own);
    if (!choice) return tl::unexpected(choice.error());
    auto machine = engine::Machine::read(request);
    if (!machine) return tl::unexpected(machine.error());
    if (auto read = machine->read_bodies(); !read) return read;
    const auto pose = engine::pose_of(*machine, *choice);
    if (!pose) return tl::unexpected(pose.error());
    Message message("pose");
    message.header().update({{"joints", pose->joints},
                             {"tip_mm", pose->tip_mm},
                             {"tool_axis", pose->tool_axis},
                             {"rpy_deg", pose->rpy_deg},
                             {"solutions", pose->solutions},
                             {"beyond", pose->beyond},
                             {"collisions", pose->collisions}});
    post(message.bytes());
    return {};
}

}  // namespace gsim::studio
