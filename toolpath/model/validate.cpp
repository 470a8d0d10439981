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
#include "toolpath/model/arc_shape.h"
#include "toolpath/model/running.h"

namespace gsim::path {

namespace {

constexpr double kGreatest = 1e6;          // mm or deg; beyond any machine
constexpr double kGreatestRate = 1e9;      // mm/min, s and the like
constexpr std::size_t kLongestName = 256;  // bytes

using Sentence = std::optional<std::string>;

// Checks a name, because names are written into comments of programs and names of files.
Sentence name_fault(std::string_view what, std::string_view name) {
    if (name.size() > kLongestName) return fmt::format("{} is longer than {} bytes", what, kLongestName);
    const bool control = std::any_of(name.begin(), name.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 0x20 || byte == 0x7f;
    });
    if (control) return fmt::format("{} holds control characters", what);
    if (!text::is_utf8(name)) return fmt::format("{} is not in UTF-8", what);
    return std::nullopt;
}

Sentence vector_fault(TargetKey key, const Vector& vector) {
    for (const double value : vector) {
        if (!(std::abs(value) <= kGreatest)) {
            return fmt::format("'{}' must lie between -1e6 and 1e6; it is {}", name_of(key), value);
        }
    }
    return std::nullopt;
}

Sentence rate_fault(TargetKey key, std::optional<double> value) {
    if (!value || (*value > 0 && *value <= kGreatestRate)) return std::nullopt;
    return fmt::format("'{}' must be greater than 0 and at most 1e9; it is {}", name_of(key), *value);
}

Sentence orientation_fault(const Orientation& orientation) {
    if (const auto* axis = std::get_if<ToolAxis>(&orientation)) {
        if (auto fault = vector_fault(TargetKey::tool_axis, axis->direction)) return fault;
        if (!(to_eigen(axis->direction).norm() > 1e-9)) return "'tool_axis' must not be 0 0 0";
        return std::nullopt;
    }
    if (const auto* rpy = std::get_if<RollPitchYaw>(&orientation)) {
        return vector_fault(TargetKey::rpy_deg, {rpy->roll_deg, rpy->pitch_deg, rpy->yaw_deg});
    }
    for (const auto& [letter, value_deg] : std::get<RotaryAxes>(orientation)) {
        if (letter < 'A' || letter > 'Z') return "'rotary_deg' names axes by capital letters";
        if (auto fault = vector_fault(TargetKey::rotary_deg, {value_deg, 0, 0})) return fault;
    }
    return std::nullopt;
}

Sentence arc_values_fault(const Point& point) {
    if (point.motion != MotionType::circular) return std::nullopt;
    if (const auto* via = std::get_if<ViaPoint>(&point.arc)) {
        return vector_fault(TargetKey::via_mm, via->via_mm);
    }
    const auto& arc = std::get<CenterArc>(point.arc);
    if (auto fault = vector_fault(TargetKey::center_mm, arc.center_mm)) return fault;
    return vector_fault(TargetKey::normal, arc.normal);
}

Sentence rates_fault(const Point& point) {
    if (auto fault = rate_fault(TargetKey::feed_mm_min, point.feed_mm_min)) return fault;
    if (auto fault = rate_fault(TargetKey::feed_deg_min, point.feed_deg_min)) return fault;
    if (auto fault = rate_fault(TargetKey::duration_s, point.duration_s)) return fault;
    if (auto fault = rate_fault(TargetKey::feed_mm_rev, point.feed_mm_rev)) return fault;
    if (auto fault = rate_fault(TargetKey::lead_mm, point.lead_mm)) return fault;
    if (point.feed_mm_rev && !point.feed_mm_min) return "'feed_mm_rev' goes with 'feed_mm_min'";
    if (point.lead_mm && point.motion != MotionType::linear) return "'lead_mm' is of linear motions only";
    return rate_fault(TargetKey::acceleration_mm_s2, point.acceleration_mm_s2);
}

// Checks the actions on arrival.
Sentence arrival_fault(double dwell_s, const std::vector<std::string>& actions) {
    if (!(dwell_s >= 0 && dwell_s <= kGreatest))
        return fmt::format("'dwell_s' must be 0 or greater and at most 1e6; it is {}", dwell_s);
    for (const std::string& action : actions) {
        if (action.empty()) return "an action must have a name";
        if (auto fault = name_fault("an action's name", action)) return fault;
    }
    return std::nullopt;
}

Sentence point_fault(const Point& point) {
    if (auto fault = name_fault("the point's name", point.name)) return fault;
    if (auto fault = vector_fault(TargetKey::position_mm, point.position_mm)) return fault;
    if (auto fault = arc_values_fault(point)) return fault;
    if (point.orientation) {
        if (auto fault = orientation_fault(*point.orientation)) return fault;
    }
    if (auto fault = rates_fault(point)) return fault;
    return arrival_fault(point.dwell_s, point.actions);
}

// Returns true for a name as machine data have it.
bool is_name_of_machine_point(std::string_view name) {
    const auto is_letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
    return !name.empty() && is_letter(name[0]) && std::all_of(name.begin(), name.end(), [&](char c) {
        return is_letter(c) || (c >= '0' && c <= '9') || c == '_';
    });
}

Sentence machine_point_fault(const MachinePoint& point) {
    if (auto fault = name_fault("the point's name", point.name)) return fault;
    const bool is_reference = point.kind == MachinePoint::Kind::reference;
    const int most = is_reference ? kReferencePoints : kGreatestFixedPoint;
    const std::string_view kind = is_reference ? "reference" : "fixed";
    if (point.number != 0) {
        if (point.number < 1 || point.number > most)
            return fmt::format("a {} point has a number from 1 to {}", kind, most);
    } else if (point.called.size() > kLongestName || !is_name_of_machine_point(point.called)) {
        return fmt::format(
            "'{0}' takes the number of a {0} point, or its name: a letter first, then letters, digits and _",
            kind);
    }
    return arrival_fault(point.dwell_s, point.actions);
}

// Position from which the tool comes to a target.
struct Start {
    std::optional<Vector> at_mm = {};
    bool is_machine_point = false;
    bool is_touch = false;
};

class Validator {
  public:
    explicit Validator(const Program& program) : program_(program), height_(program.paths.size()) {}

    std::optional<Fault> run() {
        if (program_.paths.empty()) return Fault{{}, "there is no path"};
        if (program_.root >= program_.paths.size()) return Fault{{}, "the root is none of the paths"};
        if (auto sentence = name_fault("the program's name", program_.name)) return Fault{{}, *sentence};
        check_names();
        check_work_offsets();
        check_frames();
        check_tools();
        for (std::size_t path = 0; path < program_.paths.size() && !fault_; ++path) check_values(path);
        for (std::size_t path = 0; path < program_.paths.size() && !fault_; ++path) check_nesting(path);
        for (std::size_t path = 0; path < program_.paths.size() && !fault_; ++path) check_motions(path);
        if (!fault_) check_motion({program_.root, 0}, {std::nullopt, false, !touches_.empty()});
        return fault_;
    }

  private:
    void fail(std::size_t path, std::optional<std::size_t> target, std::string sentence) {
        if (!fault_) fault_ = Fault{{path, target}, std::move(sentence)};
    }

    void check_names() {
        std::set<std::string_view> names;
        for (std::size_t i = 0; i < program_.paths.size() && !fault_; ++i) {
            const Path& path = program_.paths[i];
            if (path.name.empty()) fail(i, {}, "a path must have a name");
            if (auto sentence = name_fault("the path's name", path.name)) fail(i, {}, *sentence);
            if (!names.insert(path.name).second) {
                fail(i, {}, fmt::format("there are two paths of the name '{}'", path.name));
            }
            if (path.targets.empty()) fail(i, {}, fmt::format("the path '{}' has no targets", path.name));
        }
    }

    void check_work_offsets() {
        for (const auto& [name, offset] : program_.work_offsets) {
            const auto beyond = [](double value) { return !(std::abs(value) <= kGreatest); };
            if (name.empty()) fail(program_.root, {}, "a work offset must have a name");
            if (auto sentence = name_fault("a work offset's name", name)) fail(program_.root, {}, *sentence);
            for (const auto& [letter, value] : offset.origin) {
                if (!beyond(value)) continue;
                fail(program_.root, {},
                     fmt::format("{} of the work offset '{}' must lie between -1e6 and 1e6; it is {}", letter,
                                 name, value));
            }
            if (beyond(offset.rotation_deg))
                fail(program_.root, {}, fmt::format("'{}' must lie between -1e6 and 1e6", kRotationKey));
        }
    }

    void check_frames() {
        for (std::size_t i = 0; i < program_.paths.size(); ++i) {
            check_frame({i, {}}, program_.paths[i].frame);
            const std::vector<Target>& targets = program_.paths[i].targets;
            for (std::size_t target = 0; target < targets.size(); ++target) {
                const auto* use = std::get_if<SubPath>(&targets[target]);
                if (use != nullptr) check_frame({i, target}, use->frame);
            }
        }
    }

    // Checks that offsets set by a program are set once, at its beginning.
    void check_frame(const TargetId& id, const WorkFrame& frame) {
        if (frame.name.empty() && !frame.set_offset_mm && frame.touches.empty()) return;
        if (auto sentence = frame_fault(frame)) return fail(id.path, id.target, *sentence);
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
            if (auto sentence = touch_fault(touch)) fail(id.path, id.target, *sentence);
            if (touch.tool && !program_.paths[program_.root].tool)
                fail(id.path, id.target,
                     "a touch names its tool, so that the path that the program begins with must name its "
                     "own");
        }
        const auto [found, is_new] = touches_.emplace(frame.name, &frame.touches);
        if (!is_new && *found->second != frame.touches)
            fail(id.path, id.target, fmt::format("the work offset '{}' is found in two ways", frame.name));
    }

    Sentence frame_fault(const WorkFrame& frame) const {
        if (program_.is_recorded())
            return "a path that was recorded from a run has its work offsets at its points, not at paths";
        if (frame.name.empty()) return "'set_offset_mm' and 'probe_offset' go with 'work_offset'";
        if (auto fault = name_fault("a work offset's name", frame.name)) return fault;
        return frame.set_offset_mm ? vector_fault(TargetKey::set_offset_mm, *frame.set_offset_mm)
                                   : std::nullopt;
    }

    void check_tools() {
        for (std::size_t i = 0; i < program_.paths.size() && !fault_; ++i) {
            const std::optional<Tool>& tool = program_.paths[i].tool;
            if (!tool) continue;
            names_tools_ = true;
            if (program_.is_recorded())
                fail(i, {}, "a path that was recorded from a run has its tools in the actions of its points");
            for (const int number : {tool->number, tool->length_offset, tool->diameter_offset.value_or(0)}) {
                if (number >= 0 && number <= kGreatestToolNumber) continue;
                fail(i, {},
                     fmt::format("the numbers of a tool lie between 0 and {}; one is {}", kGreatestToolNumber,
                                 number));
            }
        }
    }

    // Checks tool actions, because only the paths' tools define what is in the spindle.
    Sentence tool_action_fault(const std::vector<std::string>& actions) const {
        if (!names_tools_) return std::nullopt;
        const auto change = std::find_if(actions.begin(), actions.end(), is_tool_change);
        if (change == actions.end()) return std::nullopt;
        return fmt::format(
            "the action '{}' stands beside paths that name their 'tool'; name that one so, too", *change);
    }

    // Checks that a point's own offset is one of the program's.
    Sentence work_offset_fault(const Point& point) const {
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
        for (std::size_t i = 0; i < targets.size() && !fault_; ++i) {
            if (const auto* point = std::get_if<Point>(&targets[i])) {
                if (auto sentence = point_fault(*point)) fail(path, i, *sentence);
                if (auto sentence = work_offset_fault(*point)) fail(path, i, *sentence);
                if (auto sentence = tool_action_fault(point->actions)) fail(path, i, *sentence);
                continue;
            }
            if (const auto* point = std::get_if<MachinePoint>(&targets[i])) {
                if (auto sentence = machine_point_fault(*point)) fail(path, i, *sentence);
                if (auto sentence = tool_action_fault(point->actions)) fail(path, i, *sentence);
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
        if (height_[path]) return *height_[path];
        if (std::find(way_.begin(), way_.end(), path) != way_.end()) {
            return refuse(fmt::format("the path '{}' leads back to itself", program_.paths[path].name));
        }
        if (way_.size() > static_cast<std::size_t>(kMaxDepth)) return too_deep();
        way_.push_back(path);
        int height = 0;
        const std::vector<Target>& targets = program_.paths[path].targets;
        for (std::size_t i = 0; i < targets.size() && !fault_; ++i) {
            const auto* sub_path = std::get_if<SubPath>(&targets[i]);
            if (sub_path == nullptr) continue;
            user_ = {path, i};
            height = std::max(height, 1 + check_nesting(sub_path->path));
            if (height > kMaxDepth) {
                user_ = {path, i};
                too_deep();
            }
        }
        way_.pop_back();
        height_[path] = height;
        return height;
    }

    int refuse(std::string sentence) {
        fail(user_.path, user_.target, std::move(sentence));
        return 0;
    }
    int too_deep() {
        return refuse(fmt::format("sub-paths are nested deeper than {} levels here", kMaxDepth));
    }

    Start end_of(const Target& target) const {
        if (const auto* point = std::get_if<Point>(&target)) return {point->position_mm};
        if (std::holds_alternative<MachinePoint>(target)) return {std::nullopt, true};
        return end_of(program_.paths[std::get<SubPath>(target).path].targets.back());
    }

    // Checks all motions except one that the path begins with.
    void check_motions(std::size_t path) {
        Start start;
        const std::vector<Target>& targets = program_.paths[path].targets;
        for (std::size_t i = 0; i < targets.size() && !fault_; ++i) {
            if (i > 0) check_motion({path, i}, start);
            start = end_of(targets[i]);
            const auto* sub_path = std::get_if<SubPath>(&targets[i]);
            if (sub_path != nullptr && sub_path->repeats > 1) check_motion({path, i}, start);
        }
    }

    // Checks the motion that a target begins with, for one of the positions that lead to it.
    void check_motion(const TargetId& id, const Start& start) {
        const Target& target = program_.paths[id.path].targets[*id.target];
        if (const auto* use = std::get_if<SubPath>(&target)) return check_motion({use->path, 0}, start);
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
    std::optional<Fault> fault_;
    std::map<std::string_view, Vector> set_;  // work offsets
    std::map<std::string_view, const std::vector<Touch>*> touches_;
    bool names_tools_ = false;
    std::vector<std::optional<int>> height_;  // of each path
    std::vector<std::size_t> way_;            // from the path at which the search began
    TargetId user_;                           // what leads to the path being looked at
};

}  // namespace

std::optional<Fault> validate(const Program& program) {
    return Validator(program).run();
}

}  // namespace gsim::path
