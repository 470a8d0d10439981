#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <tuple>

#include "controller/module/rcs_codec.h"

namespace gsim::rrs {

// A field that a module leaves as it is fails the check of RcsShell, if a check exists.
namespace unanswered_fields {

inline void mark_unset(double& field) {
    field = std::numeric_limits<double>::quiet_NaN();
}

inline void mark_unset(std::int32_t& field) {
    field = -1;
}

inline void mark_unset(std::int64_t& field) {
    field = -1;
}

inline void mark_unset(gsim_rcs_pose& field) {
    std::fill(std::begin(field.matrix), std::end(field.matrix), std::numeric_limits<double>::quiet_NaN());
}

inline void mark_unset(gsim_rcs_joints& field) {
    field.count = -1;
    std::fill(std::begin(field.values), std::end(field.values), std::numeric_limits<double>::quiet_NaN());
}

template <typename Storage>
void mark_unset(const codec::Text<Storage>& /*field*/) {}

}  // namespace unanswered_fields

/// Returns an output as it is before its service is called.
template <typename Output>
Output make_unset_output() {
    Output output{};
    std::apply([](auto&&... fields) { (unanswered_fields::mark_unset(fields), ...); }, codec::fields(output));
    return output;
}

}  // namespace gsim::rrs
