#pragma once

#include <type_traits>
#include <utility>

#include "controller/services/controller_rules.h"

namespace gsim::rrs {

/// A value in one of the groups of ControllerRules, for tables of keys: C++ has no pointer to a member of a
/// member.
template <typename Value>
struct RuleField {
    const Value& (*get)(const ControllerRules&);
    Value& (*get_mutable)(ControllerRules&);

    /// Returns the value in `rules`.
    const Value& operator()(const ControllerRules& rules) const { return get(rules); }
    Value& operator()(ControllerRules& rules) const { return get_mutable(rules); }
};

/// Returns the field of pointers to a group and to a member in there.
template <auto Group, auto Member>
constexpr auto rule_field() {
    using Value = std::remove_reference_t<decltype(std::declval<ControllerRules&>().*Group.*Member)>;
    return RuleField<Value>{[](const ControllerRules& rules) -> const Value& { return rules.*Group.*Member; },
                            [](ControllerRules& rules) -> Value& { return rules.*Group.*Member; }};
}

}  // namespace gsim::rrs
