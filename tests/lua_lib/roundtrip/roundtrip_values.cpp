#include "tests/lua_lib/roundtrip/roundtrip_values.h"

#include <cmath>

#include <fmt/format.h>

namespace gsim::roundtrip {

namespace {

ExprPtr size_of(ExprPtr a) {
    return function("ABS", std::move(a));
}

ExprPtr sum(ExprPtr a, ExprPtr b) {
    return binary(std::move(a), "+", std::move(b));
}

}  // namespace

ExprPtr Values::constant(double low, double high, int decimals) {
    const int digits = random_.random_integer(0, decimals);
    std::string text = fmt::format("{:.{}f}", random_.real(low, high), digits);
    if (std::stod(text) == 0) text = "0";
    if (digits == 0 && decimals > 0 && random_.chance(3)) text += ".";
    return number(text);
}

ExprPtr Values::leaf(const Names& names) {
    const int choice = random_.random_integer(0, 9);
    if (choice < 4 && !names.readable.empty()) return random_.pick(names.readable);
    if (choice == 4 && !names.counters.empty()) return random_.pick(names.counters);
    if (choice == 5 && !names.unbounded.empty()) return random_.pick(names.unbounded);
    if (choice == 6 && !names.optional.empty()) return exists(random_.pick(names.optional));
    if (choice == 7) return negative(leaf(names));
    return constant(0, 40);
}

ExprPtr Values::call(const Names& names, int depth) {
    const ExprPtr a = any(names, depth - 1);
    switch (random_.random_integer(0, 11)) {
        case 0: return function("SIN", a);
        case 1: return function("COS", a);
        case 2: return angle(a, sum(size_of(leaf(names)), number("1.5")));
        case 3: return function("SQRT", size_of(a));
        case 4: return size_of(a);
        case 5: return function("ROUND", a);
        case 6: return function("FIX", a);
        case 7: return function("FUP", a);
        case 8: return function("LN", sum(size_of(a), number("1")));
        case 9: return function("EXP", function("SIN", a));
        case 10:
            return function(random_.chance(2) ? "ASIN" : "ACOS",
                            binary(function("COS", a), "*", number("0.9")));
        default: return dialect_ == Dialect::ab9 ? function("ATAN", a) : angle(a, leaf(names));
    }
}

ExprPtr Values::operation(const Names& names, int depth) {
    static constexpr const char* kLogic[] = {"AND", "OR", "XOR"};
    const ExprPtr a = any(names, depth - 1);
    switch (random_.random_integer(0, 8)) {
        case 0:
        case 1: return sum(a, any(names, depth - 1));
        case 2:
        case 3: return binary(a, "-", any(names, depth - 1));
        case 4: return binary(a, "*", leaf(names));
        case 5: return binary(a, "/", sum(size_of(leaf(names)), number("1.5")));
        case 6: return binary(a, "MOD", constant(2, 30));
        case 7:
            if (dialect_ == Dialect::ngc) {
                static constexpr const char* kPowers[] = {"0.5", "2", "-1"};
                const ExprPtr base = sum(number("1"), binary(size_of(a), "MOD", number("5")));
                return binary(base, "**", number(random_.pick(kPowers)));
            }
            return binary(a, "/", constant(1, 9));
        default: {
            const char* const logic = random_.pick(kLogic);
            if (dialect_ == Dialect::ngc) return binary(a, logic, leaf(names));
            return binary(function("FIX", binary(a, "MOD", number("64"))), logic, constant(0, 40, 0));
        }
    }
}

ExprPtr Values::any(const Names& names, int depth) {
    if (depth <= 0 || random_.chance(4)) return leaf(names);
    if (random_.chance(10)) return comparison(names);
    return random_.chance(3) ? call(names, depth) : operation(names, depth);
}

ExprPtr Values::wrapped(const Names& names, int depth) {
    const bool by_remainder = random_.chance(2);
    const ExprPtr a = any(names, depth);
    if (by_remainder) return binary(binary(a, "MOD", number("80")), "-", constant(0, 40));
    const char* const wave = random_.chance(2) ? "SIN" : "COS";
    return binary(constant(5, 60), "*", function(wave, a));
}

ExprPtr Values::coordinate(const Names& names) {
    const int choice = random_.random_integer(0, 9);
    if (choice < 2 && !names.readable.empty()) {
        const ExprPtr variable = random_.pick(names.readable);
        return random_.chance(3) ? negative(variable) : variable;
    }
    return filled(names);
}

// Returns a name or number, moved by a constant up to `most`.
ExprPtr Values::shifted(const Names& names, double max) {
    const ExprPtr a = leaf(Names{.readable = names.readable});
    return sum(a, constant(-max, max));
}

ExprPtr Values::filled(const Names& names) {
    switch (random_.random_integer(0, 7)) {
        case 0: return shifted(names, 20);
        case 1: return wrapped(names, 2);
        case 2: return negative(wrapped(names, 1));
        default: return constant(-60, 60);
    }
}

ExprPtr Values::positive(const Names& names, int low, int range) {
    if (!random_.chance(4)) return constant(low + 0.1, low + range - 0.1);
    return sum(binary(size_of(any(names, 1)), "MOD", number(std::to_string(range))),
               number(std::to_string(low)));
}

ExprPtr Values::comparison(const Names& names) {
    static constexpr const char* kComparisons[] = {"EQ", "NE", "GT", "GE", "LT", "LE"};
    const ExprPtr a = random_.chance(2) ? leaf(names) : any(names, 1);
    if (random_.chance(10))  // equal in RS274/NGC, because EQ has a tolerance
        return binary(a, random_.chance(2) ? "EQ" : "NE", sum(a, number("0.00005")));
    const char* const comparison = random_.pick(kComparisons);
    return binary(a, comparison, leaf(names));
}

ExprPtr Values::condition(const Names& names) {
    static constexpr const char* kJoints[] = {"AND", "OR", "XOR"};
    if (!random_.chance(3)) return comparison(names);
    const ExprPtr a = comparison(names);
    const char* const joint = random_.pick(kJoints);
    return binary(a, joint, comparison(names));
}

ExprPtr Values::assigned(const Names& names) {
    switch (random_.random_integer(0, 5)) {
        case 0: return coordinate(names);
        case 1: return shifted(names, 5);
        case 2: return constant(-50, 50);
        default: return wrapped(names, 3);
    }
}

}  // namespace gsim::roundtrip
