#include "batch/work/path_job.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/text/format.h"
#include "base/text/letter_case.h"
#include "batch/work/edits.h"
#include "engine/machine.h"

namespace gsim::batch {

namespace {

using engine::FramePose;
using nlohmann::json;

constexpr std::string_view kPosePrefix = "place.", kPathOrderKey = "order", kFeedKey = "feed_mm_min";
constexpr std::array<std::string_view, 6> kPoseFields{"x_mm",     "y_mm",      "z_mm",
                                                      "roll_deg", "pitch_deg", "yaw_deg"};
constexpr const char* kDefaultPost = "ab9";  // as gsim write has it

tl::unexpected<engine::Error> setting_error(std::string message) {
    return tl::unexpected(engine::Error{.code = "setting", .message = std::move(message)});
}

double& pose_field(FramePose& pose, std::size_t index) {
    return index < 3 ? pose.origin_mm[index] : pose.rpy_deg[index - 3];
}

/// Returns the name of the path that a feed key refers to; empty result: the key is another one.
std::optional<std::string> feed_path_name(const std::string& key) {
    if (key == kFeedKey) return std::string();
    const std::string end = '.' + std::string(kFeedKey);
    if (!key.ends_with(end) || key.size() == end.size()) return std::nullopt;
    return key.substr(0, key.size() - end.size());
}

Result<std::vector<std::size_t>> parse_order(const json& value) {
    std::vector<std::size_t> order;
    for (const json& each : value.is_array() ? value : json::array({value})) {
        if (!each.is_number_unsigned())
            return Unexpected(
                fmt::format("'path.order' must be a list of indices from 0 on, not {}", value.dump()));
        order.push_back(each);
    }
    return order;
}

/// Returns the post for programs that the machine reads.
tl::expected<std::string, engine::Error> select_post(const JobRequest& request,
                                                     const engine::Machine& machine) {
    if (!request.path.post.empty()) return request.path.post;
    const std::string& requested_dialect = request.run.language.dialect;
    const std::string& dialect = requested_dialect.empty() ? machine.dialect() : requested_dialect;
    if (dialect.empty()) return kDefaultPost;
    const std::vector<std::string> posts = engine::post_names();
    if (std::find(posts.begin(), posts.end(), dialect) != posts.end()) return dialect;
    return setting_error(fmt::format("the dialect '{}' has no post; the option 'post' must be {}, or a file",
                                     dialect, text::joined(posts, ", ")));
}

/// Returns the pose of the frame that moves the path.
tl::expected<FramePose, engine::Error> frame_pose(engine::Machine& machine, const std::string& name) {
    return machine.read_bodies().and_then([&] { return machine.frame_in_work(name); });
}

tl::expected<void, engine::Error> set_frame_changes(const Job& job, const JobRequest& request,
                                                    engine::Machine& machine,
                                                    const engine::Host& original_host,
                                                    engine::PathChanges& changes) {
    if (request.path_frame.empty()) return {};
    if (request.run.cell.empty()) return setting_error("the option 'path_frame' requires a cell");
    const auto store_pose = [](FramePose& pose) { return [&pose](const FramePose& found) { pose = found; }; };
    engine::Request before = request.run;
    before.host = original_host;
    before.machine = job.machine;  // edits may have named what no file is
    return engine::Machine::read(before)
        .and_then([&](engine::Machine found) { return frame_pose(found, request.path_frame); })
        .map(store_pose(changes.from))
        .and_then([&] { return frame_pose(machine, request.path_frame); })
        .map(store_pose(changes.to));
}

tl::expected<std::string, engine::Error> write_program(engine::PathRequest request) {
    return engine::PathTranslation::open(std::move(request))
        .and_then([](engine::PathTranslation path) -> tl::expected<std::string, engine::Error> {
            std::string text;
            const auto sink = [&](const std::string&) {
                return [&text](std::string_view part) {
                    text += part;
                    return true;
                };
            };
            return path.read()
                .and_then([&] { return path.plan(); })
                .and_then([&] { return path.write(sink); })
                .map([&] { return std::move(text); });
        });
}

}  // namespace

bool is_path_file(const std::string& name) {
    const std::string plain = text::lower(name);
    return plain.ends_with(".path.json") || plain.ends_with(".path.lua");
}

std::optional<Error> find_path_key_error(const std::string& key) {
    if (key == kPathOrderKey || feed_path_name(key)) return {};
    if (key.starts_with(kPosePrefix) && std::find(kPoseFields.begin(), kPoseFields.end(),
                                                  key.substr(kPosePrefix.size())) != kPoseFields.end())
        return {};
    return fmt::format(
        "a path has 'path.place.{}', 'path.order', 'path.feed_mm_min' and 'path.NAME.feed_mm_min', not "
        "'path.{}'",
        text::joined(kPoseFields, "', 'path.place."), key);
}

Result<engine::PathChanges> path_changes(std::span<const SettingValue> settings) {
    engine::PathChanges changes;
    for (const SettingValue& setting : settings) {
        if (setting.key == kPathOrderKey) {
            auto order = parse_order(setting.value);
            if (!order) return tl::unexpected(order.error());
            changes.order = *std::move(order);
            continue;
        }
        const auto* number = setting.value.is_number() ? &setting.value : nullptr;
        if (number == nullptr)
            return Unexpected(
                fmt::format("'path.{}' must be a number, not {}", setting.key, setting.value.dump()));
        const auto value = number->get<double>();
        if (auto path = feed_path_name(setting.key)) {
            if (value <= 0) return Unexpected(fmt::format("'path.{}' must be greater than 0", setting.key));
            changes.feeds.push_back({*std::move(path), value, setting.use == SettingUse::factor});
            continue;
        }
        const auto* const field =
            std::find(kPoseFields.begin(), kPoseFields.end(),
                      setting.key.substr(std::min(kPosePrefix.size(), setting.key.size())));
        if (field == kPoseFields.end()) return tl::unexpected(find_path_key_error(setting.key).value());
        pose_field(changes.place, static_cast<std::size_t>(field - kPoseFields.begin())) = value;
    }
    return changes;
}

tl::expected<std::optional<std::string>, engine::Error> write_path(const Job& job, const JobRequest& request,
                                                                   const engine::Host& original_host) {
    const std::vector<SettingValue> settings = settings_with_prefix(job.settings, kPathPrefix);
    if (!is_path_file(job.program)) {
        if (!request.path_frame.empty())
            return setting_error(
                fmt::format("the option 'path_frame' applies to paths (.path.json, .path.lua), and '{}' "
                            "would not move with '{}'",
                            job.program, request.path_frame));
        if (settings.empty()) return std::nullopt;
        return setting_error(
            fmt::format("'path.{}' applies to paths (.path.json, .path.lua), and '{}' is not a path",
                        settings.front().key, job.program));
    }
    auto changes = path_changes(settings);
    if (!changes) return setting_error(changes.error().message);
    auto machine = engine::Machine::read(request.run);
    if (!machine) return tl::unexpected(machine.error());
    auto post = select_post(request, *machine);
    if (!post) return tl::unexpected(post.error());
    if (auto done = set_frame_changes(job, request, *machine, original_host, *changes); !done)
        return tl::unexpected(done.error());
    engine::PathRequest path = request.path;
    path.path = job.program;
    path.post = *std::move(post);
    path.machine = machine->machine_file();
    path.machine_data = machine->machine_data_file();
    path.changes = *std::move(changes);
    path.host = request.run.host;
    return write_program(std::move(path)).map([](std::string text) {
        return std::optional(std::move(text));
    });
}

}  // namespace gsim::batch
