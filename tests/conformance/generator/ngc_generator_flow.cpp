// Part of the generator that writes parameters, comments and O-words. The content of a branch, a loop or a
// subroutine changes no mode. The remainder of the program is therefore known, however often it is run.

#include <fmt/format.h>

#include "tests/conformance/generator/ngc_generator.h"
#include "tests/conformance/random_expression.h"

namespace gsim::conformance {

void NgcGenerator::setting() {
    const std::string value = bounded_expression(random_, 60, 2, true);
    switch (random_.below(9)) {
        case 0: line(fmt::format("#<size> = {}", value)); return;
        case 1: line(fmt::format("#<_size> = {}", value)); return;
        case 2: line(fmt::format("#[{} + 1] = {}", random_.between(1, 7), value)); return;
        case 3: line(fmt::format("#ABS[-{}] = {}", random_.between(1, 9), value)); return;
        case 4: line(fmt::format("#-[-{}] = {}", random_.between(1, 9), value)); return;
        case 5:
            line("#ATAN[1]/[1] = #1");
            line("#2 = #45");
            return;
        case 6: line(fmt::format("#1 = {} #2 = #1", value)); return;
        case 7: line(inverse_time_ ? "#9 = 1" : "#9 = #<_feed>"); return;
        default: line(fmt::format("#{} = {}", random_.between(1, 9), value)); return;
    }
}

void NgcGenerator::comment() {
    line(std::string(
        random_.one_of({"(a remark)", "(debug, #1 and #<size>)", "(print, %.2f #2)", "(msg, hello)",
                        "(log, #<_size>)", "(logopen, x.txt)", "(logclose)", "; (abort, a remark)",
                        "(abort without a comma)", "(abort, not the last one)(a remark)",
                        "(debug,#99 #<none>)", "o<99> if [0]\n(abort, never)\no<99> endif"})));
    if (text_.find("o<99> if") != std::string::npos) {  // a label exists once in a program
        const std::size_t at = text_.rfind("o<99> if");
        const std::string label = std::to_string(++label_);
        text_.replace(text_.find("o<99> endif", at) + 2, 2, label);
        text_.replace(at + 2, 2, label);
    }
}

void NgcGenerator::small_move() {
    if (inverse_time_) {
        line(fmt::format("G1 X{} F9", value(20)));
    } else if (random_.chance(60)) {
        line(fmt::format("G{} X{} Z{}", random_.between(0, 1), value(20), value(20)));
    } else {
        line(fmt::format("#{} = {}", random_.between(1, 5), bounded_expression(random_, 9, 2, false)));
    }
}

void NgcGenerator::condition() {
    const int label = ++label_;
    line(fmt::format("o{} if {}", label, random_condition(random_, true)));
    small_move();
    if (random_.chance(30)) {
        line(fmt::format("o{} elseif {}", label, random_condition(random_, true)));
        small_move();
    }
    if (random_.chance(50)) {
        line(fmt::format("o{} else", label));
        small_move();
    }
    line(fmt::format("o{} endif", label));
    motion_ = Motion::other;
}

void NgcGenerator::loop() {
    const int label = ++label_;
    const int passes = random_.between(1, 3);
    switch (random_.below(3)) {
        case 0:
            line(fmt::format("o{} repeat [{}]", label, random_.one_of({"2", "3", "1.6", "0", "-1", "2.5"})));
            small_move();
            line(fmt::format("o{} endrepeat", label));
            break;
        case 1:
            line("#8 = 0");
            line(fmt::format("o<loop {}> while [#8 LT {}]", label, passes));
            small_move();
            line("#8 = [#8 + 1]");
            if (random_.chance(40)) {
                const int inner = ++label_;
                line(fmt::format("o{} if [#8 EQ 2]", inner));
                line(fmt::format("o<loop{}> {}", label, random_.one_of({"break", "continue"})));
                line(fmt::format("o{} endif", inner));
            }
            line(fmt::format("o<loop{}> endwhile", label));
            break;
        default:
            line("#8 = 0");
            line(fmt::format("o{} do", label));
            small_move();
            line("#8 = [#8 + 1]");
            line(fmt::format("o{} while [#8 LT {}]", label, passes));
            break;
    }
    motion_ = Motion::other;
}

void NgcGenerator::call() {
    switch (random_.below(6)) {
        case 0: line(fmt::format("o10 call [{}] [{}]", value(20), value(20))); break;
        case 1: line("o<steps> call [3]"); break;
        case 2: line(fmt::format("o[5 + 5] call [{}]", value(20))); break;
        case 3: line("o<0010> call"); break;
        case 4: line("M98 P3000"); break;
        default: line(fmt::format("M98 P[3000 + 1] L{}", random_.between(1, 2))); break;
    }
    if (random_.chance(30)) line("#4 = [#<_value> + EXISTS[#<inside>] + #<_value_returned>]");
    motion_ = Motion::other;
}

void NgcGenerator::definitions() {
    definitions_ = fmt::format(
        "o10 sub\n#<inside> = [#1 + EXISTS[#<size>]]\n#<size> = 2\nG1 X[#1 MOD 30] Y[#2 MOD 30] F{}\n"
        "o10 endsub [#<inside>]\n"
        "o<steps> sub\no<steps1> if [#1 LE 0]\no<steps> return [7]\no<steps1> endif\nG0 Z#1\n"
        "o<steps> call [#1 - 1]\no<steps> endsub\n"
        "o<0010> sub\n(not o10)\nM73\nG0 Y[#<_size>] M8\nG4 P0.25\no<0010> endsub\n",
        random_.decimal(50, 500));
}

/// They are after the main program, where LinuxCNC searches for them.
void NgcGenerator::numbered_programs() {
    line("O3000\n#3 = [#3 + 1]\nG0 Z[#3 MOD 20]\nM98 P3001\nM99\nO3001\nG0 Y[#3 MOD 10]\nM99");
    if (random_.chance(30)) line("O3000\nG0 X99\nM99");
}

}  // namespace gsim::conformance
