#include <array>

#include "grammar/dialect.h"

namespace gsim::grammar {

namespace {

namespace klipper_table {

using enum Group;
using enum Support;
using P = Phase;
using A = AxisUse;

// According to Klipper's "G-Codes" page and the code of klippy (2026). E is the extruder, F in mm/min.
constexpr std::array kCodes = {
    Code{'G', 0, motion, P::motion, A::motion, "EF", full, "linear move, as G1"},
    Code{'G', 10, motion, P::motion, A::motion, "EF", full, "linear move"},
    Code{'G', 20, motion, P::motion, A::motion, "IJKREF", full, "arc, clockwise, as chords"},
    Code{'G', 30, motion, P::motion, A::motion, "IJKREF", full, "arc, counterclockwise, as chords"},
    Code{'G', 40, non_modal, P::dwell, A::none, "P", full, "dwell in milliseconds"},
    Code{'G', 100, non_modal, P::data, A::none, "", full, "draw the filament back"},
    Code{'G', 110, non_modal, P::data, A::none, "", full, "push the filament that G10 drew back"},
    Code{'G', 170, plane, P::plane, A::none, "", full, "XY plane"},
    Code{'G', 180, plane, P::plane, A::none, "", full, "XZ plane"},
    Code{'G', 190, plane, P::plane, A::none, "", full, "YZ plane"},
    Code{'G', 200, units, P::units, A::none, "", full, "inches, which end the program"},
    Code{'G', 210, units, P::units, A::none, "", full, "millimetres"},
    Code{'G', 280, non_modal, P::data, A::data, "", planned, "homing"},
    Code{'G', 900, Group::distance, P::distance, A::none, "", full, "absolute dimensions"},
    Code{'G', 910, Group::distance, P::distance, A::none, "", full, "incremental dimensions"},
    Code{'G', 920, non_modal, P::data, A::data, "E", full, "the values that the position has from now on"},
    Code{'M', 180, non_modal, P::pause, A::none, "", full, "motors off"},
    Code{'M', 820, extrusion, P::distance, A::none, "", full, "E absolute, under G90"},
    Code{'M', 830, extrusion, P::distance, A::none, "", full, "E incremental"},
    Code{'M', 840, non_modal, P::pause, A::none, "", full, "motors off"},
    Code{'M', 1090, non_modal, P::pause, A::none, "", planned, "wait for the extruder's temperature"},
    Code{'M', 1120, non_modal, P::pause, A::none, "", planned, "emergency stop"},
    Code{'M', 1900, non_modal, P::pause, A::none, "", planned, "wait for the bed's temperature"},
    Code{'M', 2040, acceleration, P::data, A::none, "SPT", full, "acceleration of the path"},
    Code{'M', 2200, override_switch, P::data, A::none, "S", full, "factor of speeds, in percent"},
    Code{'M', 2210, override_switch, P::data, A::none, "S", full, "factor of E, in percent"},
    Code{'M', 4000, non_modal, P::flow, A::none, "", full, "wait until all moves have been made"},
};

constexpr std::array kExtended = {
    ExtendedCommand{"SET_VELOCITY_LIMIT", "VELOCITY ACCEL SQUARE_CORNER_VELOCITY MINIMUM_CRUISE_RATIO", "",
                    "limits of the moves that are read from now on"},
    ExtendedCommand{"SET_GCODE_OFFSET", "X Y Z E X_ADJUST Y_ADJUST Z_ADJUST E_ADJUST MOVE MOVE_SPEED", "",
                    "offset of the coordinates; MOVE=1: go there, too"},
    ExtendedCommand{"SAVE_GCODE_STATE", "", "NAME", "keep modes, offsets and speeds"},
    ExtendedCommand{"RESTORE_GCODE_STATE", "MOVE MOVE_SPEED", "NAME",
                    "take them up again; MOVE=1: go back, too"},
    ExtendedCommand{"SET_RETRACTION", "RETRACT_LENGTH RETRACT_SPEED UNRETRACT_EXTRA_LENGTH UNRETRACT_SPEED",
                    "", "what G10 and G11 do"},
};

constexpr std::array kLetters = {
    Letter{"X Y Z", "axes: target in mm, by G90 and G91"},
    Letter{"E", "extruder: mm of filament, by M82, M83 and G91"},
    Letter{"F", "speed of the path in mm/min, also for G0; 1500 before any"},
    Letter{"I J K", "centre of an arc from its start"},
    Letter{"R", "radius of an arc, which Klipper refuses"},
    Letter{"P", "milliseconds of G4; acceleration of M204"},
    Letter{"S T", "acceleration of M204; S: percent of M220 and M221"},
    Letter{"N *", "line number and check sum, which are passed over"},
};

}  // namespace klipper_table

}  // namespace

const Dialect& dialect_klipper() {
    static const Dialect dialect({.name = "klipper",
                                  .title = "Klipper",
                                  .style = lexer::Style::command_lines,
                                  .lua_module = "gsim.klipper",
                                  .initial = " G17 G21 G90 M82 ",
                                  .letters = klipper_table::kLetters,
                                  .extended = klipper_table::kExtended},
                                 klipper_table::kCodes);
    return dialect;
}

}  // namespace gsim::grammar
