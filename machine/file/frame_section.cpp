#include "machine/file/frame_section.h"

#include <array>
#include <utility>

#include "base/toml/toml_writer.h"

namespace gsim::machine {

using base::FirstError;
using base::NumberRule;
using base::TomlSection;

using std::string_view_literals::operator""sv;

namespace {

constexpr std::array kFrameKeys{"x_mm"sv, "y_mm"sv, "z_mm"sv, "roll_deg"sv, "pitch_deg"sv, "yaw_deg"sv};

}  // namespace

Frame read_frame(FirstError& error, const toml::table* table, std::string title) {
    if (!table) return {};
    TomlSection section(error, *table, std::move(title), kFrameKeys);
    const auto number = [&](std::string_view key) { return section.number(key, 0, NumberRule::finite); };
    return {.x_mm = number("x_mm"),
            .y_mm = number("y_mm"),
            .z_mm = number("z_mm"),
            .roll_deg = number("roll_deg"),
            .pitch_deg = number("pitch_deg"),
            .yaw_deg = number("yaw_deg")};
}

std::string inline_frame(const Frame& frame) {
    return fmt::format(
        "{{ x_mm = {}, y_mm = {}, z_mm = {}, roll_deg = {}, pitch_deg = {}, "
        "yaw_deg = {} }}",
        base::toml_number(frame.x_mm), base::toml_number(frame.y_mm), base::toml_number(frame.z_mm),
        base::toml_number(frame.roll_deg), base::toml_number(frame.pitch_deg),
        base::toml_number(frame.yaw_deg));
}

}  // namespace gsim::machine
