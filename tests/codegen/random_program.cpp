#include "tests/codegen/random_program.h"

#include <array>

#include <fmt/format.h>

#include "tests/codegen/random_choice.h"

namespace gsim::codegen {
namespace {

std::string expression(Random& random, int depth) {
    static constexpr std::array<std::string_view, 9> kOperators = {"+",     "-",    "*",    "/", " MOD ",
                                                                   " AND ", " OR ", " EQ ", "-"};
    static constexpr std::array<std::string_view, 6> kFunctions = {"SIN",  "ABS",   "SQRT",
                                                                   "ATAN", "ROUND", "-"};
    switch (below(random, depth > 0 ? 7 : 3)) {
        case 0: return fmt::format("{}", below(random, 100));
        case 1: return fmt::format("#{}", below(random, 200));
        case 2: return fmt::format("{}.{}", below(random, 9), below(random, 99));
        case 3: return fmt::format("{}[{}]", one_of(random, kFunctions), expression(random, depth - 1));
        case 4:
            return fmt::format("ATAN[{}]/[{}]", expression(random, depth - 1), expression(random, depth - 1));
        default:
            return fmt::format("[{}]{}[{}]", expression(random, depth - 1), one_of(random, kOperators),
                               expression(random, depth - 1));
    }
}

std::string value(Random& random) {
    static constexpr std::array<std::string_view, 7> kNumberTexts = {"5",   "-.5", "5.",      "+7",
                                                                     "007", "0",   "-123.456"};
    if (below(random, 4) > 0) return one_of(random, kNumberTexts);
    return fmt::format("[{}]", expression(random, 3));
}

std::string move(Random& random) {
    static constexpr std::array<std::string_view, 6> kCodes = {"", "G0", "G01", "g1", "G91 G1", "M8 G1"};
    std::string out = one_of(random, kCodes);
    for (const char letter : {'X', 'Y', 'Z', 'B', 'C', 'F'}) {
        if (below(random, 3) == 0)
            out += fmt::format("{}{}", below(random, 2) == 0 ? " " : "", letter) + value(random);
    }
    return out;
}

std::string plain_block(Random& random, bool errors) {
    static constexpr std::array<std::string_view, 21> kBlocks = {"",
                                                                 "%",
                                                                 "(a comment -- [[ ]] end)",
                                                                 "X5 F200 G04",
                                                                 "M30",
                                                                 "G90 G17 G40",
                                                                 "G54;G0 X1;Y2",
                                                                 "M98 P7 L2",
                                                                 "M99",
                                                                 "G92 X0",
                                                                 "/2 G1 X1",
                                                                 "IF[#1 GT 5]THEN #2=#1",
                                                                 "G2 X1 Y1 I5",
                                                                 "T1 M6",
                                                                 "G1 X5 ,R2",
                                                                 "G65 P7 A1 I1 J2 I3",
                                                                 "DPRNT[X#100[53]*\"\\%d]",
                                                                 "#3000=1 (\"stop\\)",
                                                                 "M101 P5",
                                                                 "G41 D1 X5",
                                                                 "G81 X1 Z-2 R1 L3"};
    static constexpr std::array<std::string_view, 6> kErrors = {"X", "G0 G1", "X1 X2", "@", "G12 X1", "[["};
    switch (below(random, errors ? 5 : 4)) {
        case 0: return one_of(random, kBlocks);
        case 1: return fmt::format("#{}={}", below(random, 100), expression(random, 4));
        case 4: return one_of(random, kErrors);
        default: return move(random);
    }
}

}  // namespace

std::string random_program(Random& random, const RandomOptions& options) {
    std::string out;
    const auto add = [&](const std::string& line) { out += line + (below(random, 4) == 0 ? "\r\n" : "\n"); };
    int loops = 0;
    unsigned program = 1;
    if (below(random, 2) == 0) add(fmt::format("O{}", program++));
    for (int i = 0; i < options.lines; ++i) {
        if (options.jumps && loops < 3 && below(random, 12) == 0) {
            add(fmt::format("WHILE[#1 LT [{}]]DO{}", expression(random, 1), ++loops));
        } else if (loops > 0 && below(random, 6) == 0) {
            add(fmt::format("END{}", loops--));
        } else if (loops == 0 && below(random, 25) == 0) {
            add(fmt::format("O{}", program++));
        } else if (options.jumps && loops == 0 && below(random, 15) == 0) {
            add(fmt::format("N{} IF[#{} EQ 1]GOTO{}", 100 + i, below(random, 9), 100 + i));
        } else {
            add(plain_block(random, options.errors));
        }
    }
    while (loops > 0) add(fmt::format("END{}", loops--));
    if (below(random, 2) == 0) out += "M2";
    return out;
}

}  // namespace gsim::codegen
