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
    Code{'G', 0, motion, P::motion, A::motion, "EF", full, "linear move, like G1"},
    Code{'G', 10, motion, P::motion, A::motion, "EF", full, "linear move"},
    Code{'G', 20, motion, P::motion, A::motion, "IJKREF", full, "arc, clockwise, as chords"},
    Code{'G', 30, motion, P::motion, A::motion, "IJKREF", full, "arc, counterclockwise, as chords"},
    Code{'G', 40, non_modal, P::dwell, A::none, "P", full, "dwell in milliseconds"},
    Code{'G', 100, non_modal, P::data, A::none, "", full, "retract the filament"},
    Code{'G', 110, non_modal, P::data, A::none, "", full, "undo the retraction of G10"},
    Code{'G', 170, plane, P::plane, A::none, "", full, "XY plane"},
    Code{'G', 180, plane, P::plane, A::none, "", full, "XZ plane"},
    Code{'G', 190, plane, P::plane, A::none, "", full, "YZ plane"},
    Code{'G', 200, units, P::units, A::none, "", full, "inches; the program ends"},
    Code{'G', 210, units, P::units, A::none, "", full, "millimetres"},
    Code{'G', 280, non_modal, P::data, A::data, "", planned, "homing"},
    Code{'G', 900, Group::distance, P::distance, A::none, "", full, "absolute dimensions"},
    Code{'G', 910, Group::distance, P::distance, A::none, "", full, "incremental dimensions"},
    Code{'G', 920, non_modal, P::data, A::data, "E", full, "set the current position to these values"},
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
    Code{'M', 4000, non_modal, P::flow, A::none, "", full, "wait until all moves are finished"},
};

constexpr std::array kExtended = {
    ExtendedCommand{"SET_VELOCITY_LIMIT", "VELOCITY ACCEL SQUARE_CORNER_VELOCITY MINIMUM_CRUISE_RATIO", "",
                    "limits of the following moves"},
    ExtendedCommand{"SET_GCODE_OFFSET", "X Y Z E X_ADJUST Y_ADJUST Z_ADJUST E_ADJUST MOVE MOVE_SPEED", "",
                    "offset of the coordinates; MOVE=1: also move there"},
    ExtendedCommand{"SAVE_GCODE_STATE", "", "NAME", "save modes, offsets and speeds"},
    ExtendedCommand{"RESTORE_GCODE_STATE", "MOVE MOVE_SPEED", "NAME", "restore them; MOVE=1: also move back"},
    ExtendedCommand{"SET_RETRACTION", "RETRACT_LENGTH RETRACT_SPEED UNRETRACT_EXTRA_LENGTH UNRETRACT_SPEED",
                    "", "parameters of G10 and G11"},
};

constexpr std::array kLetters = {
    Letter{"X Y Z", "axes: target in mm, by G90 and G91"},
    Letter{"E", "extruder: mm of filament, by M82, M83 and G91"},
    Letter{"F", "speed of the path in mm/min, also for G0; default: 1500"},
    Letter{"I J K", "centre of an arc from its start"},
    Letter{"R", "radius of an arc, which Klipper rejects"},
    Letter{"P", "milliseconds of G4; acceleration of M204"},
    Letter{"S T", "acceleration of M204; S: percent of M220 and M221"},
    Letter{"N *", "line number and checksum, which are ignored"},
};

}  // namespace klipper_table

}  // namespace

const Dialect& dialect_klipper() {
    using namespace klipper_table;
    static const Dialect dialect(DialectRules{.name = "klipper",
                                              .title = "Klipper",
                                              .lua_module = "gsim.klipper",
                                              .text = {.form = lexer::TextForm::command_lines},
                                              .initial = " G17 G21 G90 M82 ",
                                              .always_mm = true,
                                              .codes = {kCodes.begin(), kCodes.end()},
                                              .letters = {kLetters.begin(), kLetters.end()},
                                              .extended = {kExtended.begin(), kExtended.end()}});
    return dialect;
}

}  // namespace gsim::grammar
