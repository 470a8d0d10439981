// Functions of angles in degrees, computed with the digits of long double and rounded once, as LinuxCNC does:
// with math.rad() FIX[ACOS[SIN[-7]]] would be 96, and not 97.

#include <cmath>
#include <numbers>

#include "runtime/script/bindings/bindings.h"
#include "runtime/script/lua/lua_state.h"

namespace gsim::script {

namespace {

using Precise = long double;

constexpr Precise kHalfTurn = 180;
constexpr Precise kPi = std::numbers::pi_v<Precise>;

// Quarter of a turn in parts, each of so few digits that its products with kMaxQuarters at most are exact
// (Cody and Waite, Software Manual for the Elementary Functions, 1980).
constexpr Precise kQuarterHigh = 0x1.921fb54442p+0L;
constexpr Precise kQuarterMiddle = 0x1.a308d31319p-41L;
constexpr Precise kQuarterLow = 0x1.145c06e0e6894812p-82L;
constexpr Precise kMaxQuarters = 1 << 20;
constexpr Precise kQuartersPerRad = 2 / kPi;

/// Angle (rad) as quarters of a turn, counted from 0 to 3, and the remainder, at most half a quarter.
struct ReducedAngle {
    unsigned quarters;
    Precise remainder;
};

ReducedAngle reduced(Precise angle) {
    const long integer_part = std::lrint(angle * kQuartersPerRad);
    const auto count = static_cast<Precise>(integer_part);
    const Precise remainder = ((angle - count * kQuarterHigh) - count * kQuarterMiddle) - count * kQuarterLow;
    return {static_cast<unsigned>(integer_part) & 3U, remainder};
}

// Taylor's series up to half a quarter: the omitted part is below 2^-72 of the value. Terms that are below
// 2^-13 of it need no more digits than those of double, which are computed in a quarter of the time.

Precise sine_near_zero(Precise x) {
    const Precise square = x * x;
    const auto z = static_cast<double>(square);
    const double tail = (-1.0 / 5'040 + z * (1.0 / 362'880)) +
                        z * z *
                            ((-1.0 / 39'916'800 + z * (1.0 / 6'227'020'800)) +
                             z * z * (-1.0 / 1'307'674'368'000 + z * (1.0 / 355'687'428'096'000)));
    return x + x * square * (-1.0L / 6 + square * (1.0L / 120 + square * tail));
}

Precise cosine_near_zero(Precise x) {
    const Precise square = x * x;
    const auto z = static_cast<double>(square);
    const double tail = (1.0 / 40'320 + z * (-1.0 / 3'628'800)) +
                        z * z *
                            ((1.0 / 479'001'600 + z * (-1.0 / 87'178'291'200)) +
                             z * z * (1.0 / 20'922'789'888'000 + z * (-1.0 / 6'402'373'705'728'000)));
    return 1 + square * (-0.5L + square * (1.0L / 24 + square * (-1.0L / 720 + square * tail)));
}

Precise sine(Precise angle, unsigned quarter_offset) {
    const auto [quarters, remainder] = reduced(angle);
    const unsigned quadrant = (quarters + quarter_offset) & 3U;
    const Precise value = (quadrant & 1U) != 0 ? cosine_near_zero(remainder) : sine_near_zero(remainder);
    return (quadrant & 2U) != 0 ? -value : value;
}

/// Returns the first argument, degrees, in rad.
Precise check_angle(lua_State* state) {
    return static_cast<Precise>(luaL_checknumber(state, 1)) * kPi / kHalfTurn;
}

template <Precise (*function)(Precise), unsigned quarter_offset>
int trig_of_degrees(lua_State* state) {
    const Precise angle = check_angle(state);
    const bool near = std::abs(angle) < kMaxQuarters;
    lua_pushnumber(state, static_cast<double>(near ? sine(angle, quarter_offset) : function(angle)));
    return 1;
}

int tan_deg(lua_State* state) {
    lua_pushnumber(state, static_cast<double>(std::tan(check_angle(state))));
    return 1;
}

/// Pushes the angle of a double: only the conversion to degrees has more digits.
int push_degrees(lua_State* state, double radians) {
    lua_pushnumber(state, static_cast<double>(radians * kHalfTurn / kPi));
    return 1;
}

int asin_deg(lua_State* state) {
    return push_degrees(state, std::asin(luaL_checknumber(state, 1)));
}

int acos_deg(lua_State* state) {
    return push_degrees(state, std::acos(luaL_checknumber(state, 1)));
}

int atan_deg(lua_State* state) {
    return push_degrees(state, std::atan2(luaL_checknumber(state, 1), luaL_optnumber(state, 2, 1)));
}

}  // namespace

void add_angles(lua_State* state, Interpreter& interpreter) {
    set_function<trig_of_degrees<std::sin, 0>>(state, "sin_deg", &interpreter);
    set_function<trig_of_degrees<std::cos, 1>>(state, "cos_deg", &interpreter);
    set_function<tan_deg>(state, "tan_deg", &interpreter);
    set_function<asin_deg>(state, "asin_deg", &interpreter);
    set_function<acos_deg>(state, "acos_deg", &interpreter);
    set_function<atan_deg>(state, "atan_deg", &interpreter);
}

}  // namespace gsim::script
