#pragma once

#include <string_view>

#include "tests/fuzz/target.h"

namespace gsim::fuzz {

// Checks of the targets. For any input, reading it again gives the same, and an error is one line with a
// position. Further promises are documented with each check.

/// Part programs become Lua, or there is a diagnostic. The Lua has the source's lines one further down and
/// one line after them, and Lua compiles it.
Outcome check_translate_ab9(std::string_view gcode);
Outcome check_translate_rs274ngc(std::string_view gcode);

/// Part programs that are translated, and scripts, run to an end within small limits. A second run gives the
/// same report (fault_of_report() defines what holds for one).
Outcome check_simulate_ab9(std::string_view gcode);
Outcome check_simulate_rs274ngc(std::string_view gcode);
Outcome check_lua_script(std::string_view lua);

/// A machine, or the rules of a controller, that is printed reads as the same; moves can be planned for it.
Outcome check_machine(std::string_view toml);
Outcome check_controller(std::string_view toml);
/// A machine can move in a cell that was read.
Outcome check_cell(std::string_view toml);
Outcome check_robots(std::string_view toml);
/// A program runs to its end whatever the operator turns.
Outcome check_overrides(std::string_view toml);
/// A path is written by a post, or refused.
Outcome check_post(std::string_view toml);
/// Plans by a table of materials have finite figures.
Outcome check_materials(std::string_view toml);

/// Changes of a document are made as requested, or rejected without any change.
Outcome check_toml_edit(std::string_view bytes);

/// Paths are written and read back the same. By the posts that are built in they become programs that the
/// posts' dialects read.
Outcome check_path_json(std::string_view json);
Outcome check_path_script(std::string_view lua);

/// Machine data come back byte for byte, and mean the same when they are rewritten.
Outcome check_machine_data(std::string_view text);
Outcome check_machine_data_json(std::string_view json);
/// Permanent variables are written and read back the same.
Outcome check_variables(std::string_view text);

/// Settings imported from a controller can be written as machine data and machine files.
Outcome check_tool_table(std::string_view text);
Outcome check_parameters(std::string_view text);
Outcome check_linuxcnc_ini(std::string_view text);
Outcome check_grbl_settings(std::string_view text);

/// Jobs of a plan of many runs are the same when the plan is handed on, and come back from their lines.
Outcome check_batch_plan(std::string_view toml);

/// Recorded motion of a machine, for calibration: samples are finite and their times rise, for any
/// interpretation of the numbers in columns; a motion takes a time.
Outcome check_motion_record(std::string_view text);
/// Each axis has as many set points and positions as times, which rise.
Outcome check_servo_record(std::string_view text);
/// Each run has a program, and a time above 0 or a recording.
Outcome check_run_list(std::string_view text);
/// TCPs are written and read back the same.
Outcome check_tip_list(std::string_view text);

/// Contours are finite and within bounds, and come from entities.
Outcome check_dxf(std::string_view text);
Outcome check_svg(std::string_view text);
/// The path that cuts a drawing is a well-formed one.
Outcome check_autopath(std::string_view svg);
/// Meshes have triangles of finite corners.
Outcome check_mesh_stl(std::string_view bytes);
Outcome check_mesh_obj(std::string_view text);
/// Answer of the program that reads STEP and IGES files.
Outcome check_solid_packet(std::string_view bytes);

/// For any answer of a controller module, values passed on are finite and of the right size, an error is
/// permanent, and the run ends.
Outcome check_rcs_values(std::string_view bytes);

/// For any request of a page, the answer's messages are complete, and its last one says how it ended.
Outcome check_studio_request(std::string_view json);
Outcome check_server_request(std::string_view sent);

}  // namespace gsim::fuzz
