#include "engine/src/paths/path_frames.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text/format.h"
#include "toolpath/model/validate.h"

namespace gsim::engine {

namespace {

using path::SubPath;
using path::Target;
using path::TargetId;
using path::WorkFrame;

template <typename Visitor>
void for_each_frame(const path::Program& program, const Visitor& visit) {
    for (std::size_t i = 0; i < program.paths.size(); ++i) {
        visit(TargetId{i, {}}, program.paths[i].frame);
        const std::vector<Target>& targets = program.paths[i].targets;
        for (std::size_t target = 0; target < targets.size(); ++target) {
            const auto* sub_path_call = std::get_if<SubPath>(&targets[target]);
            if (sub_path_call != nullptr) visit(TargetId{i, target}, sub_path_call->frame);
        }
    }
}

std::optional<gsim::Error> find_frame_error(const WorkFrame& frame, const codegen::Post& post) {
    const std::vector<std::string>& systems = post.offsets.systems;
    if (frame.name.empty()) return std::nullopt;
    if (systems.empty())
        return fmt::format("the post '{}' has no work offsets ([offsets] systems)", post.name);
    if (std::find(systems.begin(), systems.end(), frame.name) == systems.end())
        return fmt::format("the post '{}' has no work offset G{}; it has G{}", post.name, frame.name,
                           text::joined(systems, ", G"));
    if (!frame.touches.empty() && post.touch.empty())
        return fmt::format("the post '{}' has no words to measure a work offset by touches ([probe] touch)",
                           post.name);
    if (frame.set_offset_mm && post.offsets.set.empty())
        return fmt::format("the post '{}' has no word to set a work offset ([offsets] set)", post.name);
    return std::nullopt;
}

// Sets the values of the request in a root that has none.
std::optional<gsim::Error> apply_defaults(path::Program& program, const PathRequest& request,
                                          const codegen::Post& post) {
    const bool is_requested = !request.work_offset.empty() || request.set_offset_mm || request.tool;
    if (!is_requested) return std::nullopt;
    if (program.is_recorded())
        return "work offsets and tools apply to paths that are not recorded; a recorded path has them at its "
               "points";
    path::Path& root = program.paths[program.root];
    const std::string requested_frame = path::frame_name(request.work_offset);
    if (root.frame.name.empty()) root.frame.name = requested_frame;
    if (request.set_offset_mm) {
        if (!requested_frame.empty() && root.frame.name != requested_frame) {
            return fmt::format("the path names G{}, so G{} cannot be set for it", root.frame.name,
                               requested_frame);
        }
        if (root.frame.name.empty() && !post.offsets.systems.empty())
            root.frame.name = post.offsets.systems.front();
        if (!root.frame.set_offset_mm) root.frame.set_offset_mm = request.set_offset_mm;
    }
    if (!root.tool && request.tool) root.tool = path::Tool{*request.tool, *request.tool, std::nullopt};
    return find_frame_error(root.frame, post);
}

}  // namespace

PathFrames::PathFrames(const path::Program& program) {
    for_each_frame(program, [this](const TargetId& where, const WorkFrame& frame) { add(where, frame); });
    has_tools_ = std::any_of(program.paths.begin(), program.paths.end(),
                             [](const path::Path& path) { return path.tool.has_value(); });
}

void PathFrames::add(const TargetId& where, const WorkFrame& frame) {
    if (frame.name.empty()) return;
    std::optional<path::Vector>& position_mm = origins_mm_[frame.name];
    if (frame.set_offset_mm) position_mm = frame.set_offset_mm;
    const bool is_found = std::any_of(found_.begin(), found_.end(),
                                      [&](const ProbedFrame& each) { return each.name == frame.name; });
    if (!frame.touches.empty() && !is_found) found_.push_back({frame.name, &frame.touches, where});
}

std::optional<path::TargetError> PathFrames::check_touches(const path::MachineSpace& space) const {
    for (const ProbedFrame& frame : found_) {
        const auto& position_mm = origins_mm_.find(frame.name)->second;
        if (!position_mm) continue;
        for (const path::Touch& touch : *frame.touches) {
            std::map<char, double> at;
            for (std::size_t i = 0; i < 3; ++i)
                at[static_cast<char>('X' + i)] = touch.from_mm[i] + (*position_mm)[i];
            auto error = space.find_axis_range_error(at);
            at[touch.axis] += touch.to_mm - touch.from_mm[static_cast<std::size_t>(touch.axis - 'X')];
            if (!error) error = space.find_axis_range_error(at);
            if (error) return path::TargetError{frame.where, std::move(error->message)};
        }
    }
    return std::nullopt;
}

// The tool is retracted before each touch, and once more at the end.
void PathFrames::emit_touches(path::MoveSink& sink) const {
    std::optional<int> tool;
    for (const ProbedFrame& frame : found_) {
        for (const path::Touch& touch : *frame.touches) {
            sink.retract();
            if (touch.tool && touch.tool != tool) {
                sink.action(fmt::format("tool_select T{}", *touch.tool));
                sink.action(fmt::format("tool_change T{}", *touch.tool));
                sink.action(fmt::format("tool_length H{}", *touch.tool));
                tool = touch.tool;
            }
            sink.work_offset(frame.name);
            sink.touch(frame.name, touch);
        }
    }
    if (!found_.empty()) sink.retract();
}

std::vector<std::string> PathFrames::notes() const {
    std::vector<std::string> names;
    for (const auto& [name, position_mm] : origins_mm_) {
        if (!position_mm) names.push_back("G" + name);
    }
    if (names.empty()) return {};
    return {fmt::format(
        "the path does not define the position of {}, so the ranges of X, Y and Z are not checked",
        text::joined(names, ", "))};
}

Result<void> complete_frames(path::PathFile& file, const PathRequest& request, const codegen::Post& post) {
    path::Program& program = file.program;
    if (auto error = apply_defaults(program, request, post)) return tl::unexpected(*error);
    std::optional<std::string> error;
    bool any = false;
    for_each_frame(program, [&](const TargetId& where, const WorkFrame& frame) {
        any = any || !frame.name.empty();
        const auto found = find_frame_error(frame, post);
        if (found && !error) error = file.with_location(where, found->message);
    });
    if (error) return tl::unexpected(*error);
    std::string& root_frame_name = program.paths[program.root].frame.name;
    if (any && root_frame_name.empty()) root_frame_name = post.offsets.systems.front();
    // The request may have added values that do not fit the path.
    if (const auto validation_error = path::validate(program))
        return tl::unexpected(file.with_location(validation_error->where, validation_error->message));
    return {};
}

}  // namespace gsim::engine
