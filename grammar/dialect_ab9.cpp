#include <array>

#include "grammar/dialect.h"

namespace gsim::grammar {

namespace {

namespace ab9_table {

using enum Group;
using enum Support;
using lexer::ExpressionName;
using lexer::Operator;
using P = Phase;
using A = AxisUse;
using C = Compensation;

// One row per code; its meaning is implemented in lua_lib/. The groups follow the 9/Series, which has G00 and
// G80 in two.
constexpr std::array kFixedCodes = {
    Code{'G', 0, motion, P::motion, A::motion, "", full, "rapid positioning"},
    Code{'G', 10, motion, P::motion, A::motion, ",", full, "linear interpolation"},
    Code{'G', 20, motion, P::motion, A::motion, "IJKR=,", full, "circular interpolation, clockwise"},
    Code{'G', 30, motion, P::motion, A::motion, "IJKR=,", full, "circular interpolation, counterclockwise"},
    Code{'G', 40, none, P::dwell, A::none, "PXU", full, "dwell in seconds"},
    Code{'G', 90, none, P::one_shot, A::none, "", full, "exact stop, in this block"},
    Code{'G', 100, none, P::data, A::data, "LPR", full, "data setting", C::rejected},
    Code{'G', 110, none, P::data, A::none, "", full, "end of data setting"},
    Code{'G', 120, none, P::data, A::none, "", planned, "data setting"},
    Code{'G', 140, scaling, P::data, A::data, "PIJK", full, "scaling"},
    Code{'G', 141, scaling, P::data, A::data, "PIJK", full, "scaling"},
    Code{'G', 150, polar, P::polar, A::none, "", full, "polar programming off"},
    Code{'G', 160, polar, P::polar, A::none, "", full, "polar programming on"},
    Code{'G', 170, plane, P::plane, A::none, "", full, "XY plane"},
    Code{'G', 180, plane, P::plane, A::none, "", full, "ZX plane"},
    Code{'G', 190, plane, P::plane, A::none, "", full, "YZ plane"},
    Code{'G', 391, none, P::motion, A::none, "", full, "corner arc, circular"},
    Code{'G', 200, units, P::units, A::none, "", full, "inch mode"},
    Code{'G', 210, units, P::units, A::none, "", full, "metric mode"},
    Code{'G', 220, zone, P::data, A::data, "IJKP", full, "programmable zone on"},
    Code{'G', 230, zone, P::data, A::none, "P", full, "programmable zone off"},
    Code{'G', 270, none, P::motion, A::data, "", full, "machine home check", C::rejected},
    Code{'G', 280, none, P::motion, A::data, "", full, "return to machine home", C::rejected},
    Code{'G', 290, none, P::motion, A::data, "", full, "return from machine home", C::rejected},
    Code{'G', 300, none, P::motion, A::data, "P", full, "return to a secondary home position", C::rejected},
    Code{'G', 310, none, P::motion, A::data, "", full, "skip", C::rejected},
    Code{'G', 330, motion, P::motion, A::motion, "EF", full, "thread cutting"},
    Code{'G', 390, none, P::motion, A::none, "", full, "corner arc"},
    Code{'G', 400, cutter_compensation, P::compensation, A::none, "", full, "cutter compensation off"},
    Code{'G', 410, cutter_compensation, P::compensation, A::none, "D", full, "cutter compensation, left"},
    Code{'G', 420, cutter_compensation, P::compensation, A::none, "D", full, "cutter compensation, right"},
    Code{'G', 430, Group::tool_length, P::tool_length, A::none, "H", full, "tool length offset, plus"},
    Code{'G', 434, Group::tool_length, P::tool_length, A::none, "H", full, "TCP control", C::rejected},
    Code{'G', 440, Group::tool_length, P::tool_length, A::none, "H", full, "tool length offset, minus"},
    Code{'G', 470, acceleration, P::path_mode, A::none, "", full, "linear acceleration mode"},
    Code{'G', 471, acceleration, P::path_mode, A::none, "", full, "S-curve acceleration mode"},
    Code{'G', 479, acceleration, P::path_mode, A::none, "", full, "acceleration without limits"},
    Code{'G', 480, none, P::data, A::none, "", full, "ramps of the machine"},
    Code{'G', 481, none, P::data, A::data, "", full, "acceleration of ramps"},
    Code{'G', 482, none, P::data, A::data, "", full, "deceleration of ramps"},
    Code{'G', 483, none, P::data, A::data, "", full, "jerk of ramps"},
    Code{'G', 490, Group::tool_length, P::tool_length, A::none, "", full, "tool length offset off"},
    Code{'G', 500, none, P::data, A::none, "S", full, "spindle speed limit"},
    Code{'G', 501, mirror, P::data, A::data, "", full, "mirror image off"},
    Code{'G', 511, mirror, P::data, A::data, "", full, "mirror image on"},
    Code{'G', 520, none, P::data, A::data, "", full, "offset of the coordinate zero point",
         C::lead_out_and_in},
    Code{'G', 530, none, P::one_shot, A::none, "", full,
         "motion in the machine coordinate system, in this block"},
    Code{'G', 540, Group::work_frame, P::work_frame, A::none, "", full, "work coordinate system 1",
         C::lead_out_and_in},
    Code{'G', 550, Group::work_frame, P::work_frame, A::none, "", full, "work coordinate system 2",
         C::lead_out_and_in},
    Code{'G', 560, Group::work_frame, P::work_frame, A::none, "", full, "work coordinate system 3",
         C::lead_out_and_in},
    Code{'G', 570, Group::work_frame, P::work_frame, A::none, "", full, "work coordinate system 4",
         C::lead_out_and_in},
    Code{'G', 580, Group::work_frame, P::work_frame, A::none, "", full, "work coordinate system 5",
         C::lead_out_and_in},
    Code{'G', 590, Group::work_frame, P::work_frame, A::none, "", full, "work coordinate system 6",
         C::lead_out_and_in},
    Code{'G', 591, Group::work_frame, P::work_frame, A::none, "", full, "work coordinate system 7",
         C::lead_out_and_in},
    Code{'G', 592, Group::work_frame, P::work_frame, A::none, "", full, "work coordinate system 8",
         C::lead_out_and_in},
    Code{'G', 593, Group::work_frame, P::work_frame, A::none, "", full, "work coordinate system 9",
         C::lead_out_and_in},
    Code{'G', 610, Group::path_mode, P::path_mode, A::none, "", full, "exact stop mode"},
    Code{'G', 620, Group::path_mode, P::path_mode, A::none, "", full, "automatic corner override"},
    Code{'G', 630, Group::path_mode, P::path_mode, A::none, "", full, "tapping mode"},
    Code{'G', 640, Group::path_mode, P::path_mode, A::none, "", full, "cutting mode"},
    Code{'G', 650, none, P::flow, A::data, "DEFHIJKLPQRST*", full, "macro call"},
    Code{'G', 660, macro, P::flow, A::data, "DEFHIJKLPQRST*", full, "modal macro call"},
    Code{'G', 661, macro, P::flow, A::data, "DEFHIJKLPQRST*", full, "modal macro call"},
    Code{'G', 670, macro, P::flow, A::none, "", full, "modal macro call off"},
    Code{'G', 680, rotation, P::data, A::data, "R", full, "part rotation"},
    Code{'G', 690, rotation, P::data, A::none, "", full, "part rotation off"},
    Code{'G', 730, Group::cycle, P::motion, A::motion, "KLPQR", full, "deep hole drilling with dwell",
         C::rejected},
    Code{'G', 740, Group::cycle, P::motion, A::motion, "KLPR", full, "left-hand tapping cycle", C::rejected},
    Code{'G', 760, Group::cycle, P::motion, A::motion, "IJKLPQR", full, "boring cycle, spindle shift",
         C::rejected},
    Code{'G', 800, Group::cycle, P::cycle, A::none, "", full, "canned cycle off"},
    Code{'G', 810, Group::cycle, P::motion, A::motion, "KLR", full, "drilling cycle", C::rejected},
    Code{'G', 820, Group::cycle, P::motion, A::motion, "KLPR", full, "drilling cycle with dwell",
         C::rejected},
    Code{'G', 830, Group::cycle, P::motion, A::motion, "KLPQR", full, "deep hole drilling cycle",
         C::rejected},
    Code{'G', 840, Group::cycle, P::motion, A::motion, "KLPR", full, "right-hand tapping cycle", C::rejected},
    Code{'G', 850, Group::cycle, P::motion, A::motion, "KLR", full, "boring cycle", C::rejected},
    Code{'G', 860, Group::cycle, P::motion, A::motion, "KLPR", full, "boring cycle, spindle stop",
         C::rejected},
    Code{'G', 870, Group::cycle, P::motion, A::motion, "IJKLPQR", full, "back boring cycle", C::rejected},
    Code{'G', 880, Group::cycle, P::motion, A::motion, "KLPR", full, "boring cycle, manual return",
         C::rejected},
    Code{'G', 890, Group::cycle, P::motion, A::motion, "KLPR", full, "boring cycle with dwell", C::rejected},
    Code{'G', 900, Group::distance, P::distance, A::none, "", full, "absolute dimensions"},
    Code{'G', 910, Group::distance, P::distance, A::none, "", full, "incremental dimensions"},
    Code{'G', 920, none, P::data, A::data, "", full, "coordinate system offset", C::lead_out_and_in},
    Code{'G', 921, none, P::data, A::none, "", full, "coordinate system offset off", C::lead_out_and_in},
    Code{'G', 930, Group::feed_mode, P::feed_mode, A::none, "", full, "inverse time feed"},
    Code{'G', 940, Group::feed_mode, P::feed_mode, A::none, "", full, "feed per minute"},
    Code{'G', 950, Group::feed_mode, P::feed_mode, A::none, "", full, "feed per revolution"},
    Code{'G', 960, spindle_mode, P::feed_mode, A::none, "", full, "constant surface speed"},
    Code{'G', 970, spindle_mode, P::feed_mode, A::none, "", full, "spindle speed in revolutions per minute"},
    Code{'G', 980, return_level, P::cycle, A::none, "", full, "cycles return to the initial level"},
    Code{'G', 990, return_level, P::cycle, A::none, "", full, "cycles return to the R level"},
    Code{'M', 0, stop, P::pause, A::none, "", full, "program stop"},
    Code{'M', 10, stop, P::pause, A::none, "", full, "conditional program stop"},
    Code{'M', 20, stop, P::flow, A::none, "", full, "program end"},
    Code{'M', 30, spindle, P::switch_on, A::none, "", full, "spindle on, clockwise"},
    Code{'M', 40, spindle, P::switch_on, A::none, "", full, "spindle on, counterclockwise"},
    Code{'M', 50, spindle, P::spindle_stop, A::none, "", full, "spindle off"},
    Code{'M', 60, Group::tool_change, P::tool_change, A::none, "", full, "tool change"},
    Code{'M', 70, jet, P::switch_on, A::none, "", full, "coolant 2 on"},
    Code{'M', 80, jet, P::switch_on, A::none, "", full, "pressurized water on"},
    Code{'M', 90, jet, P::switch_off, A::none, "", full, "pressurized water off"},
    Code{'M', 100, abrasive, P::switch_on, A::none, "", full, "abrasive on"},
    Code{'M', 110, abrasive, P::switch_off, A::none, "", full, "abrasive off"},
    Code{'M', 190, spindle, P::spindle_stop, A::none, "", full, "spindle orientation"},
    Code{'M', 300, stop, P::flow, A::none, "", full, "program end and rewind"},
    Code{'M', 480, override_switch, P::feed_mode, A::none, "", full, "overrides on"},
    Code{'M', 490, override_switch, P::feed_mode, A::none, "", full, "overrides off"},
    Code{'M', 980, subprogram, P::flow, A::none, "PL", full, "subprogram call"},
    Code{'M', 990, subprogram, P::flow, A::none, "P", full, "return from a subprogram"},
};

constexpr int kFirstFrame = 505;
constexpr int kLastFrame = 599;

constexpr int kFirstUserCode = 100;
constexpr int kLastUserCode = 999;

constexpr auto make_codes() {
    std::array<Code,
               kFixedCodes.size() + (kLastFrame - kFirstFrame + 1) + (kLastUserCode - kFirstUserCode + 1)>
        codes{};
    std::size_t row = 0;
    for (const Code& code : kFixedCodes) codes[row++] = code;
    for (int frame = kFirstFrame; frame <= kLastFrame; ++frame) {
        codes[row++] = Code{'G', frame * 10, Group::work_frame, P::work_frame,     A::none,
                            "",  full,       "settable frame",  C::lead_out_and_in};
    }
    for (int number = kFirstUserCode; number <= kLastUserCode; ++number)
        codes[row++] = Code{'M', number * 10, user, P::switch_on, A::none, "DEHIJKLPQR", full, "user code"};
    return codes;
}

constexpr auto kCodes = make_codes();

constexpr std::array kLetters = {
    Letter{"A B C X Y Z", "axes: target in mm, inch or deg (by G20, G21, G90, G91)"},
    Letter{"U V W",
           "separate axes, or increments of X, Y and Z if the machine does not have these axes; U: seconds "
           "of G04"},
    Letter{"I J K", "centre of an arc from its start; data of cycles, scaling and zones"},
    Letter{"I1= J1= K1=", "intermediate point of CIP"},
    Letter{"R", "radius of an arc; level of cycles; angle of G68"},
    Letter{"AR=", "angle of an arc in deg"},
    Letter{",C ,R ,A", "chamfer, corner radius, angle of a line"},
    Letter{"F", "feed in units/min, 1/min (G93) or units/rev (G95)"},
    Letter{"S", "spindle speed in rev/min, or surface speed (G96)"},
    Letter{"T", "tool"},
    Letter{"D H", "numbers of tool radius and length offsets"},
    Letter{"P", "seconds of G04, program of M98, block of M99, parameter of other codes"},
    Letter{"L", "repeats; kind of data of G10"},
    Letter{"Q", "peck or shift of cycles"},
    Letter{"N O /", "block number, program, block delete /1 to /9"},
};

constexpr std::array kExpressionNames = {
    ExpressionName{"EQ", lexer::kRelation, Operator::equal, "equal"},
    ExpressionName{"NE", lexer::kRelation, Operator::not_equal, "not equal"},
    ExpressionName{"GT", lexer::kRelation, Operator::greater, "greater"},
    ExpressionName{"GE", lexer::kRelation, Operator::greater_equal, "greater or equal"},
    ExpressionName{"LT", lexer::kRelation, Operator::less, "less"},
    ExpressionName{"LE", lexer::kRelation, Operator::less_equal, "less or equal"},
    ExpressionName{"AND", lexer::kProductWord, Operator::bit_and,
                   "bitwise and of integers; logical and of conditions"},
    ExpressionName{"OR", lexer::kSumWord, Operator::bit_or,
                   "bitwise or of integers; logical or of conditions"},
    ExpressionName{"XOR", lexer::kSumWord, Operator::bit_xor,
                   "bitwise exclusive or of integers; logical exclusive or of conditions"},
    ExpressionName{"MOD", lexer::kProductWord, Operator::modulo,
                   "remainder (9/Series: with the sign of the divisor; RS274/NGC: not negative)"},
    ExpressionName{"SIN", lexer::kFunction, Operator::sin, "sine of degrees"},
    ExpressionName{"COS", lexer::kFunction, Operator::cos, "cosine of degrees"},
    ExpressionName{"TAN", lexer::kFunction, Operator::tan, "tangent of degrees"},
    ExpressionName{"ASIN", lexer::kFunction, Operator::asin, "arc sine in degrees"},
    ExpressionName{"ACOS", lexer::kFunction, Operator::acos, "arc cosine in degrees"},
    ExpressionName{"ATAN", lexer::kAtan, Operator::atan, "angle in degrees; ATAN[a]/[b] of the point (b, a)"},
    ExpressionName{"SQRT", lexer::kFunction, Operator::sqrt, "square root"},
    ExpressionName{"SQR", lexer::kFunction, Operator::sqrt, "square root"},
    ExpressionName{"ABS", lexer::kFunction, Operator::abs, "absolute value"},
    ExpressionName{"ROUND", lexer::kFunction, Operator::round, "nearest integer"},
    ExpressionName{"RND", lexer::kFunction, Operator::round, "nearest integer"},
    ExpressionName{"FIX", lexer::kFunction, Operator::fix, "integer towards 0 (RS274/NGC: downwards)"},
    ExpressionName{"FUP", lexer::kFunction, Operator::fup, "integer away from 0 (RS274/NGC: upwards)"},
    ExpressionName{"LN", lexer::kFunction, Operator::ln, "natural logarithm"},
    ExpressionName{"EXP", lexer::kFunction, Operator::exp, "power of e"},
    ExpressionName{"BIN", lexer::kFunction, Operator::bin, "value of a binary-coded decimal"},
    ExpressionName{"BCD", lexer::kFunction, Operator::bcd, "binary-coded decimal of a value"},
};

}  // namespace ab9_table

}  // namespace

const Dialect& dialect_ab9() {
    using namespace ab9_table;
    static const Dialect dialect(
        DialectRules{.name = "ab9",
                     .title = "Allen-Bradley 9/Series",
                     .lua_module = "gsim",
                     .text = {.controller = "the 9/Series",
                              .separate_assignments = true,
                              .ambiguous_words = true,
                              .brackets_in_comments = true,
                              .tape_leader = true},
                     .blocks = {.standalone = "FSTDH", .move_words = "IJKR=1PLQ,", .dwell_words = "PXU"},
                     .initial = " G0 G17 G21 G40 G49 G54 G67 G69 G80 G90 G94 G97 G98 ",
                     .has_block_jumps = true,
                     .codes = {kCodes.begin(), kCodes.end()},
                     .letters = {kLetters.begin(), kLetters.end()},
                     .expression_names = {kExpressionNames.begin(), kExpressionNames.end()}});
    return dialect;
}

}  // namespace gsim::grammar
