#pragma once

#include <array>
#include <concepts>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "controller/services/service_call.h"
#include "runtime/script/bindings/bindings.h"
#include "runtime/script/lua/check_option.h"
#include "runtime/script/lua/pose_table.h"

// Service as scripts call it, made from its method of Shell: arguments in its order, then the status, then
// its results.
namespace gsim::script {

/// Names of an enumeration's values in scripts, in the order of `values`.
template <typename Enumeration>
struct ScriptNames;

template <>
struct ScriptNames<rrs::TargetType> {
    static constexpr const char* names[] = {"cartesian", "joint", nullptr};
    static constexpr std::array values = {rrs::TargetType::cartesian, rrs::TargetType::joint};
};

template <>
struct ScriptNames<rrs::MotionType> {
    static constexpr const char* names[] = {"joint", "linear", "circular", nullptr};
    static constexpr std::array values = {rrs::MotionType::joint, rrs::MotionType::linear,
                                          rrs::MotionType::circular};
};

template <>
struct ScriptNames<rrs::Dominance> {
    static constexpr const char* names[] = {"automatic", "position", "orientation", nullptr};
    static constexpr std::array values = {rrs::Dominance::automatic, rrs::Dominance::position,
                                          rrs::Dominance::orientation};
};

template <>
struct ScriptNames<rrs::RampMode> {
    static constexpr const char* names[] = {"machine", "linear", "s_curve", "infinite", nullptr};
    static constexpr std::array values = {rrs::RampMode::machine, rrs::RampMode::linear,
                                          rrs::RampMode::s_curve, rrs::RampMode::infinite};
};

template <>
struct ScriptNames<rrs::RampLimit> {
    static constexpr const char* names[] = {"acceleration", "deceleration", "jerk", nullptr};
    static constexpr std::array values = {rrs::RampLimit::acceleration, rrs::RampLimit::deceleration,
                                          rrs::RampLimit::jerk};
};

inline std::size_t joint_count(lua_State* state) {
    return bound_interpreter(state).simulator().machine().axes.size();
}

/// Arguments of a script's call, in order.
class Arguments {
  public:
    explicit Arguments(lua_State* state) : state_(state) {}

    template <typename Parameter>
    auto next() {
        using ValueType = std::remove_cvref_t<Parameter>;
        if constexpr (std::is_same_v<ValueType, bool>) {
            return lua_toboolean(state_, ++at_) != 0;
        } else if constexpr (std::is_enum_v<ValueType>) {
            using Names = ScriptNames<ValueType>;
            return Names::values[static_cast<std::size_t>(
                check_option(state_, ++at_, nullptr, Names::names))];
        } else if constexpr (std::integral<ValueType>) {
            return static_cast<ValueType>(luaL_checkinteger(state_, ++at_));
        } else {
            return read(std::type_identity<ValueType>());
        }
    }

  private:
    double read(std::type_identity<double>) { return luaL_checknumber(state_, ++at_); }
    std::string_view read(std::type_identity<std::string_view>) { return luaL_checkstring(state_, ++at_); }
    rrs::CartPos read(std::type_identity<rrs::CartPos>) { return check_pose(state_, ++at_); }
    rrs::JointPos read(std::type_identity<rrs::JointPos>) {
        return check_joints(state_, ++at_, joint_count(state_));
    }
    /// Reads three numbers.
    Eigen::Vector3d read(std::type_identity<Eigen::Vector3d>) {
        const double x = luaL_checknumber(state_, ++at_);
        const double y = luaL_checknumber(state_, ++at_);
        return {x, y, luaL_checknumber(state_, ++at_)};
    }
    /// Returns no joints, because scripts mean all of them.
    std::span<const int> read(std::type_identity<std::span<const int>>) { return {}; }
    /// Reads a list of numbers, or one number for all.
    std::span<const double> read(std::type_identity<std::span<const double>>) {
        if (lua_isnumber(state_, ++at_) != 0) {
            values_.assign(joint_count(state_), lua_tonumber(state_, at_));
        } else {
            const rrs::JointPos joints = check_joints(state_, at_, joint_count(state_));
            values_.assign(joints.begin(), joints.end());
        }
        return values_;
    }

    lua_State* state_;
    int at_ = 0;
    std::vector<double> values_;
};

inline void push_output(lua_State* state, const rrs::JointPos& joints) {
    push_joints(state, joints);
}
inline void push_output(lua_State* state, const rrs::CartPos& pose) {
    push_pose(state, pose);
}
inline void push_output(lua_State* state, double number) {
    lua_pushnumber(state, number);
}
inline void push_output(lua_State* state, std::integral auto number) {
    lua_pushinteger(state, number);
}

inline rrs::Shell& bound_shell(lua_State* state) {
    bound_interpreter(state).attach(state);
    return bound_interpreter(state).simulator().services().shell();
}

/// Pushes the status alone; returns the number of results.
inline int push_status(lua_State* state, rrs::Status status) {
    lua_pushinteger(state, static_cast<lua_Integer>(status));
    return 1;
}

/// Pushes the status, and the results of the service unless it was rejected.
template <typename... Outputs>
int push_status(lua_State* state, rrs::Status status, const Outputs&... outputs) {
    push_status(state, status);
    if (rrs::is_error_status(status)) return 1;
    (push_output(state, outputs), ...);
    return 1 + static_cast<int>(sizeof...(outputs));
}

template <typename... Parameters>
int call_service(lua_State* state, rrs::Status (rrs::Shell::*method)(Parameters...)) {
    using Traits = rrs::ServiceTraits<rrs::Status (rrs::Shell::*)(Parameters...)>;
    using Inputs = std::tuple<Parameters...>;
    rrs::Shell& shell = bound_shell(state);
    Arguments arguments(state);
    const auto inputs = [&]<std::size_t... at>(std::index_sequence<at...>) {
        return std::tuple{arguments.next<std::tuple_element_t<at, Inputs>>()...};  // in order
    }
    (std::make_index_sequence<Traits::kInputs>());
    typename Traits::Outputs outputs{};
    const rrs::Status status = rrs::call(shell, method, inputs, outputs);
    return std::apply([&](const auto&... values) { return push_status(state, status, values...); }, outputs);
}

}  // namespace gsim::script
