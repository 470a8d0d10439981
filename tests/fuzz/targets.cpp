#include <algorithm>
#include <array>

#include "tests/fuzz/checks.h"

namespace gsim::fuzz {
namespace {

constexpr std::array kTargets{
    Target{"translate_ab9", "gcode", check_translate_ab9},
    Target{"translate_rs274ngc", "gcode", check_translate_rs274ngc},
    Target{"simulate_ab9", "gcode", check_simulate_ab9},
    Target{"simulate_rs274ngc", "gcode", check_simulate_rs274ngc},
    Target{"lua_script", "lua_script", check_lua_script},
    Target{"machine", "machine", check_machine},
    Target{"controller", "controller", check_controller},
    Target{"cell", "cell", check_cell},
    Target{"robots", "robots", check_robots},
    Target{"overrides", "overrides", check_overrides},
    Target{"post", "post", check_post},
    Target{"materials", "materials", check_materials},
    Target{"toml_edit", "toml_edit", check_toml_edit},
    Target{"path_json", "path_json", check_path_json},
    Target{"path_script", "path_script", check_path_script},
    Target{"machine_data", "machine_data", check_machine_data},
    Target{"machine_data_json", "machine_data_json", check_machine_data_json},
    Target{"variables", "variables", check_variables},
    Target{"tool_table", "tool_table", check_tool_table},
    Target{"parameters", "parameters", check_parameters},
    Target{"linuxcnc_ini", "linuxcnc_ini", check_linuxcnc_ini},
    Target{"grbl_settings", "grbl_settings", check_grbl_settings},
    Target{"batch_plan", "batch_plan", check_batch_plan},
    Target{"motion_record", "motion_record", check_motion_record},
    Target{"servo_record", "servo_record", check_servo_record},
    Target{"run_list", "run_list", check_run_list},
    Target{"tip_list", "tip_list", check_tip_list},
    Target{"dxf", "dxf", check_dxf},
    Target{"svg", "svg", check_svg},
    Target{"autopath", "svg", check_autopath},
    Target{"mesh_stl", "mesh_stl", check_mesh_stl},
    Target{"mesh_obj", "mesh_obj", check_mesh_obj},
    Target{"solid_packet", "solid_packet", check_solid_packet},
    Target{"rcs_values", "rcs_values", check_rcs_values},
    Target{"studio_request", "studio_request", check_studio_request},
    Target{"server_request", "server_request", check_server_request, false},
};

}  // namespace

std::span<const Target> targets() {
    return kTargets;
}

const Target* find_target(std::string_view name) {
    const auto* const found = std::find_if(kTargets.begin(), kTargets.end(),
                                           [name](const Target& one) { return one.name == name; });
    return found == kTargets.end() ? nullptr : found;
}

}  // namespace gsim::fuzz
