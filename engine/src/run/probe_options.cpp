#include "engine/src/run/probe_options.h"

#include <cmath>

#include <fmt/format.h>

#include "base/text/letter_case.h"
#include "machine/data/machine_data_words.h"

namespace gsim::engine {

namespace {

using simulation::ProbeSurface;

constexpr std::string_view kAxes = "xyz";

Result<ProbeSurface> plane(std::size_t axis, double at_mm, const machine::Machine& machine) {
    const char letter = static_cast<char>('X' + axis);
    const auto found = machine.find(letter);
    if (!found || machine.axes[*found].kind != machine::AxisKind::linear)
        return Unexpected(fmt::format("--probe: the machine has no linear axis {}", letter));
    return ProbeSurface{.kind = ProbeSurface::Kind::plane, .axis = axis, .at_mm = at_mm};
}

}  // namespace

Result<ProbeSurface> read_probe_options(std::string_view value, const machine::Machine& machine) {
    if (value.empty()) return ProbeSurface{};
    if (value == "none") return ProbeSurface{.kind = ProbeSurface::Kind::none};
    const std::size_t axis = kAxes.find(text::lower(value.substr(0, 1)));
    if (axis < kAxes.size() && value.size() > 1 && value[1] == '=') {
        const auto at_mm = machine::parse_number<double>(value.substr(2));
        if (at_mm && std::isfinite(*at_mm)) return plane(axis, *at_mm, machine);
    }
    return Unexpected(
        fmt::format("--probe must be none, or the position of a plane that stops probes, as x=, y= or z= in "
                    "mm of machine coordinates (z=-3.2), not '{}'",
                    value));
}

}  // namespace gsim::engine
