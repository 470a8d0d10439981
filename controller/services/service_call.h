#pragma once

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

#include "controller/services/shell.h"

namespace gsim::rrs {

/// True for a parameter that a service fills in; these follow its inputs.
template <typename Parameter>
inline constexpr bool kIsOutput =
    std::is_lvalue_reference_v<Parameter> && !std::is_const_v<std::remove_reference_t<Parameter>>;

/// Inputs and outputs of a method of Shell.
template <typename Method>
struct ServiceTraits;

template <typename... Parameters>
struct ServiceTraits<Status (Shell::*)(Parameters...)> {
    static constexpr std::size_t kInputs = (std::size_t{!kIsOutput<Parameters>} + ... + 0);
    /// Values to be filled in.
    using Outputs = decltype(std::tuple_cat(
        std::declval<std::conditional_t<
            kIsOutput<Parameters>, std::tuple<std::remove_reference_t<Parameters>>, std::tuple<>>>()...));
};

/// Calls a service with values; numbers replace an enumeration or a switch.
template <typename... Parameters, typename Inputs>
Status call(Shell& shell, Status (Shell::*method)(Parameters...), const Inputs& inputs,
            typename ServiceTraits<Status (Shell::*)(Parameters...)>::Outputs& outputs) {
    constexpr std::size_t kInputs = ServiceTraits<Status (Shell::*)(Parameters...)>::kInputs;
    const auto argument = [&]<typename Parameter, std::size_t at>() -> decltype(auto) {
        if constexpr (kIsOutput<Parameter>) {
            return (std::get<at - kInputs>(outputs));
        } else if constexpr (std::is_enum_v<Parameter>) {
            return static_cast<Parameter>(std::get<at>(inputs));
        } else if constexpr (std::is_same_v<Parameter, bool>) {
            return std::get<at>(inputs) != 0;
        } else {
            return (std::get<at>(inputs));
        }
    };
    return [&]<std::size_t... at>(std::index_sequence<at...>) {
        return (shell.*method)(argument.template operator()<Parameters, at>()...);
    }
    (std::index_sequence_for<Parameters...>());
}

}  // namespace gsim::rrs
