// The part of the generator that writes modes, offsets, tools and switches.

#include <fmt/format.h>

#include "tests/conformance/generator/ngc_generator.h"

namespace gsim::conformance {

namespace {

std::string without_turns(const std::string& arc) {
    return arc.substr(0, arc.find(" P"));
}

}  // namespace

/// A bare G94 or G95 drops F, so that F is in its block or after it.
void NgcGenerator::feed_mode() {
    switch (random_.below(4)) {
        case 0:
            line("G93");
            inverse_time_ = true;
            per_turn_ = false;
            motion_ = Motion::other;
            return;
        case 1:
            line("S600 M3");
            line(fmt::format("G95 F{}", random_.decimal(1, 3)));
            inverse_time_ = false;
            per_turn_ = spindle_turns_ = true;
            return;
        case 2:
            line("G94");
            line(random_.word("F", 40, 800));
            break;
        default: line(fmt::format("G94 F{}", random_.decimal(40, 800))); break;
    }
    inverse_time_ = per_turn_ = false;
}

/// LinuxCNC keeps the number of a tool offset when the units change.
void NgcGenerator::units() {
    if (tool_offset_) change_tool_offset("G49");
    tool_offset_ = false;
    line(std::string(random_.one_of({"G20", "G21", "G21"})));
}

void NgcGenerator::plane() {
    const unsigned choice = random_.below(4);
    plane_ = choice == 1 ? Plane::zx : choice == 2 ? Plane::yz : Plane::xy;
    line(plane_ == Plane::xy ? "G17" : plane_ == Plane::zx ? "G18" : "G19");
}

/// By its name or a computed number, alone or in the block of a word X.
void NgcGenerator::lathe() {
    diameters_ = random_.chance(60);
    const int code = diameters_ ? 7 : 8;
    switch (random_.below(3)) {
        case 0: line(fmt::format("G{}", code)); return;
        case 1:
            line(fmt::format("#7 = {}", code));
            line("G#7");
            motion_ = Motion::none;
            return;
        default: break;
    }
    line(fmt::format("G{} G0 X{}", code, value(30)));
    motion_ = Motion::straight;
}

void NgcGenerator::distance() {
    incremental_ = random_.chance(30);
    line(incremental_ ? "G91" : "G90");
}

void NgcGenerator::system() {
    line(std::string(random_.one_of({"G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"})));
    rotated_ = unsure_ = true;  // perhaps
    if (shifted_) back_to_known_place();
}

/// With a rotation and a G92 offset in force LinuxCNC's present position jumps.
void NgcGenerator::set_system() {
    const bool turns = random_.chance(30);
    line(fmt::format("G10 L2 P{}{}{}", random_.between(0, 9), axis_words(30, false),
                     turns ? fmt::format(" R{}", random_.decimal(-180, 180)) : ""));
    rotated_ |= turns;
    if (rotated_) back_to_known_place();
}

void NgcGenerator::set_system_by_position() {
    line(fmt::format("G10 L20 P{}{}", random_.between(0, 9), axis_words(30, false)));
    if (rotated_) back_to_known_place();
}

void NgcGenerator::shift() {
    switch (random_.below(6)) {
        case 0: line("G92.1"); break;
        case 1: line("G92.2"); break;
        case 2: line("G92.3"); break;
        case 3: line("G52" + axis_words(20, false)); break;
        default: line("G92" + axis_words(20, false)); break;
    }
    shifted_ = true;
    unsure_ |= rotated_;
}

void NgcGenerator::change_tool_offset(const std::string& text) {
    line(text);
    tool_offset_ = unsure_ = true;
}

/// If LinuxCNC reads its machine's position, the stand-alone interpreter's canned machine lacks any tool
/// offset since its last move.
void NgcGenerator::after_wait() {
    if (unsure_) back_to_known_place();
}

void NgcGenerator::tool_offset() {
    switch (random_.below(5)) {
        case 0: return change_tool_offset("G49");
        case 1: return change_tool_offset(fmt::format("G43 H{}", random_.between(1, 5)));
        case 2: return change_tool_offset("G43");
        case 3: return change_tool_offset(fmt::format("G43.1 X{} Z{}", value(5), value(20)));
        default: return change_tool_offset(fmt::format("G43.2 H{}", random_.between(1, 5)));
    }
}

void NgcGenerator::tool_data() {
    const int tool = random_.between(1, 5);
    switch (random_.below(3)) {
        case 0:
            line(fmt::format("G10 L1 P{} Z{} R{}", tool, random_.decimal(0, 20), random_.decimal(1, 3)));
            break;
        case 1: line(fmt::format("G10 L10 P{} Z{}", tool, random_.decimal(-20, 20))); break;
        default: line(fmt::format("G10 L11 P{} Z{}", tool, random_.decimal(-20, 20))); break;
    }
    if (random_.chance(50)) change_tool_offset(fmt::format("G43 H{}", tool));
}

void NgcGenerator::tool_change() {
    line(fmt::format("T{} M6", random_.between(1, 5)));
    spindle_turns_ = false;
    after_wait();
    if (random_.chance(50)) change_tool_offset("G43");
}

void NgcGenerator::home() {
    switch (random_.below(4)) {
        case 0: line("G28.1"); return;
        case 1: line("G30.1"); return;
        case 2: line(fmt::format("G28{}", random_.chance(50) ? axis_words(20, incremental_) : "")); break;
        default: line(fmt::format("G30{}", random_.chance(50) ? axis_words(20, incremental_) : "")); break;
    }
}

void NgcGenerator::spindle() {
    switch (random_.below(5)) {
        case 0:
            if (per_turn_) return;
            line("M5");
            spindle_turns_ = false;
            return;
        case 1: line("M4 S450"); break;
        case 2:
            line(fmt::format("G96 D2000 S{} M3", random_.between(50, 200)));
            line("G97 S700");
            break;
        default: line(fmt::format("S{} M3", random_.between(100, 3000))); break;
    }
    spindle_turns_ = true;
}

void NgcGenerator::switches() {
    const std::string text(random_.one_of(
        {"M7",        "M8",     "M9",     "M48",    "M49",    "M50 P0",    "M51",       "M52 P1",
         "M53 P0",    "M62 P1", "M63 P2", "M64 P3", "M65 P0", "M66 P0 L0", "M66 E1 L0", "M67 E0 Q2.5",
         "M68 E1 Q0", "M0",     "M1",     "M60",    "T4",     "G97"}));
    line(text);
    if (text.starts_with("M66")) after_wait();
}

void NgcGenerator::path_mode() {
    line(std::string(random_.one_of({"G61", "G61.1", "G64", "G64 P0.1", "G64 P0.05 Q0.01", "G64 P0"})));
}

/// P, Q, R and L are there for every code of their block that reads them.
void NgcGenerator::shared_words() {
    switch (random_.below(6)) {
        case 0:
            line("G64 M19 R90");
            spindle_turns_ = false;
            return;
        case 1:
            line("G64 P1 M19 R45 Q2");
            spindle_turns_ = false;
            return;
        case 2: line("G4 P1.5 G64"); return;
        case 3: line("M50 P1 G64"); return;
        case 4: line("G64 P2 M62"); return;
        default: break;
    }
    if (inverse_time_ || (rotated_ && plane_ != Plane::xy)) return;
    line(fmt::format("G{} {}", random_.between(2, 3), arc_words(false)));
    line("G64 P3 " + without_turns(arc_words(false)));
    motion_ = Motion::other;
}

void NgcGenerator::kept_state() {
    if (tool_offset_ || inverse_time_ || per_turn_) return;
    line("M70");
    line(std::string(random_.one_of({"G91 M8", "G18 F77", "G55 G61", "G90.1 G98", "S99 F33", "G20 F4 G59.3",
                                     "G20 G91", "G7 F5", "G8 G91"})));
    line("M72");
    motion_ = Motion::other;
}

void NgcGenerator::computed_code() {
    line(fmt::format("#7 = {}", random_.one_of({"[170 / 10]", "61.1", "[40 + 0.5 * 0]", "64", "80"})));
    plane_ = text_.ends_with("[170 / 10]\n") ? Plane::xy : plane_;
    line("G#7");
    motion_ = Motion::none;
}

}  // namespace gsim::conformance
