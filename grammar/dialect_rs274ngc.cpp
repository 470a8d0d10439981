#include <array>

#include "grammar/dialect.h"
#include "grammar/rows.h"

namespace gsim::grammar {

namespace {

namespace rs274ngc_table {

using enum Group;
using enum Support;
using lexer::ExpressionName;
using lexer::Operator;
using P = Phase;
using A = AxisUse;
using C = Compensation;

// Modal groups, words and order of execution according to the LinuxCNC 2.9 documentation ("G Codes", "M
// Codes", "RS274/NGC Programming Overview: Modal Groups, Order of Execution").
constexpr std::array kFixedCodes = {
    Code{'G', 0, motion, P::motion, A::motion, "", full, "rapid move"},
    Code{'G', 10, motion, P::motion, A::motion, "", full, "linear move"},
    Code{'G', 20, motion, P::motion, A::motion, "IJKRP", full, "arc, clockwise"},
    Code{'G', 30, motion, P::motion, A::motion, "IJKRP", full, "arc, counterclockwise"},
    Code{'G', 40, non_modal, P::dwell, A::none, "P", full, "dwell in seconds"},
    Code{'G', 50, motion, P::motion, A::motion, "IJPQ", full, "cubic spline", C::rejected},
    Code{'G', 51, motion, P::motion, A::motion, "IJ", full, "quadratic spline", C::rejected},
    Code{'G', 52, motion, P::motion, A::motion, "PL", full, "NURBS, control point", C::rejected},
    Code{'G', 53, motion, P::motion, A::none, "", full, "NURBS, end"},
    Code{'G', 70, lathe_diameter, P::compensation, A::none, "", full, "lathe diameter mode"},
    Code{'G', 80, lathe_diameter, P::compensation, A::none, "", full, "lathe radius mode"},
    Code{'G', 100, non_modal, P::data, A::data, "LPRIJQ", full, "coordinate and tool data"},
    Code{'G', 170, plane, P::plane, A::none, "", full, "XY plane"},
    Code{'G', 180, plane, P::plane, A::none, "", full, "ZX plane"},
    Code{'G', 190, plane, P::plane, A::none, "", full, "YZ plane"},
    Code{'G', 171, plane, P::plane, A::none, "", planned, "UV plane"},
    Code{'G', 181, plane, P::plane, A::none, "", planned, "WU plane"},
    Code{'G', 191, plane, P::plane, A::none, "", planned, "VW plane"},
    Code{'G', 200, units, P::units, A::none, "", full, "inches"},
    Code{'G', 210, units, P::units, A::none, "", full, "millimetres"},
    Code{'G', 280, non_modal, P::data, A::data, "", full, "move to the first predefined position",
         C::rejected},
    Code{'G', 281, non_modal, P::data, A::none, "", full, "set the first predefined position", C::rejected},
    Code{'G', 300, non_modal, P::data, A::data, "", full, "move to the second predefined position",
         C::rejected},
    Code{'G', 301, non_modal, P::data, A::none, "", full, "set the second predefined position", C::rejected},
    Code{'G', 330, motion, P::motion, A::motion, "K$", full, "spindle-synchronised move",
         C::refused_next_to_path},
    Code{'G', 331, motion, P::motion, A::motion, "KI$", full, "rigid tapping", C::refused_next_to_path},
    Code{'G', 382, motion, P::motion, A::motion, "", full, "probe toward, alarm on failure", C::rejected},
    Code{'G', 383, motion, P::motion, A::motion, "", full, "probe toward", C::rejected},
    Code{'G', 384, motion, P::motion, A::motion, "", full, "probe away, alarm on failure", C::rejected},
    Code{'G', 385, motion, P::motion, A::motion, "", full, "probe away", C::rejected},
    Code{'G', 400, cutter_compensation, P::compensation, A::none, "", full, "cutter compensation off"},
    Code{'G', 410, cutter_compensation, P::compensation, A::none, "D", full, "cutter compensation, left"},
    Code{'G', 420, cutter_compensation, P::compensation, A::none, "D", full, "cutter compensation, right"},
    Code{'G', 411, cutter_compensation, P::compensation, A::none, "DL", full,
         "cutter compensation, left, by diameter"},
    Code{'G', 421, cutter_compensation, P::compensation, A::none, "DL", full,
         "cutter compensation, right, by diameter"},
    Code{'G', 430, Group::tool_length, P::tool_length, A::none, "H", full, "tool length offset", C::rejected},
    Code{'G', 431, Group::tool_length, P::tool_length, A::data, "", full, "tool offset with given values",
         C::rejected},
    Code{'G', 432, Group::tool_length, P::tool_length, A::data, "H", full, "additional tool offset",
         C::rejected},
    Code{'G', 434, Group::tool_length, P::tool_length, A::none, "H", full, "tool-centre-point control",
         C::rejected},
    Code{'G', 490, Group::tool_length, P::tool_length, A::none, "", full, "tool length offset off",
         C::rejected},
    Code{'G', 520, non_modal, P::data, A::data, "", full, "local coordinate system offset", C::rejected},
    Code{'G', 530, non_modal, P::one_shot, A::none, "", full, "move in machine coordinates, in this block",
         C::rejected},
    Code{'G', 540, Group::work_frame, P::work_frame, A::none, "", full, "coordinate system 1", C::rejected},
    Code{'G', 550, Group::work_frame, P::work_frame, A::none, "", full, "coordinate system 2", C::rejected},
    Code{'G', 560, Group::work_frame, P::work_frame, A::none, "", full, "coordinate system 3", C::rejected},
    Code{'G', 570, Group::work_frame, P::work_frame, A::none, "", full, "coordinate system 4", C::rejected},
    Code{'G', 580, Group::work_frame, P::work_frame, A::none, "", full, "coordinate system 5", C::rejected},
    Code{'G', 590, Group::work_frame, P::work_frame, A::none, "", full, "coordinate system 6", C::rejected},
    Code{'G', 591, Group::work_frame, P::work_frame, A::none, "", full, "coordinate system 7", C::rejected},
    Code{'G', 592, Group::work_frame, P::work_frame, A::none, "", full, "coordinate system 8", C::rejected},
    Code{'G', 593, Group::work_frame, P::work_frame, A::none, "", full, "coordinate system 9", C::rejected},
    Code{'G', 610, Group::path_mode, P::path_mode, A::none, "", full, "exact path mode", C::rejected},
    Code{'G', 611, Group::path_mode, P::path_mode, A::none, "", full, "exact stop mode", C::rejected},
    Code{'G', 640, Group::path_mode, P::path_mode, A::none, "PQ", full, "blending within a tolerance",
         C::rejected},
    Code{'G', 700, motion, P::motion, A::none, "", planned, "lathe finishing cycle"},
    Code{'G', 710, motion, P::motion, A::none, "", planned, "lathe roughing cycle"},
    Code{'G', 711, motion, P::motion, A::none, "", planned, "lathe roughing cycle with pockets"},
    Code{'G', 712, motion, P::motion, A::none, "", planned, "lathe roughing cycle with pockets"},
    Code{'G', 720, motion, P::motion, A::none, "", planned, "lathe facing cycle"},
    Code{'G', 721, motion, P::motion, A::none, "", planned, "lathe facing cycle with pockets"},
    Code{'G', 722, motion, P::motion, A::none, "", planned, "lathe facing cycle with pockets"},
    Code{'G', 730, motion, P::motion, A::motion, "LQR", full, "drilling with chip breaking", C::rejected},
    Code{'G', 740, motion, P::motion, A::motion, "LPR$", full, "left-hand tapping", C::rejected},
    Code{'G', 760, motion, P::motion, A::motion, "EHIJKLPQR$", full, "threading cycle", C::rejected},
    Code{'G', 800, Group::cycle, P::cycle, A::none, "", full, "end of the modal motion"},
    Code{'G', 810, motion, P::motion, A::motion, "LR", full, "drilling", C::rejected},
    Code{'G', 820, motion, P::motion, A::motion, "LPR", full, "drilling with dwell", C::rejected},
    Code{'G', 830, motion, P::motion, A::motion, "LQR", full, "peck drilling", C::rejected},
    Code{'G', 840, motion, P::motion, A::motion, "LPR$", full, "right-hand tapping", C::rejected},
    Code{'G', 850, motion, P::motion, A::motion, "LR", full, "boring, retract at feed", C::rejected},
    Code{'G', 860, motion, P::motion, A::motion, "LPR$", full, "boring, spindle stop, retract at rapid",
         C::rejected},
    Code{'G', 870, motion, P::motion, A::motion, "IJKLR", full, "back boring", C::rejected},
    Code{'G', 880, motion, P::motion, A::motion, "LPR", full, "boring, spindle stop, manual retract",
         C::rejected},
    Code{'G', 890, motion, P::motion, A::motion, "LPR", full, "boring with dwell, retract at feed",
         C::rejected},
    Code{'G', 900, Group::distance, P::distance, A::none, "", full, "absolute dimensions"},
    Code{'G', 910, Group::distance, P::distance, A::none, "", full, "incremental dimensions"},
    Code{'G', 901, arc_distance, P::distance, A::none, "", full, "arc centres absolute"},
    Code{'G', 911, arc_distance, P::distance, A::none, "", full, "arc centres from the start"},
    Code{'G', 920, non_modal, P::data, A::data, "", full, "coordinate system offset", C::rejected},
    Code{'G', 921, non_modal, P::data, A::none, "", full, "offset off, and its values 0"},
    Code{'G', 922, non_modal, P::data, A::none, "", full, "offset off, its values kept"},
    Code{'G', 923, non_modal, P::data, A::none, "", full, "offset on again"},
    Code{'G', 930, Group::feed_mode, P::feed_mode, A::none, "", full, "inverse time feed"},
    Code{'G', 940, Group::feed_mode, P::feed_mode, A::none, "", full, "feed per minute"},
    Code{'G', 950, Group::feed_mode, P::feed_mode, A::none, "", full, "feed per revolution"},
    Code{'G', 960, spindle_mode, P::feed_mode, A::none, "D$", full, "constant surface speed"},
    Code{'G', 970, spindle_mode, P::feed_mode, A::none, "$", full, "spindle speed in revolutions per minute"},
    Code{'G', 980, return_level, P::cycle, A::none, "", full, "cycles return to the initial level",
         C::rejected},
    Code{'G', 990, return_level, P::cycle, A::none, "", full, "cycles return to the R level", C::rejected},
    Code{'M', 0, stop, P::flow, A::none, "", full, "program stop", C::ends_move},
    Code{'M', 10, stop, P::flow, A::none, "", full, "optional program stop", C::ends_move},
    Code{'M', 20, stop, P::flow, A::none, "", full, "program end"},
    Code{'M', 30, spindle, P::switch_on, A::none, "$", full, "spindle on, clockwise"},
    Code{'M', 40, spindle, P::switch_on, A::none, "$", full, "spindle on, counterclockwise"},
    Code{'M', 50, spindle, P::switch_on, A::none, "$", full, "spindle off"},
    Code{'M', 60, Group::tool_change, P::tool_change, A::none, "", full, "tool change", C::rejected},
    Code{'M', 70, coolant, P::switch_off, A::none, "", full, "mist on"},
    Code{'M', 80, coolant, P::switch_off, A::none, "", full, "flood on"},
    Code{'M', 90, coolant, P::switch_off, A::none, "", full, "mist and flood off"},
    Code{'M', 190, spindle, P::switch_on, A::none, "PQR$", full, "spindle orientation"},
    Code{'M', 300, stop, P::flow, A::none, "", full, "program end, pallet change"},
    Code{'M', 480, override_switch, P::pause, A::none, "", full, "overrides on", C::rejected},
    Code{'M', 490, override_switch, P::pause, A::none, "", full, "overrides off", C::rejected},
    Code{'M', 500, override_switch, P::pause, A::none, "P", full, "feed override", C::rejected},
    Code{'M', 510, override_switch, P::pause, A::none, "P$", full, "spindle speed override", C::rejected},
    Code{'M', 520, override_switch, P::pause, A::none, "P", full, "adaptive feed", C::rejected},
    Code{'M', 530, override_switch, P::pause, A::none, "P", full, "feed stop", C::rejected},
    Code{'M', 600, stop, P::flow, A::none, "", full, "program stop, pallet change", C::ends_move},
    Code{'M', 610, Group::tool_change, P::tool_change, A::none, "Q", full,
         "number of the tool in the spindle"},
    Code{'M', 620, Group::input_output, P::input_output, A::none, "P", full, "output on, with the next move",
         C::rejected},
    Code{'M', 630, Group::input_output, P::input_output, A::none, "P", full, "output off, with the next move",
         C::rejected},
    Code{'M', 640, Group::input_output, P::input_output, A::none, "P", full, "output on", C::rejected},
    Code{'M', 650, Group::input_output, P::input_output, A::none, "P", full, "output off", C::rejected},
    Code{'M', 660, Group::input_output, P::input_output, A::none, "ELPQ", full, "wait for an input",
         C::rejected},
    Code{'M', 670, Group::input_output, P::input_output, A::none, "EQ", full,
         "analog output, with the next move", C::rejected},
    Code{'M', 680, Group::input_output, P::input_output, A::none, "EQ", full, "analog output", C::rejected},
    Code{'M', 700, modal_state, P::input_output, A::none, "", full, "save the modal state"},
    Code{'M', 710, modal_state, P::input_output, A::none, "", full, "invalidate the saved modal state"},
    Code{'M', 720, modal_state, P::input_output, A::none, "", full, "restore the modal state"},
    Code{'M', 730, modal_state, P::input_output, A::none, "", full,
         "save the modal state, restore it at the end of the subroutine"},
    Code{'M', 980, subprogram, P::flow, A::none, "PL", full, "call of a numbered program"},
    Code{'M', 990, subprogram, P::flow, A::none, "", full, "return from a numbered program"},
};

constexpr int kFirstUserCode = 100;
constexpr int kLastUserCode = 199;

constexpr auto make_codes() {
    std::array<Code, kFixedCodes.size() + (kLastUserCode - kFirstUserCode + 1)> codes{};
    std::size_t row = 0;
    for (const Code& code : kFixedCodes) codes[row++] = code;
    for (int number = kFirstUserCode; number <= kLastUserCode; ++number)
        codes[row++] = Code{'M', number * 10, user, P::pause, A::none, "PQ", full, "user code"};
    return codes;
}

constexpr auto kCodes = make_codes();

constexpr std::array kLetters = {
    Letter{"A B C U V W X Y Z", "axes: target in mm, inch or deg (by G20, G21, G90, G91)"},
    Letter{"@ ^", "target in polar form: radius and angle"},
    Letter{"I J K",
           "centre of an arc from its start (G91.1) or as a point (G90.1); control points of splines"},
    Letter{"R", "radius of an arc; level of cycles; rotation of G10 L2"},
    Letter{"P", "turns of an arc; seconds; system or tool of G10; tolerance of G64; weight of a NURBS point"},
    Letter{"Q", "peck; tolerance of G64; tool of M61; value of M66 to M68"},
    Letter{"L", "repeats; kind of data of G10; order of a NURBS"},
    Letter{"F", "feed in units/min, 1/min (G93) or units/rev (G95)"},
    Letter{"S $", "spindle speed in rev/min; number of the spindle"},
    Letter{"T", "tool"},
    Letter{"D H", "tool whose diameter or length is used; D: diameter of G41.1 and G42.1"},
    Letter{"E", "taper of G76; input of M66; output of M67 and M68"},
    Letter{"N O /", "block number, O-word, block delete"},
};

constexpr std::array kOrder = {
    P::feed_mode,    P::feed,        P::spindle_speed, P::tool,      P::input_output, P::tool_change,
    P::switch_on,    P::switch_off,  P::pause,         P::dwell,     P::plane,        P::units,
    P::compensation, P::tool_length, P::work_frame,    P::path_mode, P::distance,     P::cycle,
    P::data,         P::one_shot,    P::motion,        P::flow,
};

// Functions and operators that differ from those of the 9/Series.
constexpr std::array kExpressionNames = {
    ExpressionName{"EQ", lexer::kRelation, Operator::near_equal, "equal within 0.0001"},
    ExpressionName{"NE", lexer::kRelation, Operator::not_near_equal, "not equal within 0.0001"},
    ExpressionName{"AND", lexer::kLogicWord, Operator::bit_and, "logical and: 1 or 0"},
    ExpressionName{"OR", lexer::kLogicWord, Operator::bit_or, "logical or: 1 or 0"},
    ExpressionName{"XOR", lexer::kLogicWord, Operator::bit_xor, "logical exclusive or: 1 or 0"},
    ExpressionName{"EXISTS", lexer::kExists, Operator::exists,
                   "1 if the parameter exists (a named one: if it has a value), else 0"},
};

std::vector<ExpressionName> expression_names() {
    std::vector<ExpressionName> names = dialect_ab9().rules().expression_names;
    set_rows(names, kExpressionNames);
    remove_rows(names, {"SQR", "RND", "BIN", "BCD"});
    return names;
}

}  // namespace rs274ngc_table

}  // namespace

const Dialect& dialect_rs274ngc() {
    using namespace rs274ngc_table;
    static const Dialect dialect(
        DialectRules{.name = "rs274ngc",
                     .title = "RS274/NGC",
                     .lua_module = "gsim.rs274ngc",
                     .text = {.controller = "RS274/NGC",
                              .blanks_within_words = true,
                              .has_o_words = true,
                              .names_in_angle_brackets = true,
                              .has_power_operator = true,
                              .chained_comparisons = true,
                              .unbracketed_variable_index = true,
                              .tape_marks_end_program = true,
                              .missing_keywords_hint =
                                  "; IF, WHILE, GOTO and END belong to the 9/Series, see --dialect ab9"},
                     .blocks = {.standalone = "FST",
                                .move_words = "IJKRPLQEHD",
                                .dwell_words = "P",
                                .values_before_actions = true,
                                .computed_codes = true,
                                .data_excludes_motion = true,
                                .shared_words = true,
                                .separate_calls = true,
                                .order = kOrder},
                     .initial = " G8 G17 G21 G40 G49 G54 G64 G80 G90 G91.1 G94 G97 G99 M5 M9 M48 ",
                     .active_comments = true,
                     .first_program_counts = true,
                     .end_code_ends_text = true,
                     .offset_variables = true,
                     .codes = {kCodes.begin(), kCodes.end()},
                     .letters = {kLetters.begin(), kLetters.end()},
                     .expression_names = expression_names()});
    return dialect;
}

}  // namespace gsim::grammar
