#include "runtime/report/limit_name.h"

#include <string_view>

#include <fmt/format.h>

namespace gsim::simulation {

namespace {

using motion::LimitKind;

std::string of_joint(int joint, const machine::Machine& machine, std::string_view what) {
    const auto index = static_cast<std::size_t>(joint);
    if (joint < 0 || index >= machine.axes.size()) return fmt::format("joint {}", what);
    const machine::Axis& axis = machine.axes[index];
    const bool rotary = axis.kind == machine::AxisKind::rotary;
    return fmt::format("{} {} {}", rotary ? "rotary" : "joint", axis.letter, what);
}

std::string_view name_words(LimitKind kind) {
    // clang-format off
    switch (kind) {
#define GSIM_LIMIT_KIND(name, number, words) case LimitKind::name: return words;
#include "base/kinds/limit_kind.def"
    }
    // clang-format on
    return "";
}

}  // namespace

std::string describe(motion::LimitCause limited_by, const machine::Machine& machine) {
    const std::string_view words = name_words(limited_by.kind);
    const bool is_axis_limit =
        limited_by.kind == LimitKind::joint_speed || limited_by.kind == LimitKind::acceleration;
    return is_axis_limit ? of_joint(limited_by.joint, machine, words) : std::string(words);
}

}  // namespace gsim::simulation
