#include "toolpath/json/json_writer.h"

#include <iterator>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/text/file_format.h"
#include "base/text/format.h"
#include "base/text/json_text.h"
#include "toolpath/json/keys.h"

namespace gsim::path {

namespace {

constexpr std::size_t kEnough = std::size_t{1} << 16;

std::string quoted(const std::string& text) {
    fmt::memory_buffer json;
    text::append_json_string(json, text);
    return fmt::to_string(json);
}

class Writer {
  public:
    Writer(const Program& program, const std::function<void(std::string_view)>& sink)
        : program_(program), sink_(sink) {}

    void write() {
        print("{{\n\"format\": {},\n\"name\": {},\n\"root\": {},\n", text::kFileFormat, quoted(program_.name),
              quoted(program_.paths[program_.root].name));
        if (program_.is_recorded()) write_work_offsets();
        print("\"paths\": [\n");
        for (const Path& path : program_.paths) {
            write_path(path);
            print("{}\n", &path == &program_.paths.back() ? "" : ",");
        }
        print("]\n}}\n");
        sink_({text_.data(), text_.size()});
    }

  private:
    template <typename... Values>
    void print(fmt::format_string<Values...> format, Values&&... values) {
        text::append_format(text_, format, std::forward<Values>(values)...);
    }

    void write_work_offsets() {
        print("\"work_offsets\": {{");
        const char* separator = "";
        for (const auto& [name, offset] : program_.work_offsets) {
            print("{}{}: {{", separator, quoted(name));
            const char* between = "";
            for (const auto& [letter, value] : offset.origin) {
                print("{}\"{}\": {}", between, letter, value);
                between = ", ";
            }
            if (offset.rotation_deg != 0) print("{}\"{}\": {}", between, kRotationKey, offset.rotation_deg);
            print("}}");
            separator = ", ";
        }
        print("}},\n");
    }

    void write_path(const Path& path) {
        print("{{\"name\": {}", quoted(path.name));
        write_frame(path.frame);
        if (path.tool) write_tool(*path.tool);
        print(", \"targets\": [\n");
        for (const Target& target : path.targets) {
            std::visit([this](const auto& each) { write_target(each); }, target);
            print("{}\n", &target == &path.targets.back() ? "" : ",");
            flush_buffer();
        }
        print("]}}");
    }

    void write_target(const SubPath& sub_path) {
        print("{{\"path\": {}", quoted(program_.paths[sub_path.path].name));
        if (sub_path.repeats != 1) print(", \"repeats\": {}", sub_path.repeats);
        write_frame(sub_path.frame);
        print("}}");
    }

    void write_frame(const WorkFrame& frame) {
        if (!frame.name.empty()) print(", \"{}\": {}", key_name(TargetKey::work_offset), quoted(frame.name));
        if (frame.set_offset_mm) vector(TargetKey::set_offset_mm, *frame.set_offset_mm);
        if (frame.touches.empty()) return;
        print(", \"{}\": [", key_name(TargetKey::probe_offset));
        for (const Touch& touch : frame.touches) {
            if (&touch != &frame.touches.front()) print(", ");
            write_touch(touch);
        }
        print("]");
    }

    void write_touch(const Touch& touch) {
        print("{{\"{}\": \"{}\", \"{}\": [{}, {}, {}]", key_name(TouchKey::axis), touch.axis,
              key_name(TouchKey::from_mm), touch.from_mm[0], touch.from_mm[1], touch.from_mm[2]);
        print(", \"{}\": {}, \"{}\": {}, \"{}\": {}", key_name(TouchKey::to_mm), touch.to_mm,
              key_name(TouchKey::surface_mm), touch.surface_mm, key_name(TouchKey::feed_mm_min),
              touch.feed_mm_min);
        if (touch.probe_radius_mm != 0)
            print(", \"{}\": {}", key_name(TouchKey::probe_radius_mm), touch.probe_radius_mm);
        if (touch.tool) print(", \"{}\": {}", key_name(TouchKey::tool), *touch.tool);
        print("}}");
    }

    void write_tool(const Tool& tool) {
        print(", \"{}\": {}", key_name(PathKey::tool), tool.number);
        if (tool.length_offset != tool.number)
            print(", \"{}\": {}", key_name(PathKey::length_offset), tool.length_offset);
        if (tool.diameter_offset)
            print(", \"{}\": {}", key_name(PathKey::diameter_offset), *tool.diameter_offset);
    }

    void write_target(const Point& point) {
        print("{{");
        if (!point.name.empty()) print("\"name\": {}, ", quoted(point.name));
        print("\"motion\": \"{}\"", kMotionNames[static_cast<std::size_t>(point.motion)]);
        vector(TargetKey::position_mm, point.position_mm);
        if (point.motion == MotionType::circular) {
            std::visit([this](const auto& arc) { write_arc(arc); }, point.arc);
        }
        if (point.orientation) {
            std::visit([this](const auto& value) { write_orientation(value); }, *point.orientation);
        }
        number(TargetKey::feed_mm_min, point.feed_mm_min);
        number(TargetKey::feed_deg_min, point.feed_deg_min);
        number(TargetKey::duration_s, point.duration_s);
        number(TargetKey::feed_mm_rev, point.feed_mm_rev);
        number(TargetKey::lead_mm, point.lead_mm);
        if (!point.work_offset.empty())
            print(", \"{}\": {}", key_name(TargetKey::work_offset), quoted(point.work_offset));
        number(TargetKey::acceleration_mm_s2, point.acceleration_mm_s2);
        if (point.dwell_s != 0) number(TargetKey::dwell_s, point.dwell_s);
        write_actions(point.actions);
        print("}}");
    }

    void write_target(const MachinePoint& point) {
        print("{{");
        if (!point.name.empty()) print("\"name\": {}, ", quoted(point.name));
        const auto key = point.kind == MachinePoint::Kind::fixed ? TargetKey::fixed : TargetKey::reference;
        print("\"{}\": {}", key_name(key),
              point.alias.empty() ? fmt::format("{}", point.number) : quoted(point.alias));
        if (point.dwell_s != 0) number(TargetKey::dwell_s, point.dwell_s);
        write_actions(point.actions);
        print("}}");
    }

    void write_arc(const ViaPoint& arc) { vector(TargetKey::via_mm, arc.via_mm); }
    void write_arc(const CenterArc& arc) {
        vector(TargetKey::center_mm, arc.center_mm);
        vector(TargetKey::normal, arc.normal);
        number(TargetKey::turn_deg, arc.turn_deg);
    }

    void write_orientation(const ToolAxis& axis) { vector(TargetKey::tool_axis, axis.direction); }
    void write_orientation(const RollPitchYaw& angles) {
        vector(TargetKey::rpy_deg, {angles.roll_deg, angles.pitch_deg, angles.yaw_deg});
    }
    void write_orientation(const RotaryAxes& axes) {
        print(", \"{}\": {{", key_name(TargetKey::rotary_deg));
        const char* separator = "";
        for (const auto& [letter, value_deg] : axes) {
            print("{}\"{}\": {}", separator, letter, value_deg);
            separator = ", ";
        }
        print("}}");
    }

    void write_actions(const std::vector<std::string>& actions) {
        if (actions.empty()) return;
        print(", \"{}\": [", key_name(TargetKey::actions));
        for (const std::string& action : actions) {
            print("{}{}", &action == &actions.front() ? "" : ", ", quoted(action));
        }
        print("]");
    }

    void vector(TargetKey key, const Vector& value) {
        print(", \"{}\": [{}, {}, {}]", key_name(key), value[0], value[1], value[2]);
    }
    void number(TargetKey key, std::optional<double> value) {
        if (value) print(", \"{}\": {}", key_name(key), *value);
    }

    void flush_buffer() {
        if (text_.size() < kEnough) return;
        sink_({text_.data(), text_.size()});
        text_.clear();
    }

    const Program& program_;
    const std::function<void(std::string_view)>& sink_;
    fmt::memory_buffer text_;
};

}  // namespace

void write_json(const Program& program, const std::function<void(std::string_view)>& sink) {
    Writer(program, sink).write();
}

std::string to_json(const Program& program) {
    std::string text;
    write_json(program, [&text](std::string_view chunk) { text += chunk; });
    return text;
}

}  // namespace gsim::path
