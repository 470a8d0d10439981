#include "grammar/code.h"

#include <fmt/format.h>

namespace gsim::grammar {

std::string_view name(Group group) {
    switch (group) {
        case Group::none: return "non-modal";
        case Group::motion: return "motion";
        case Group::plane: return "plane";
        case Group::units: return "units";
        case Group::distance: return "distance mode";
        case Group::feed_mode: return "feed mode";
        case Group::cutter_compensation: return "cutter compensation";
        case Group::tool_length: return "tool length";
        case Group::cycle: return "canned cycles";
        case Group::return_level: return "return level of cycles";
        case Group::scaling: return "scaling";
        case Group::mirror: return "mirror image";
        case Group::rotation: return "part rotation";
        case Group::work_frame: return "work coordinate system";
        case Group::path_mode: return "path mode";
        case Group::polar: return "polar programming";
        case Group::zone: return "programmable zone";
        case Group::macro: return "modal macro call";
        case Group::spindle_mode: return "spindle speed mode";
        case Group::acceleration: return "acceleration mode";
        case Group::stop: return "program stop";
        case Group::spindle: return "spindle";
        case Group::tool_change: return "tool change";
        case Group::jet: return "jet";
        case Group::abrasive: return "abrasive";
        case Group::subprogram: return "subprograms";
        case Group::override_switch: return "override switch";
        case Group::coolant: return "coolant";
        case Group::arc_distance: return "arc centre mode";
        case Group::lathe_diameter: return "lathe diameter mode";
        case Group::modal_state: return "modal state";
        case Group::input_output: return "inputs and outputs";
        case Group::extrusion: return "extruder mode";
        case Group::user: return "user M codes";
        case Group::non_modal: return "one action per block";
    }
    return "";
}

std::string_view name(Phase phase) {
    switch (phase) {
        case Phase::plane: return "plane";
        case Phase::units: return "units";
        case Phase::compensation: return "compensation and transformations";
        case Phase::tool_length: return "tool length";
        case Phase::cycle: return "cycle modes";
        case Phase::distance: return "distance mode";
        case Phase::work_frame: return "work coordinate system";
        case Phase::path_mode: return "path mode";
        case Phase::feed_mode: return "feed mode";
        case Phase::feed: return "F";
        case Phase::spindle_speed: return "S";
        case Phase::tool: return "T";
        case Phase::offset_number: return "D and H";
        case Phase::tool_change: return "tool change";
        case Phase::switch_on: return "spindle and switches on";
        case Phase::dwell: return "dwell";
        case Phase::data: return "data and offsets";
        case Phase::polar: return "polar programming";
        case Phase::one_shot: return "settings for this block only";
        case Phase::motion: return "motion";
        case Phase::switch_off: return "switches off";
        case Phase::spindle_stop: return "spindle off";
        case Phase::pause: return "stops";
        case Phase::flow: return "calls and ends";
        case Phase::input_output: return "inputs, outputs, modal state";
    }
    return "";
}

namespace {

/// Returns "G1" for G1 and G1.5; called for each code of a program.
std::string full_name(const Code& code) {
    std::string name(1, code.letter);
    name += std::to_string(code.code_x10 / 10);
    return name;
}

}  // namespace

std::string code_name(const Code& code) {
    const int part = code.code_x10 % 10;
    return part == 0 ? full_name(code) : fmt::format("{}.{}", full_name(code), part);
}

std::string lua_name(const Code& code) {
    const int part = code.code_x10 % 10;
    if (code.group == Group::user) return fmt::format("M[{}]", code.code_x10 / 10);
    return part == 0 ? full_name(code) : fmt::format("{}_{}", full_name(code), part);
}

}  // namespace gsim::grammar
