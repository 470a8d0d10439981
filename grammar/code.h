#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gsim::grammar {

/// Modal groups: a block accepts one code of each group, and the last one given stays active.
enum class Group : std::uint8_t {
    none,
    motion,
    plane,
    units,
    distance,
    feed_mode,
    cutter_compensation,
    tool_length,
    cycle,
    return_level,
    scaling,
    mirror,
    rotation,
    work_frame,
    path_mode,
    polar,
    zone,
    macro,
    spindle_mode,
    acceleration,
    stop,
    spindle,
    tool_change,
    jet,
    abrasive,
    coolant,
    subprogram,
    override_switch,
    arc_distance,
    lathe_diameter,
    modal_state,
    input_output,
    extrusion,
    user,
    non_modal,  ///< The last one.
};

inline constexpr std::size_t kGroupCount = static_cast<std::size_t>(Group::non_modal) + 1;
std::string_view name(Group group);

/// Use of the axis words of a block by a code.
enum class AxisUse : std::uint8_t { none, motion, data };

/// Support of a code in the library. `without_words`: only without words, because it switches off something
/// that cannot be on; with words it is `planned`.
enum class Support : std::uint8_t { full, without_words, planned };

/// Effect of cutter compensation on a code. It acts as usual, or is rejected, always or only while the tool
/// runs next to the path (RS274/NGC permits a radius of 0). Or the tool is led out before it and then in
/// again (9/Series). Or the move before it ends first, whatever corner follows (RS274/NGC).
enum class Compensation : std::uint8_t {
    allowed,
    rejected,
    refused_next_to_path,
    lead_out_and_in,
    ends_move
};

/// Time in its block at which a code acts, here in the order of the 9/Series; another dialect has its own
/// (Dialect::rank). Words of one phase act in their order in the block.
enum class Phase : std::uint8_t {
    plane,
    units,
    compensation,
    tool_length,
    cycle,
    distance,
    work_frame,
    path_mode,
    feed_mode,
    feed,
    spindle_speed,
    tool,
    offset_number,
    tool_change,
    switch_on,
    dwell,
    data,
    polar,
    one_shot,
    motion,
    switch_off,
    spindle_stop,
    pause,
    flow,
    input_output,  ///< The last one.
};
inline constexpr std::size_t kPhaseCount = static_cast<std::size_t>(Phase::input_output) + 1;
/// Returns a description of the actions of a phase.
std::string_view name(Phase phase);

/// Row of a dialect's table.
struct Code {
    char letter;            ///< 'G' or 'M'
    std::int32_t code_x10;  ///< 921: G92.1
    Group group;
    Phase phase;
    AxisUse axes;
    std::string_view words;  ///< Letters it accepts in addition to axis words, '=' for AR=, '1' for I1= J1=
                             ///< K1=, ',' for ,C ,R ,A.
    Support support;
    std::string_view meaning;  ///< As messages and documents say it.
    Compensation compensation = Compensation::allowed;
};

/// Returns the usual name of a code: "G92.1", "M8".
std::string code_name(const Code& code);
/// Returns the function of the Lua library: "G92_1", "M8", "M[101]".
std::string lua_name(const Code& code);

}  // namespace gsim::grammar
