#include <fmt/format.h>

#include "codegen/lua/lua_spool.h"
#include "codegen/translate.h"
#include "machine/file/machine_file.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/small_run.h"

namespace gsim::fuzz {
namespace {

/// This controller looks ahead, rounds corners and limits the jerk; its rotary axes turn the tool about its
/// TCP.
constexpr std::string_view kGantryRules = R"(
[controller]
model = "blend"
limit_jerk = true
)";

/// Another planner, and no limits on an axis but its speed and acceleration.
constexpr std::string_view kRouter = R"(
[machine]
name = "router"
[controller]
model = "linuxcnc-2.9"
[process]
kind = "spindle"
on = ["M3", "M4"]
off = ["M5"]
[[axis]]
letter = "X"
kind = "linear"
min_mm = -500.0
max_mm = 500.0
max_speed_mm_s = 100.0
max_acceleration_mm_s2 = 1000.0
direction = "x"
[[axis]]
letter = "Y"
kind = "linear"
min_mm = -500.0
max_mm = 500.0
max_speed_mm_s = 100.0
max_acceleration_mm_s2 = 1000.0
direction = "y"
[[axis]]
letter = "Z"
kind = "linear"
min_mm = -500.0
max_mm = 500.0
max_speed_mm_s = 100.0
max_acceleration_mm_s2 = 500.0
direction = "z"
[[axis]]
letter = "A"
kind = "rotary"
max_speed_deg_s = 90.0
max_acceleration_deg_s2 = 200.0
turning = "shortest"
direction = "x"
)";

machine::Machine gantry() {
    return machine::read_machine(fmt::format("{}{}", machine::built_in_machine_toml(), kGantryRules),
                                 "gantry")
        .value();
}

machine::Machine router() {
    return machine::read_machine(kRouter, "router").value();
}

Outcome simulate(std::string_view gcode, const grammar::Dialect& dialect, machine::Machine machine) {
    codegen::TranslateOptions options;
    options.dialect = &dialect;
    options.source_name = "fuzz.nc";
    codegen::TextTranslation translation = codegen::translate_text(gcode, options);
    if (!translation.ok) return rejected();
    return check_run({.machine = std::move(machine),
                      .lua = std::move(translation.lua),
                      .dialect = std::string(dialect.name()),
                      .file_name = "fuzz.nc",
                      .line_offset = -1});
}

}  // namespace

Outcome check_simulate_ab9(std::string_view gcode) {
    return simulate(gcode, grammar::dialect_ab9(), gantry());
}

Outcome check_simulate_rs274ngc(std::string_view gcode) {
    return simulate(gcode, grammar::dialect_rs274ngc(), router());
}

Outcome check_lua_script(std::string_view lua) {
    const codegen::ScriptOrigin origin = codegen::script_origin(lua);
    const bool is_ngc = lua.find("gsim.rs274ngc") != std::string_view::npos;
    SmallRun run{.machine = is_ngc ? router() : gantry(), .lua = std::string(lua)};
    if (is_ngc) run.dialect = "rs274ngc";
    if (origin.unedited) run.file_name = origin.source_name;
    return check_run(run);
}

}  // namespace gsim::fuzz
