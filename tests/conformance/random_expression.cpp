#include "tests/conformance/random_expression.h"

#include <fmt/format.h>

namespace gsim::conformance {

namespace {

std::string parameter(RandomSource& random, bool reads_control) {
    const unsigned kinds = reads_control ? 6 : 4;
    switch (random.below(kinds)) {
        case 0: return fmt::format("#{}", random.between(1, 9));
        case 1: return "#<size>";
        case 2: return "#<_size>";
        case 3: return fmt::format("#[{} + {}]", random.between(1, 4), random.between(0, 5));
        case 4:
            return std::string(random.one_of(
                {"#<_metric>", "#<_plane>", "#<_absolute>", "#<_rpm>", "#<_coord_system>", "#<_spindle_on>",
                 "#<_flood>", "#<_call_level>", "#<_ccomp>", "#<_inverse_time>", "#<_ijk_absolute_mode>",
                 "#<_retract_r_plane>", "#<_feed_override>", "#<_tool_offset>"}));
        default:
            return std::string(
                random.one_of({"#5220", "#5221", "#5222", "#5230", "#5241", "#5210", "#5211", "#5399"}));
    }
}

std::string existence(RandomSource& random) {
    return fmt::format("EXISTS[{}]", random.one_of({"#1", "#9", "#30", "#31", "#5220", "#5602", "#0", "##20",
                                                    "#[2*3000]", "#<size>", "#<_size>", "#<nowhere>",
                                                    "#<_nowhere>", "#<_metric>", "# < s i z e >"}));
}

std::string function(RandomSource& random, const std::string& inner) {
    switch (random.below(12)) {
        case 0: return fmt::format("ABS{}", inner);
        case 1: return fmt::format("ROUND{}", inner);
        case 2: return fmt::format("FIX{}", inner);
        case 3: return fmt::format("FUP{}", inner);
        case 4: return fmt::format("SIN{}", inner);
        case 5: return fmt::format("COS{}", inner);
        case 6: return fmt::format("SQRT[ABS{}]", inner);
        case 7: return fmt::format("LN[ABS{} + 1]", inner);
        case 8: return fmt::format("EXP[SIN{}]", inner);
        case 9: return fmt::format("ATAN{}/[{}]", inner, random.between(1, 9));
        case 10: return fmt::format("ACOS[SIN{}]", inner);
        default: return fmt::format("TAN[{} MOD 80]", inner);
    }
}

std::string joined(RandomSource& random, const std::string& left, const std::string& right) {
    switch (random.below(14)) {
        case 0: return fmt::format("{} / [ABS{} + 1]", left, right);
        case 1: return fmt::format("{} MOD [ABS{} + 2]", left, right);
        case 2: return fmt::format("[{} MOD 5] ** {}", left, random.between(0, 3));
        case 3: return fmt::format("{} AND {}", left, right);
        case 4: return fmt::format("{} OR {}", left, right);
        case 5: return fmt::format("{} XOR {}", left, right);
        case 6:
            return fmt::format("{} {} {}", left, random.one_of({"EQ", "NE", "GT", "GE", "LT", "LE"}), right);
        case 7: return fmt::format("-{} - {}", left, right);
        case 8: return fmt::format("[{} MOD 50] * [{} MOD 50]", left, right);
        default: return fmt::format("{} {} {}", left, random.one_of({"+", "-"}), right);
    }
}

}  // namespace

std::string random_expression(RandomSource& random, int depth, bool reads_control) {
    if (depth == 0) {
        return random.chance(50) ? fmt::format("[{}]", random.decimal(-20, 20))
                                 : fmt::format("[{}]", parameter(random, reads_control));
    }
    const std::string inner = random_expression(random, depth - 1, reads_control);
    switch (random.below(5)) {
        case 0: return fmt::format("[{}]", function(random, inner));
        case 1: return fmt::format("[{} + {}]", existence(random), inner);
        default:
            return fmt::format("[{}]",
                               joined(random, inner, random_expression(random, depth - 1, reads_control)));
    }
}

std::string bounded_expression(RandomSource& random, int size, int depth, bool reads_control) {
    const std::string any = random_expression(random, random.between(0, depth), reads_control);
    return fmt::format("[{} MOD {} - {}]", any, 2 * size, size);
}

std::string random_condition(RandomSource& random, bool reads_control) {
    switch (random.below(4)) {
        case 0: return fmt::format("[{}]", existence(random));
        case 1:
            return fmt::format("[{} AND {} GT {}]", existence(random), parameter(random, reads_control),
                               random.between(-5, 5));
        default:
            return fmt::format("[{} {} {}]", random_expression(random, 1, reads_control),
                               random.one_of({"EQ", "NE", "GT", "GE", "LT", "LE"}),
                               random_expression(random, 0, reads_control));
    }
}

}  // namespace gsim::conformance
