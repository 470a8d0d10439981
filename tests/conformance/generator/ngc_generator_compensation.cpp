// The part of the generator that writes cutter compensation.

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "tests/conformance/generator/ngc_generator.h"

namespace gsim::conformance {

/// The moves of the path are long compared with the tool, so that it fits into most of the inside corners.
void NgcGenerator::compensation() {
    if (plane_ != Plane::xy || inverse_time_ || incremental_) return;
    if (tool_offset_) change_tool_offset("G49");
    tool_offset_ = false;
    line("G0 X0 Y0");
    const std::string_view side = random_.one_of({"G41", "G42"});
    if (random_.chance(60)) {
        line(fmt::format("{}.1 D{}", side, random_.decimal(0, 3)));
    } else {
        line(fmt::format("G21 {} D{}", side, random_.between(0, 5)));
    }
    line(fmt::format("G1 X{} Y{}", random_.decimal(20, 30), random_.decimal(-10, 10)));
    compensated_path();
    line("G40");
    line(fmt::format("G{} X{} Y{}", random_.between(0, 1), random_.decimal(-90, -60),
                     random_.decimal(60, 90)));
    motion_ = Motion::straight;
}

/// After a stop LinuxCNC moves the tool onto an arc on a spiral, which gsim does not; a line follows there.
void NgcGenerator::compensated_path() {
    line("G91");
    const int moves = random_.between(1, 7);
    bool stopped = false;
    for (int i = 0; i < moves; ++i) {
        line(corner_move(stopped));
        stopped = random_.chance(8);
        if (stopped) line("M0");
        if (random_.chance(15))
            line(random_.chance(50) ? random_.word("G1 Z", -5, 5) : std::string("G4 P0.5"));
        if (random_.chance(15))
            line(std::string(random_.one_of({"M8", "M3 S200", "F321", "(msg, on the way)"})));
    }
    line("G90");
}

std::string NgcGenerator::corner_move(bool straight) {
    const double heading = random_.between(0, 11) * std::numbers::pi / 6 + 0.1;
    const double length = random_.between(150, 500) / 10.0;
    const double x = length * std::cos(heading) * (diameters_ ? 2 : 1), y = length * std::sin(heading);
    if (straight || random_.chance(70))
        return fmt::format("G{} X{:.4f} Y{:.4f}", random_.chance(15) ? 0 : 1, x, y);
    return fmt::format("G{} X{:.4f} Y{:.4f} R{:.3f}", random_.between(2, 3), x, y,
                       length * random_.between(6, 20) / 10.0);
}

}  // namespace gsim::conformance
