#include "tests/conformance/generator/ngc_generator.h"

#include <array>

#include <fmt/format.h>

#include "tests/conformance/random_expression.h"

namespace gsim::conformance {

namespace {

constexpr int kLeastBlocks = 12;
constexpr int kMaxProgramBlocks = 45;

}  // namespace

std::string NgcGenerator::program() {
    definitions();
    setup();
    const int blocks = random_.between(kLeastBlocks, kMaxProgramBlocks);
    for (int i = 0; i < blocks; ++i) block();
    line(std::string(random_.one_of({"M2", "M30", "m2 (the end)"})));
    numbered_programs();
    return definitions_ + text_;
}

void NgcGenerator::setup() {
    line(fmt::format("G21 G90 F{}", random_.decimal(50, 900)));
    line("#<size> = 7.5");
    line("#<_size> = -3.25");
    line("#20 = 30");
    line(fmt::format("T{} M6",
                     random_.between(1, 5)));  // else the stand-alone interpreter takes tool 1 to be loaded
    for (int i = 1; i <= 5; ++i) line(fmt::format("#{} = {}", i, random_.decimal(-9, 9)));
    line("G0 X0 Y0 Z0");
    motion_ = Motion::straight;
}

void NgcGenerator::block() {
    using Act = void (NgcGenerator::*)();
    using N = NgcGenerator;
    static constexpr std::array kActs = {
        &N::straight,
        &N::straight,
        &N::straight,
        &N::modal_straight,
        &N::modal_straight,
        &N::polar,
        &N::machine_move,
        &N::arc,
        &N::arc,
        &N::arc_by_radius,
        &N::full_circle,
        &N::spline,
        &N::nurbs,
        &N::cycle,
        &N::cycle,
        &N::probe,
        &N::thread,
        &N::threading_cycle,
        &N::dwell,
        &N::feed_mode,
        &N::units,
        &N::plane,
        &N::lathe,
        &N::distance,
        &N::system,
        &N::set_system,
        &N::set_system,
        &N::set_system_by_position,
        &N::shift,
        &N::shift,
        &N::tool_offset,
        &N::tool_data,
        &N::tool_change,
        &N::home,
        &N::spindle,
        &N::switches,
        &N::path_mode,
        &N::shared_words,
        &N::kept_state,
        &N::computed_code,
        &N::setting,
        &N::setting,
        &N::comment,
        &N::condition,
        &N::condition,
        &N::loop,
        &N::call,
        &N::compensation,
    };
    const Act act = kActs[random_.below(kActs.size())];
    (this->*act)();
}

/// A number, a parameter or an expression, of about that size.
std::string NgcGenerator::value(int size) {
    if (random_.chance(75)) return random_.decimal(-size, size);
    return bounded_expression(random_, size, 1, true);
}

std::string NgcGenerator::axis_words(int size, bool incremental) {
    std::string words;
    const int min = incremental ? size / 2 : size;
    for (const std::string_view axis : {"X", "Y", "Z", "A", "B", "C"}) {
        const unsigned percent = axis < "D" ? 15 : 60;
        if (random_.chance(percent)) words += fmt::format(" {}{}", axis, value(min));
    }
    return words.empty() ? fmt::format(" X{}", random_.decimal(1, size)) : words;
}

}  // namespace gsim::conformance
