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

using OptionalMessage = std::optional<std::string>;

// Checks a name, because names are written into comments of programs and names of files.
OptionalMessage name_error(std::string_view what, std::string_view name) {
    if (name.size() > kMaxNameLength) return fmt::format("{} is longer than {} bytes", what, kMaxNameLength);
    const bool control = std::any_of(name.begin(), name.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 0x20 || byte == 0x7f;
    });
    if (control) return fmt::format("{} holds control characters", what);
    if (!text::is_utf8(name)) return fmt::format("{} is not in UTF-8", what);
    return std::nullopt;
}

OptionalMessage vector_error(TargetKey key, const Vector& vector) {
    for (const double value : vector) {
        if (!(std::abs(value) <= kMaxMagnitude)) {
            return fmt::format("'{}' must lie between -1e6 and 1e6; it is {}", key_name(key), value);
        }
    }
    return std::nullopt;
}

OptionalMessage rate_error(TargetKey key, std::optional<double> value) {
    if (!value || (*value > 0 && *value <= kMaxRate)) return std::nullopt;
    return fmt::format("'{}' must be greater than 0 and at most 1e9; it is {}", key_name(key), *value);
}

OptionalMessage orientation_error(const Orientation& orientation) {
    if (const auto* axis = std::get_if<ToolAxis>(&orientation)) {
        if (auto error = vector_error(TargetKey::tool_axis, axis->direction)) return error;
        if (!(to_eigen(axis->direction).norm() > 1e-9)) return "'tool_axis' must not be 0 0 0";
        return std::nullopt;
    }
    if (const auto* rpy = std::get_if<RollPitchYaw>(&orientation)) {
        return vector_error(TargetKey::rpy_deg, {rpy->roll_deg, rpy->pitch_deg, rpy->yaw_deg});
    }
    for (const auto& [letter, value_deg] : std::get<RotaryAxes>(orientation)) {
        if (letter < 'A' || letter > 'Z') return "'rotary_deg' names axes by capital letters";
        if (auto error = vector_error(TargetKey::rotary_deg, {value_deg, 0, 0})) return error;
    }
    return std::nullopt;
}

OptionalMessage arc_values_error(const Point& point) {
    if (point.motion != MotionType::circular) return std::nullopt;
    if (const auto* via = std::get_if<ViaPoint>(&point.arc)) {
        return vector_error(TargetKey::via_mm, via->via_mm);
    }
    const auto& arc = std::get<CenterArc>(point.arc);
    if (auto error = vector_error(TargetKey::center_mm, arc.center_mm)) return error;
    return vector_error(TargetKey::normal, arc.normal);
}

OptionalMessage rates_error(const Point& point) {
    if (auto error = rate_error(TargetKey::feed_mm_min, point.feed_mm_min)) return error;
    if (auto error = rate_error(TargetKey::feed_deg_min, point.feed_deg_min)) return error;
    if (auto error = rate_error(TargetKey::duration_s, point.duration_s)) return error;
    if (auto error = rate_error(TargetKey::feed_mm_rev, point.feed_mm_rev)) return error;
    if (auto error = rate_error(TargetKey::lead_mm, point.lead_mm)) return error;
    if (point.feed_mm_rev && !point.feed_mm_min) return "'feed_mm_rev' goes with 'feed_mm_min'";
    if (point.lead_mm && point.motion != MotionType::linear) return "'lead_mm' is of linear motions only";
    return rate_error(TargetKey::acceleration_mm_s2, point.acceleration_mm_s2);
}

// Checks the actions on arrival.
OptionalMessage arrival_error(double dwell_s, const std::vector<std::string>& actions) {
    if (!(dwell_s >= 0 && dwell_s <= kMaxMagnitude))
        return fmt::format("'dwell_s' must be 0 or greater and at most 1e6; it is {}", dwell_s);
    for (const std::string& action : actions) {
        if (action.empty()) return "an action must have a name";
        if (auto error = name_error("an action's name", action)) return error;
    }
    return std::nullopt;
}

OptionalMessage point_error(const Point& point) {
    if (auto error = name_error("the point's name", point.name)) return error;
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

OptionalMessage machine_point_error(const MachinePoint& point) {
    if (auto error = name_error("the point's name", point.name)) return error;
    const bool is_reference = point.kind == MachinePoint::Kind::reference;
    const int max = is_reference ? kReferencePointCount : kMaxFixedPoint;
    const std::string_view kind = is_reference ? "reference" : "fixed";
    if (point.number != 0) {
        if (point.number < 1 || point.number > max)
            return fmt::format("a {} point has a number from 1 to {}", kind, max);
    } else if (point.alias.size() > kMaxNameLength || !is_valid_point_name(point.alias)) {
        return fmt::format(
            "'{0}' takes the number of a {0} point, or its name: a letter first, then letters, digits and _",
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

    std::optional<Error> run() {
        if (program_.paths.empty()) return Error{{}, "there is no path"};
        if (program_.root >= program_.paths.size()) return Error{{}, "the root is none of the paths"};
        if (auto message = name_error("the program's name", program_.name)) return Error{{}, *message};
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
    void fail(std::size_t path, std::optional<std::size_t> target, std::string message) {
        if (!error_) error_ = Error{{path, target}, std::move(message)};
    }

    void check_names() {
        std::set<std::string_view> names;
        for (std::size_t i = 0; i < program_.paths.size() && !error_; ++i) {
            const Path& path = program_.paths[i];
            if (path.name.empty()) fail(i, {}, "a path must have a name");
            if (auto message = name_error("the path's name", path.name)) fail(i, {}, *message);
            if (!names.insert(path.name).second) {
                fail(i, {}, fmt::format("there are two paths of the name '{}'", path.name));
            }
            if (path.targets.empty()) fail(i, {}, fmt::format("the path '{}' has no targets", path.name));
        }
    }

    void check_work_offsets() {
        for (const auto& [name, offset] : program_.work_offsets) {
            const auto is_out_of_range = [](double value) { return !(std::abs(value) <= kMaxMagnitude); };
            if (name.empty()) fail(program_.root, {}, "a work offset must have a name");
            if (auto message = name_error("a work offset's name", name)) fail(program_.root, {}, *message);
            for (const auto& [letter, value] : offset.origin) {
                if (!is_out_of_range(value)) continue;
                fail(program_.root, {},
                     fmt::format("{} of the work offset '{}' must lie between -1e6 and 1e6; it is {}", letter,
                                 name, value));
            }
            if (is_out_of_range(offset.rotation_deg))
                fail(program_.root, {}, fmt::format("'{}' must lie between -1e6 and 1e6", kRotationKey));
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
        if (auto message = frame_error(frame)) return fail(id.path, id.target, *message);
        check_touches(id, frame);
        if (!frame.set_offset_mm) return;
        const auto [set, is_new] = set_.emplace(frame.name, *frame.set_offset_mm);
        if (!is_new && set->second != *frame.set_offset_mm)
            fail(id.path, id.target, fmt::format("the work offset '{}' is set to two places", frame.name));
    }

    // Checks the same for offsets that a program finds.
    void check_touches(const TargetId& id, const WorkFrame& frame) {
        if (frame.touches.empty()) return;
        for (const Touch& touch : frame.touches) {
            if (auto message = touch_error(touch)) fail(id.path, id.target, *message);
            if (touch.tool && !program_.paths[program_.root].tool)
                fail(id.path, id.target,
                     "a touch names its tool, so that the path that the program begins with must name its "
                     "own");
        }
        const auto [found, is_new] = touches_.emplace(frame.name, &frame.touches);
        if (!is_new && *found->second != frame.touches)
            fail(id.path, id.target, fmt::format("the work offset '{}' is found in two ways", frame.name));
    }

    OptionalMessage frame_error(const WorkFrame& frame) const {
        if (program_.is_recorded())
            return "a path that was recorded from a run has its work offsets at its points, not at paths";
        if (frame.name.empty()) return "'set_offset_mm' and 'probe_offset' go with 'work_offset'";
        if (auto error = name_error("a work offset's name", frame.name)) return error;
        return frame.set_offset_mm ? vector_error(TargetKey::set_offset_mm, *frame.set_offset_mm)
                                   : std::nullopt;
    }

    void check_tools() {
        for (std::size_t i = 0; i < program_.paths.size() && !error_; ++i) {
            const std::optional<Tool>& tool = program_.paths[i].tool;
            if (!tool) continue;
            has_tools_ = true;
            if (program_.is_recorded())
                fail(i, {}, "a path that was recorded from a run has its tools in the actions of its points");
            for (const int number : {tool->number, tool->length_offset, tool->diameter_offset.value_or(0)}) {
                if (number >= 0 && number <= kMaxToolNumber) continue;
                fail(i, {},
                     fmt::format("the numbers of a tool lie between 0 and {}; one is {}", kMaxToolNumber,
                                 number));
            }
        }
    }

    // Checks tool actions, because only the paths' tools define what is in the spindle.
    OptionalMessage tool_action_error(const std::vector<std::string>& actions) const {
        if (!has_tools_) return std::nullopt;
        const auto change = std::find_if(actions.begin(), actions.end(), is_tool_change);
        if (change == actions.end()) return std::nullopt;
        return fmt::format(
            "the action '{}' stands beside paths that name their 'tool'; name that one so, too", *change);
    }

    // Checks that a point's own offset is one of the program's.
    OptionalMessage work_offset_error(const Point& point) const {
        if (!point.work_offset.empty() && !program_.is_recorded())
            return "'work_offset' of a point is for paths that were recorded from a run; otherwise a path "
                   "has it, "
                   "or the use of a sub-path";
        if (point.work_offset.empty() || program_.work_offsets.contains(point.work_offset))
            return std::nullopt;
        return fmt::format("'work_offset' names '{}', which is none of the program's 'work_offsets'",
                           point.work_offset);
    }

    void check_values(std::size_t path) {
        const std::vector<Target>& targets = program_.paths[path].targets;
        for (std::size_t i = 0; i < targets.size() && !error_; ++i) {
            if (const auto* point = std::get_if<Point>(&targets[i])) {
                if (auto message = point_error(*point)) fail(path, i, *message);
                if (auto message = work_offset_error(*point)) fail(path, i, *message);
                if (auto message = tool_action_error(point->actions)) fail(path, i, *message);
                continue;
            }
            if (const auto* point = std::get_if<MachinePoint>(&targets[i])) {
                if (auto message = machine_point_error(*point)) fail(path, i, *message);
                if (auto message = tool_action_error(point->actions)) fail(path, i, *message);
                if (program_.is_recorded())
                    fail(path, i, "a path that was recorded from a run has no fixed or reference points");
                continue;
            }
            const auto& sub_path = std::get<SubPath>(targets[i]);
            if (sub_path.path >= program_.paths.size()) fail(path, i, "there is no such sub-path");
            if (sub_path.repeats < 1) fail(path, i, "'repeats' must be 1 or greater");
        }
    }

    // Returns the number of levels below a path. The descent is never longer than kMaxDepth, however long a
    // chain or a circle of paths is.
    int check_nesting(std::size_t path) {
        if (nesting_depth_[path]) return *nesting_depth_[path];
        if (std::find(search_path_.begin(), search_path_.end(), path) != search_path_.end()) {
            return reject(fmt::format("the path '{}' leads back to itself", program_.paths[path].name));
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
        return reject(fmt::format("sub-paths are nested deeper than {} levels here", kMaxDepth));
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
                        "the first motion behind a fixed or reference point must be a rapid: where that "
                        "point is in the work nobody knows");
        }
        if (start.is_touch && point->motion != MotionType::rapid)
            return fail(id.path, id.target,
                        "the first motion behind the touches of 'probe_offset' must be a rapid");
        if (point->motion != MotionType::circular) return;
        if (!start.at_mm) {
            return fail(id.path, id.target,
                        "the first motion of a program cannot be circular: nothing says where it starts");
        }
        if (const auto arc = arc_shape(*start.at_mm, *point); !arc) fail(id.path, id.target, arc.error());
    }

    const Program& program_;
    std::optional<Error> error_;
    std::map<std::string_view, Vector> set_;  // work offsets
    std::map<std::string_view, const std::vector<Touch>*> touches_;
    bool has_tools_ = false;
    std::vector<std::optional<int>> nesting_depth_;  // of each path
    std::vector<std::size_t> search_path_;           // from the path at which the search began
    TargetId user_target_;                           // what leads to the path being looked at
};

}  // namespace

std::optional<Error> validate(const Program& program) {
    return Validator(program).run();
}

}  // namespace gsim::path
