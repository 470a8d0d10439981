// Functions of angles in degrees, worked out with the digits of long double and rounded once, as LinuxCNC
// does: by way of math.rad() FIX[ACOS[SIN[-7]]] would be 96, and not 97.

#include <cmath>
#include <numbers>

#include "runtime/script/bindings.h"
#include "runtime/script/lua_state.h"

namespace gsim::script {

namespace {

using Precise = long double;

constexpr Precise kHalfTurn = 180;
constexpr Precise kPi = std::numbers::pi_v<Precise>;

template <Precise (*function)(Precise)>
int of_degrees(lua_State* state) {
    const Precise degrees = luaL_checknumber(state, 1);
    lua_pushnumber(state, static_cast<double>(function(degrees * kPi / kHalfTurn)));
    return 1;
}

/// The angle is that of a double: only the way to degrees has more digits.
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

void add_angles(lua_State* state, Controller& controller) {
    set_function<of_degrees<std::sin>>(state, "sin_deg", &controller);
    set_function<of_degrees<std::cos>>(state, "cos_deg", &controller);
    set_function<of_degrees<std::tan>>(state, "tan_deg", &controller);
    set_function<asin_deg>(state, "asin_deg", &controller);
    set_function<acos_deg>(state, "acos_deg", &controller);
    set_function<atan_deg>(state, "atan_deg", &controller);
}

}  // namespace gsim::script
