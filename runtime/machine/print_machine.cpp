#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "runtime/machine/machine_file.h"

namespace gsim::machine {

namespace {

std::string toml_string(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            out += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
        } else {
            out += c;
        }
    }
    return out + '"';
}

// Writes tables line by line; values that are as if the key were left out are left out.
class TomlText {
  public:
    void section(std::string_view header) {
        if (!text_.empty()) text_ += '\n';
        text_ += header;
        text_ += '\n';
    }
    void line(std::string_view key, std::string_view value) {
        fmt::format_to(std::back_inserter(text_), "{} = {}\n", key, value);
    }
    void number(std::string_view key, double value) { line(key, number_text(value)); }
    void limit(std::string_view key, double value) {
        if (std::isfinite(value)) number(key, value);
    }
    std::string take() { return std::move(text_); }

    /// A float of TOML in its shortest form, 254 as "254.0".
    static std::string number_text(double value) {
        std::string text = fmt::format("{}", value);
        if (std::isfinite(value) && text.find_first_of(".e") == std::string::npos) text += ".0";
        return text;
    }

  private:
    std::string text_;
};

void print_path_limits(TomlText& out, const PathLimits& path) {
    if (path == PathLimits{}) return;
    out.section("[path]");
    out.limit("max_feed_mm_s", path.max_feed_mm_s);
    out.limit("max_rapid_mm_s", path.max_rapid_mm_s);
    out.limit("max_acceleration_mm_s2", path.max_acceleration_mm_s2);
}

void print_frame(TomlText& out, std::string_view header, const Frame& frame) {
    if (frame == Frame{}) return;
    out.section(header);
    out.number("x_mm", frame.x_mm);
    out.number("y_mm", frame.y_mm);
    out.number("z_mm", frame.z_mm);
    out.number("roll_deg", frame.roll_deg);
    out.number("pitch_deg", frame.pitch_deg);
    out.number("yaw_deg", frame.yaw_deg);
}

void print_axis(TomlText& out, const Axis& axis) {
    const bool linear = axis.kind == AxisKind::linear;
    const auto key = [unit = linear ? "mm" : "deg"](std::string_view name, std::string_view per = "") {
        return fmt::format("{}_{}{}", name, unit, per);
    };
    const auto number = TomlText::number_text;
    out.section("[[axis]]");
    out.line("letter", toml_string({&axis.letter, 1}));
    out.line("kind", linear ? "\"linear\"" : "\"rotary\"");
    out.limit(key("min"), axis.min);
    out.limit(key("max"), axis.max);
    out.limit(key("max_speed", "_s"), axis.max_speed);
    out.limit(key("max_acceleration", "_s2"), axis.max_acceleration);
    out.number(key("home"), axis.home);
    out.number(key("zero"), axis.zero);
    out.line("dh", fmt::format("{{ theta_deg = {}, d_mm = {}, a_mm = {}, alpha_deg = {} }}",
                               number(axis.dh.theta_deg), number(axis.dh.d_mm), number(axis.dh.a_mm),
                               number(axis.dh.alpha_deg)));
}

}  // namespace

std::string print_machine(const Machine& machine) {
    TomlText out;
    out.section("[machine]");
    out.line("name", toml_string(machine.name));
    out.line("inverse", machine.inverse == InverseKind::gantry ? "\"gantry\"" : "\"none\"");
    print_path_limits(out, machine.path);
    print_frame(out, "[base]", machine.base);
    print_frame(out, "[tool]", machine.tool);
    for (const Axis& axis : machine.axes) print_axis(out, axis);
    return out.take();
}

}  // namespace gsim::machine
