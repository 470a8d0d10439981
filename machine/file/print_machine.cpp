#include <string>

#include <fmt/format.h>

#include "base/text/file_format.h"
#include "base/toml/toml_writer.h"
#include "machine/file/calibration_section.h"
#include "machine/file/controller_file.h"
#include "machine/file/drive_section.h"
#include "machine/file/dynamics_section.h"
#include "machine/file/frame_section.h"
#include "machine/file/group_section.h"
#include "machine/file/machine_file.h"
#include "machine/file/print_shapes.h"
#include "machine/file/process_section.h"
#include "machine/file/program_section.h"
#include "machine/file/servo_section.h"
#include "machine/file/times_section.h"

namespace gsim::machine {

namespace {

using base::TomlWriter;

void print_path_limits(TomlWriter& out, const PathLimits& path) {
    if (path == PathLimits{}) return;
    out.section("[path]");
    out.limit("max_feed_mm_s", path.max_feed_mm_s);
    out.limit("max_rapid_mm_s", path.max_rapid_mm_s);
    out.limit("max_acceleration_mm_s2", path.max_acceleration_mm_s2);
    out.limit("max_rapid_acceleration_mm_s2", path.max_rapid_acceleration_mm_s2);
    out.limit("max_jerk_mm_s3", path.max_jerk_mm_s3);
}

void print_frame(TomlWriter& out, std::string_view header, const Frame& frame) {
    if (frame == Frame{}) return;
    out.section(header);
    out.number("x_mm", frame.x_mm);
    out.number("y_mm", frame.y_mm);
    out.number("z_mm", frame.z_mm);
    out.number("roll_deg", frame.roll_deg);
    out.number("pitch_deg", frame.pitch_deg);
    out.number("yaw_deg", frame.yaw_deg);
}

std::string_view name(InverseKind kind) {
    switch (kind) {
        case InverseKind::gantry: return "\"gantry\"";
        case InverseKind::numeric: return "\"numeric\"";
        case InverseKind::none: break;
    }
    return "\"none\"";
}

std::string_view name(RotaryMode turning) {
    switch (turning) {
        case RotaryMode::shortest: return "\"shortest\"";
        case RotaryMode::unwind: return "\"unwind\"";
        case RotaryMode::limited: break;
    }
    return "\"limited\"";
}

void print_joint(TomlWriter& out, const Axis& axis) {
    if (axis.carries == CarriedPart::none) return;
    if (axis.direction) out.line("direction", base::toml_string(name(*axis.direction)));
    if (!axis.direction && (!axis.frame || axis.dh != DhRow{})) {
        out.line("dh", fmt::format("{{ theta_deg = {}, d_mm = {}, a_mm = {}, alpha_deg = {} }}",
                                   base::toml_number(axis.dh.theta_deg), base::toml_number(axis.dh.d_mm),
                                   base::toml_number(axis.dh.a_mm), base::toml_number(axis.dh.alpha_deg)));
    }
    if (axis.frame) out.line("frame", inline_frame(*axis.frame));
}

void print_axis(TomlWriter& out, const Axis& axis) {
    const bool linear = axis.kind == AxisKind::linear;
    const auto key = [unit = linear ? "mm" : "deg"](std::string_view name, std::string_view per = "") {
        return fmt::format("{}_{}{}", name, unit, per);
    };
    out.section("[[axis]]");
    out.line("letter", base::toml_string({&axis.letter, 1}));
    out.line("kind", linear ? "\"linear\"" : "\"rotary\"");
    out.limit(key("min"), axis.min);
    out.limit(key("max"), axis.max);
    out.limit(key("max_speed", "_s"), axis.max_speed);
    out.limit(key("max_acceleration", "_s2"), axis.max_acceleration);
    if (axis.max_deceleration) out.number(key("max_deceleration", "_s2"), *axis.max_deceleration);
    out.limit(key("max_jerk", "_s3"), axis.max_jerk);
    out.limit(key("max_speed_step", "_s"), axis.max_speed_step);
    if (axis.step != 0) out.number(key("step"), axis.step);
    out.number(key("home"), axis.home);
    for (std::size_t i = 0; i < axis.other_homes.size(); ++i) {
        if (axis.other_homes[i]) out.number(key(fmt::format("home{}", i + 2)), *axis.other_homes[i]);
    }
    out.number(key("zero"), axis.zero);
    if (axis.carries != CarriedPart::tool) out.line("carries", base::toml_string(name(axis.carries)));
    if (axis.turning != RotaryMode::limited) out.line("turning", name(axis.turning));
    print_joint(out, axis);
    print_drive(out, axis);
    print_servo(out, axis);
}

}  // namespace

std::string print_machine(const Machine& machine) {
    TomlWriter out;
    out.line("format", std::to_string(text::kFileFormat));
    print_ignored(out, machine);
    out.section("[machine]");
    out.line("name", base::toml_string(machine.name));
    out.line("inverse", name(machine.inverse));
    print_program_section(out, machine.program);
    print_path_limits(out, machine.path);
    print_frame(out, "[base]", machine.base);
    print_frame(out, "[tool]", machine.tool);
    print_frame(out, "[work]", machine.work);
    print_controller(out, machine.controller);
    if (machine.process) print_process(out, *machine.process);
    print_times(out, machine.times);
    for (const Axis& axis : machine.axes) print_axis(out, axis);
    print_groups(out, machine);
    print_link_shapes(out, machine);
    if (machine.dynamics) print_dynamics(out, *machine.dynamics);
    if (machine.calibration) print_calibration(out, *machine.calibration);
    return out.release();
}

}  // namespace gsim::machine
