#include "toolpath/model/validate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "base/text/utf8.h"
#include "toolpath/json/keys.h"
#include "toolpath/json/touches.h"
#include "toolpath/model/active_modes.h"
#include "toolpath/model/arc_shape.h"

namespace gsim::path {

namespace {

constexpr double kMaxMagnitude = 1e6;        // mm or deg; beyond any machine
constexpr double kMaxRate = 1e9;             // mm/min, s and the like
constexpr std::size_t kMaxNameLength = 256;  // bytes

// Checks a name, because names are written into comments of programs and names of files.
std::optional<Error> name_error(std::string_view what, std::string_view name) {
    if (name.size() > kMaxNameLength) return fmt::format("{} is longer than {} bytes", what, kMaxNameLength);
    const bool control = std::any_of(name.begin(), name.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 0x20 || byte == 0x7f;
    });
    if (control) return fmt::format("{} contains control characters", what);
    if (!text::is_utf8(name)) return fmt::format("{} is not in UTF-8", what);
    return std::nullopt;
}

std::optional<Error> vector_error(TargetKey key, const Vector& vector) {
    for (const double value : vector) {
        if (!(std::abs(value) <= kMaxMagnitude)) {
            return fmt::format("'{}' must be between -1e6 and 1e6; it is {}", key_name(key), value);
        }
    }
    return std::nullopt;
}

std::optional<Error> rate_error(TargetKey key, std::optional<double> value) {
    if (!value || (*value > 0 && *value <= kMaxRate)) return std::nullopt;
    return fmt::format("'{}' must be greater than 0 and at most 1e9; it is {}", key_name(key), *value);
}

std::optional<Error> orientation_error(const Orientation& orientation) {
    if (const auto* axis = std::get_if<ToolAxis>(&orientation)) {
        if (auto error = vector_error(TargetKey::tool_axis, axis->direction)) return error;
        if (!(to_eigen(axis->direction).norm() > 1e-9)) return "'tool_axis' must not be 0 0 0";
        return std::nullopt;
    }
    if (const auto* rpy = std::get_if<RollPitchYaw>(&orientation)) {
        return vector_error(TargetKey::rpy_deg, {rpy->roll_deg, rpy->pitch_deg, rpy->yaw_deg});
    }
    for (const auto& [letter, value_deg] : std::get<RotaryAxes>(orientation)) {
        if (letter < 'A' || letter > 'Z') return "'rotary_deg' must name axes by capital letters";
        if (auto error = vector_error(TargetKey::rotary_deg, {value_deg, 0, 0})) return error;
    }
    return std::nullopt;
}

std::optional<Error> arc_values_error(const Point& point) {
    if (point.motion != MotionType::circular) return std::nullopt;
    if (const auto* via = std::get_if<ViaPoint>(&point.arc)) {
        return vector_error(TargetKey::via_mm, via->via_mm);
    }
    const auto& arc = std::get<CenterArc>(point.arc);
    if (auto error = vector_error(TargetKey::center_mm, arc.center_mm)) return error;
    return vector_error(TargetKey::normal, arc.normal);
}

std::optional<Error> rates_error(const Point& point) {
    if (auto error = rate_error(TargetKey::feed_mm_min, point.feed_mm_min)) return error;
    if (auto error = rate_error(TargetKey::feed_deg_min, point.feed_deg_min)) return error;
    if (auto error = rate_error(TargetKey::duration_s, point.duration_s)) return error;
    if (auto error = rate_error(TargetKey::feed_mm_rev, point.feed_mm_rev)) return error;
    if (auto error = rate_error(TargetKey::lead_mm, point.lead_mm)) return error;
    if (point.feed_mm_rev && !point.feed_mm_min) return "'feed_mm_rev' requires 'feed_mm_min'";
    if (point.lead_mm && point.motion != MotionType::linear) return "'lead_mm' is only for linear motions";
    return rate_error(TargetKey::acceleration_mm_s2, point.acceleration_mm_s2);
}

// Checks the actions on arrival.
std::optional<Error> arrival_error(double dwell_s, const std::vector<std::string>& actions) {
    if (!(dwell_s >= 0 && dwell_s <= kMaxMagnitude))
        return fmt::format("'dwell_s' must be 0 or greater and at most 1e6; it is {}", dwell_s);
    for (const std::string& action : actions) {
        if (action.empty()) return "an action must have a name";
        if (auto error = name_error("the name of an action", action)) return error;
    }
    return std::nullopt;
}

std::optional<Error> point_error(const Point& point) {
    if (auto error = name_error("the name of the point", point.name)) return error;
    if (auto error = vector_error(TargetKey::position_mm, point.position_mm)) return error;
    if (auto error = arc_values_error(point)) return error;
    if (point.orientation) {
        if (auto error = orientation_error(*point.orientation)) return error;
    }
    if (auto error = rates_error(point)) return error;
    return arrival_error(point.dwell_s, point.actions);
}

// Returns true for a name as machine data have it.
bool is_valid_point_name(std::string_view name) {
    const auto is_letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
    return !name.empty() && is_letter(name[0]) && std::all_of(name.begin(), name.end(), [&](char c) {
        return is_letter(c) || (c >= '0' && c <= '9') || c == '_';
    });
}

std::optional<Error> machine_point_error(const MachinePoint& point) {
    if (auto error = name_error("the name of the point", point.name)) return error;
    const bool is_reference = point.kind == MachinePoint::Kind::reference;
    const int max = is_reference ? kReferencePointCount : kMaxFixedPoint;
    const std::string_view kind = is_reference ? "reference" : "fixed";
    if (point.number != 0) {
        if (point.number < 1 || point.number > max)
            return fmt::format("a {} point must have a number from 1 to {}", kind, max);
    } else if (point.alias.size() > kMaxNameLength || !is_valid_point_name(point.alias)) {
        return fmt::format(
            "'{0}' must be the number of a {0} point, or its name: a letter first, then letters, digits and "
            "_",
            kind);
    }
    return arrival_error(point.dwell_s, point.actions);
}

// Position from which the tool comes to a target.
struct Start {
    std::optional<Vector> at_mm = {};
    bool is_machine_point = false;
    bool is_touch = false;
};

class Validator {
  public:
    explicit Validator(const Program& program) : program_(program), nesting_depth_(program.paths.size()) {}

    std::optional<TargetError> run() {
        if (program_.paths.empty()) return TargetError{{}, "the program has no path"};
        if (program_.root >= program_.paths.size())
            return TargetError{{}, "the root is not one of the paths"};
        if (auto message = name_error("the name of the program", program_.name))
            return TargetError{{}, std::move(message->message)};
        check_names();
        check_work_offsets();
        check_frames();
        check_tools();
        for (std::size_t path = 0; path < program_.paths.size() && !error_; ++path) check_values(path);
        for (std::size_t path = 0; path < program_.paths.size() && !error_; ++path) check_nesting(path);
        for (std::size_t path = 0; path < program_.paths.size() && !error_; ++path) check_motions(path);
        if (!error_) check_motion({program_.root, 0}, {std::nullopt, false, !touches_.empty()});
        return error_;
    }

  private:
    void fail(std::size_t path, std::optional<std::size_t> target, Error error) {
        if (!error_) error_ = TargetError{{path, target}, std::move(error.message)};
    }

    void check_names() {
        std::set<std::string_view> names;
        for (std::size_t i = 0; i < program_.paths.size() && !error_; ++i) {
            const Path& path = program_.paths[i];
            if (path.name.empty()) fail(i, {}, "a path must have a name");
            if (auto error = name_error("the name of the path", path.name)) fail(i, {}, *std::move(error));
            if (!names.insert(path.name).second) {
                fail(i, {}, fmt::format("two paths have the name '{}'", path.name));
            }
            if (path.targets.empty()) fail(i, {}, fmt::format("the path '{}' has no targets", path.name));
        }
    }

    void check_work_offsets() {
        for (const auto& [name, offset] : program_.work_offsets) {
            const auto is_out_of_range = [](double value) { return !(std::abs(value) <= kMaxMagnitude); };
            if (name.empty()) fail(program_.root, {}, "a work offset must have a name");
            if (auto error = name_error("the name of a work offset", name))
                fail(program_.root, {}, *std::move(error));
            for (const auto& [letter, value] : offset.origin) {
                if (!is_out_of_range(value)) continue;
                fail(program_.root, {},
                     fmt::format("{} of the work offset '{}' must be between -1e6 and 1e6; it is {}", letter,
                                 name, value));
            }
            if (is_out_of_range(offset.rotation_deg))
                fail(program_.root, {}, fmt::format("'{}' must be between -1e6 and 1e6", kRotationKey));
        }
    }

    void check_frames() {
        for (std::size_t i = 0; i < program_.paths.size(); ++i) {
            check_frame({i, {}}, program_.paths[i].frame);
            const std::vector<Target>& targets = program_.paths[i].targets;
            for (std::size_t target = 0; target < targets.size(); ++target) {
                const auto* sub_path_call = std::get_if<SubPath>(&targets[target]);
                if (sub_path_call != nullptr) check_frame({i, target}, sub_path_call->frame);
            }
        }
    }

    // Checks that offsets set by a program are set once, at its beginning.
    void check_frame(const TargetId& id, const WorkFrame& frame) {
        if (frame.name.empty() && !frame.set_offset_mm && frame.touches.empty()) return;
        if (auto error = frame_error(frame)) return fail(id.path, id.target, *std::move(error));
        check_touches(id, frame);
        if (!frame.set_offset_mm) return;
        const auto [set, is_new] = offsets_by_frame_.emplace(frame.name, *frame.set_offset_mm);
        if (!is_new && set->second != *frame.set_offset_mm)
            fail(id.path, id.target, fmt::format("the work offset '{}' is set to two positions", frame.name));
    }

    // Checks the same for offsets that a program finds.
    void check_touches(const TargetId& id, const WorkFrame& frame) {
        if (frame.touches.empty()) return;
        for (const Touch& touch : frame.touches) {
            if (auto error = find_touch_error(touch)) fail(id.path, id.target, *std::move(error));
            if (touch.tool && !program_.paths[program_.root].tool)
                fail(id.path, id.target,
                     "a touch has a tool, so the first path of the program must have a tool, too");
        }
        const auto [found, is_new] = touches_.emplace(frame.name, &frame.touches);
        if (!is_new && *found->second != frame.touches)
            fail(id.path, id.target, fmt::format("the work offset '{}' is measured in two ways", frame.name));
    }

    std::optional<Error> frame_error(const WorkFrame& frame) const {
        if (program_.is_recorded())
            return "a path that was recorded from a run must have its work offsets at its points, not at "
                   "paths";
        if (frame.name.empty()) return "'set_offset_mm' and 'probe_offset' require 'work_offset'";
        if (auto error = name_error("the name of a work offset", frame.name)) return error;
        return frame.set_offset_mm ? vector_error(TargetKey::set_offset_mm, *frame.set_offset_mm)
                                   : std::nullopt;
    }

    void check_tools() {
        for (std::size_t i = 0; i < program_.paths.size() && !error_; ++i) {
            const std::optional<Tool>& tool = program_.paths[i].tool;
            if (!tool) continue;
            has_tools_ = true;
            if (program_.is_recorded())
                fail(i, {},
                     "a path that was recorded from a run must have its tools in the actions of its points");
            for (const int number : {tool->number, tool->length_offset, tool->diameter_offset.value_or(0)}) {
                if (number >= 0 && number <= kMaxToolNumber) continue;
                fail(i, {},
                     fmt::format("the numbers of a tool must be between 0 and {}; one is {}", kMaxToolNumber,
                                 number));
            }
        }
    }

    // Checks tool actions, because only the paths' tools define what is in the spindle.
    std::optional<Error> tool_action_error(const std::vector<std::string>& actions) const {
        if (!has_tools_) return std::nullopt;
        const auto change = std::find_if(actions.begin(), actions.end(), is_tool_change);
        if (change == actions.end()) return std::nullopt;
        return fmt::format(
            "the action '{}' cannot be combined with paths that have a 'tool'; define its tool in the same "
            "way",
            *change);
    }

    // Checks that a point's own offset is one of the program's.
    std::optional<Error> work_offset_error(const Point& point) const {
        if (!point.work_offset.empty() && !program_.is_recorded())
            return "'work_offset' of a point is only for paths that were recorded from a run; otherwise set "
                   "it at a path or at the use of a sub-path";
        if (point.work_offset.empty() || program_.work_offsets.contains(point.work_offset))
            return std::nullopt;
        return fmt::format("'work_offset' is '{}', which is not one of the program's 'work_offsets'",
                           point.work_offset);
    }

    void check_values(std::size_t path) {
        const std::vector<Target>& targets = program_.paths[path].targets;
        for (std::size_t i = 0; i < targets.size() && !error_; ++i) {
            if (const auto* point = std::get_if<Point>(&targets[i])) {
                if (auto error = point_error(*point)) fail(path, i, *std::move(error));
                if (auto error = work_offset_error(*point)) fail(path, i, *std::move(error));
                if (auto error = tool_action_error(point->actions)) fail(path, i, *std::move(error));
                continue;
            }
            if (const auto* point = std::get_if<MachinePoint>(&targets[i])) {
                if (auto error = machine_point_error(*point)) fail(path, i, *std::move(error));
                if (auto error = tool_action_error(point->actions)) fail(path, i, *std::move(error));
                if (program_.is_recorded())
                    fail(path, i, "a path that was recorded from a run has no fixed or reference points");
                continue;
            }
            const auto& sub_path = std::get<SubPath>(targets[i]);
            if (sub_path.path >= program_.paths.size()) fail(path, i, "the sub-path does not exist");
            if (sub_path.repeats < 1) fail(path, i, "'repeats' must be 1 or greater");
        }
    }

    // Returns the number of levels below a path. The descent is never longer than kMaxDepth, however long a
    // chain or a circle of paths is.
    int check_nesting(std::size_t path) {
        if (nesting_depth_[path]) return *nesting_depth_[path];
        if (std::find(search_path_.begin(), search_path_.end(), path) != search_path_.end()) {
            return reject(fmt::format("the path '{}' contains itself", program_.paths[path].name));
        }
        if (search_path_.size() > static_cast<std::size_t>(kMaxDepth)) return nesting_error();
        search_path_.push_back(path);
        int height = 0;
        const std::vector<Target>& targets = program_.paths[path].targets;
        for (std::size_t i = 0; i < targets.size() && !error_; ++i) {
            const auto* sub_path = std::get_if<SubPath>(&targets[i]);
            if (sub_path == nullptr) continue;
            user_target_ = {path, i};
            height = std::max(height, 1 + check_nesting(sub_path->path));
            if (height > kMaxDepth) {
                user_target_ = {path, i};
                nesting_error();
            }
        }
        search_path_.pop_back();
        nesting_depth_[path] = height;
        return height;
    }

    int reject(std::string message) {
        fail(user_target_.path, user_target_.target, std::move(message));
        return 0;
    }
    int nesting_error() {
        return reject(fmt::format("sub-paths are nested deeper than {} levels", kMaxDepth));
    }

    Start target_end(const Target& target) const {
        if (const auto* point = std::get_if<Point>(&target)) return {point->position_mm};
        if (std::holds_alternative<MachinePoint>(target)) return {std::nullopt, true};
        return target_end(program_.paths[std::get<SubPath>(target).path].targets.back());
    }

    // Checks all motions except one that the path begins with.
    void check_motions(std::size_t path) {
        Start start;
        const std::vector<Target>& targets = program_.paths[path].targets;
        for (std::size_t i = 0; i < targets.size() && !error_; ++i) {
            if (i > 0) check_motion({path, i}, start);
            start = target_end(targets[i]);
            const auto* sub_path = std::get_if<SubPath>(&targets[i]);
            if (sub_path != nullptr && sub_path->repeats > 1) check_motion({path, i}, start);
        }
    }

    // Checks the motion that a target begins with, for one of the positions that lead to it.
    void check_motion(const TargetId& id, const Start& start) {
        const Target& target = program_.paths[id.path].targets[*id.target];
        if (const auto* sub_path_call = std::get_if<SubPath>(&target))
            return check_motion({sub_path_call->path, 0}, start);
        const auto* point = std::get_if<Point>(&target);
        if (point == nullptr) return;
        if (start.is_machine_point && point->motion != MotionType::rapid) {
            return fail(id.path, id.target,
                        "the first motion after a fixed or reference point must be a rapid, because the "
                        "position of that point in the work is unknown");
        }
        if (start.is_touch && point->motion != MotionType::rapid)
            return fail(id.path, id.target,
                        "the first motion after the touches of 'probe_offset' must be a rapid");
        if (point->motion != MotionType::circular) return;
        if (!start.at_mm) {
            return fail(id.path, id.target,
                        "the first motion of a program cannot be circular: its start is unknown");
        }
        if (const auto arc = arc_shape(*start.at_mm, *point); !arc)
            fail(id.path, id.target, arc.error().message);
    }

    const Program& program_;
    std::optional<TargetError> error_;
    std::map<std::string_view, Vector> offsets_by_frame_;  // work offsets
    std::map<std::string_view, const std::vector<Touch>*> touches_;
    bool has_tools_ = false;
    std::vector<std::optional<int>> nesting_depth_;  // of each path
    std::vector<std::size_t> search_path_;           // from the path where the search began
    TargetId user_target_;                           // what leads to the path being looked at
};

}  // namespace

std::optional<TargetError> validate(const Program& program) {
    return Validator(program).run();
}

}  // namespace gsim::path
