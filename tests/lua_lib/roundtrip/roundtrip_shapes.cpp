#include "tests/lua_lib/roundtrip/roundtrip_shapes.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "tests/lua_lib/roundtrip/roundtrip_units.h"

namespace gsim::roundtrip {

Block Shapes::start() {
    return {.codes = {"G21", "G90", "G17", "G94", "G54"}, .words = {{"F", values_.constant(100, 900)}}};
}

Body Shapes::some(const Scope& scope) {
    switch (random_.random_integer(0, 15)) {
        case 0: return dwell(scope);
        case 1: return table(scope);
        case 2:
        case 3: return offset(scope);
        case 4: return tool(scope);
        case 5: return machine_coordinates(scope);
        case 6: return inverse_time(scope);
        case 7: return cycle(scope);
        case 8:
        case 9:
        case 10:
        case 11: return arc(scope);
        default: return lines(scope);
    }
}

std::string Shapes::some_of(const std::string& letters) {
    std::string some;
    while (some.empty())
        for (const char letter : letters)
            if (random_.chance(2)) some += letter;
    return some;
}

void Shapes::add_axes(Block& block, const Scope& scope, const std::string& letters) {
    for (const char letter : letters)
        block.words.push_back({std::string(1, letter), values_.coordinate(scope.names)});
}

// Adds modal codes and axis words. The meaning of a position would change within the block if the block
// changes units or systems.
void Shapes::add_modes_and_axes(Block& block, Scope scope, const std::string& letters) {
    if (random_.chance(4)) block.codes.emplace_back(random_.chance(2) ? "G90" : "G91");
    if (random_.chance(8)) block.codes.push_back(fmt::format("G{}", random_.random_integer(17, 19)));
    if (random_.chance(4)) {
        scope.names.unbounded.clear();
        block.codes.emplace_back(random_.chance(2)   ? random_.pick(kSystems)
                                 : random_.chance(2) ? "G20"
                                                     : "G21");
    }
    if (random_.chance(5)) block.words.push_back({"F", values_.positive(scope.names, 50, 900)});
    add_axes(block, scope, letters);
}

Block Shapes::line_block(const Scope& scope) {
    Block block;
    block.codes.emplace_back(random_.chance(3) ? "G0" : "G1");
    add_modes_and_axes(block, scope, some_of(random_.chance(4) ? "XYZABC" : "XYZ"));
    return block;
}

// The motion code stays active in the following blocks.
Body Shapes::lines(const Scope& scope) {
    Body body;
    add(body, line_block(scope));
    while (random_.chance(2)) {
        Block next;
        add_modes_and_axes(next, scope, some_of(random_.chance(4) ? "XYZABC" : "XYZ"));
        if (!is_ab9() && random_.chance(4)) {
            Names still = scope.names;
            still.unbounded.clear();
            next.assignments.push_back({random_.pick(still.writable), values_.assigned(still)});
        }
        add(body, std::move(next));
    }
    return body;
}

Body Shapes::arc(const Scope& scope) {
    const int plane = random_.random_integer(0, 2);
    if (!scope.arcs[static_cast<std::size_t>(plane)]) return lines(scope);
    made_arcs_ = true;
    static constexpr const char* kLetters[] = {"XY", "ZX", "YZ"};
    const std::string letters = kLetters[plane];
    const bool absolute = random_.chance(2);
    Body body;
    // Absolute: to a known start. A factor on all lengths keeps the arc what it is.
    const std::array<double, 2> from{std::round(random_.real(-40, 40)), std::round(random_.real(-40, 40))};
    ExprPtr scale;
    if (random_.chance(3) && !scope.names.writable.empty()) {
        scale = random_.pick(scope.names.writable);
        add(body, {.assignments = {{scale, values_.positive(scope.names, 1, 3)}}});
    }
    if (absolute) {
        Block to_start{.codes = {random_.chance(2) ? "G0" : "G1", "G90"}};
        for (std::size_t i = 0; i < 2; ++i) {
            ExprPtr at = number(fmt::format("{}", from[i]));
            if (scale) at = binary(at, "*", scale);
            to_start.words.push_back({letters.substr(i, 1), at});
        }
        add(body, std::move(to_start));
    }
    add(body, arc_block(scope, plane, absolute, from, {random_.real(-40, 40), random_.real(5, 40)}, scale));
    if (!is_ab9() && body.back().block.codes.back() == "G90.1") add(body, {.codes = {"G91.1"}});
    return body;
}

// `shift`: from the start to the centre.
Block Shapes::arc_block(const Scope& scope, int plane, bool absolute, const std::array<double, 2>& from,
                        const std::array<double, 2>& shift, ExprPtr scale) {
    static constexpr const char* kLetters[] = {"XYZ", "ZXY", "YZX"};
    static constexpr const char* kCentre[] = {"IJ", "KI", "JK"};
    const std::string letters = kLetters[plane], centre_letters = kCentre[plane];
    const bool ccw = random_.chance(2), full = random_.chance(6), by_radius = !full && random_.chance(3);
    const bool centre_is_point = !is_ab9() && absolute && !by_radius && random_.chance(4);
    const double sweep = full ? 2 * std::numbers::pi : random_.real(0.3, 5.9);
    const double c = std::cos(ccw ? sweep : -sweep), s = std::sin(ccw ? sweep : -sweep);
    const std::array<double, 2> chord{full ? 0 : shift[0] - c * shift[0] + s * shift[1],
                                      full ? 0 : shift[1] - s * shift[0] - c * shift[1]};
    const auto length = [&scale](double value) {
        const ExprPtr digits = number(fmt::format("{:.9f}", value));
        return scale ? binary(digits, "*", scale) : digits;
    };
    Block block{.codes = {ccw ? "G3" : "G2", fmt::format("G{}", 17 + plane), absolute ? "G90" : "G91"}};
    for (std::size_t i = 0; i < 2; ++i) {
        if (full && random_.chance(2)) continue;
        block.words.push_back({letters.substr(i, 1), length(chord[i] + (absolute ? from[i] : 0))});
    }
    const double radius = std::hypot(shift[0], shift[1]);
    // Near half a turn the centre hangs on the last digits of R.
    const bool sound = std::abs(std::abs(sweep) - std::numbers::pi) > 0.3;
    if (by_radius && sound) {
        block.words.push_back({"R", length(sweep > std::numbers::pi ? -radius : radius)});
    } else {
        for (std::size_t i = 0; i < 2; ++i) {
            const double base = centre_is_point ? from[i] : 0;
            block.words.push_back({centre_letters.substr(i, 1), length(shift[i] + base)});
        }
    }
    if (random_.chance(3)) add_axes(block, scope, letters.substr(2, 1));
    if (random_.chance(6)) add_axes(block, scope, "A");
    if (!is_ab9() && random_.chance(4)) block.words.push_back({"P", values_.constant(1, 4, 0)});
    if (random_.chance(5)) block.words.push_back({"F", values_.positive(scope.names, 50, 900)});
    if (centre_is_point) block.codes.emplace_back("G90.1");
    return block;
}

// Each block that moves has its F.
Body Shapes::inverse_time(const Scope& scope) {
    Body body;
    Names still = scope.names;
    still.unbounded.clear();
    const Body moves = random_.chance(2) ? arc(scope) : lines(scope);
    bool first = true;
    for (const Statement& statement : moves) {
        Block block = statement.block;
        std::erase_if(block.words, [](const Word& word) { return word.letter == "F"; });
        if (!block.words.empty()) block.words.push_back({"F", values_.positive(still, 5, 50)});
        if (first && !block.words.empty()) block.codes.emplace_back("G93");
        if (!block.words.empty()) first = false;
        add(body, std::move(block));
    }
    add(body, {.codes = {"G94"}, .words = {{"F", values_.constant(100, 900)}}});
    return body;
}

Body Shapes::machine_coordinates(const Scope& scope) {
    Block block{.codes = {"G53", random_.chance(2) ? "G0" : "G1"}};
    if (!is_ab9()) block.codes.emplace_back("G90");
    add_axes(block, scope, some_of("XYZA"));
    Body body;
    add(body, std::move(block));
    return body;
}

Body Shapes::dwell(const Scope& scope) {
    static constexpr const char* kSeconds[] = {"P", "X", "U"};
    Body body;
    add(body, {.codes = {"G4"},
               .words = {{is_ab9() ? random_.pick(kSeconds) : "P", values_.positive(scope.names, 1, 3)}}});
    return body;
}

// G10 for work coordinate systems.
Body Shapes::table(const Scope& scope) {
    Block block{.codes = {"G10"}};
    const bool by_position = !is_ab9() && random_.chance(3);
    const bool is_ab9_external = is_ab9() && random_.chance(6);
    block.words.push_back({"L", number(by_position ? "20" : "2")});
    block.words.push_back(
        {"P", number(std::to_string(is_ab9_external ? 0 : random_.random_integer(is_ab9() ? 1 : 0, 9)))});
    for (const char letter : some_of(is_ab9_external ? "XYZ" : "XYZA"))
        block.words.push_back({std::string(1, letter), values_.filled(scope.names)});
    if (scope.turned_systems && !by_position && random_.chance(2))
        block.words.push_back({"R", values_.constant(-180, 180)});
    if (random_.chance(3)) block.codes.emplace_back(random_.chance(2) ? "G90" : "G91");
    Body body;
    add(body, std::move(block));
    return body;
}

Body Shapes::offset(const Scope& scope) {
    static constexpr const char* kCancel[] = {"G92.1", "G92.2", "G92.3"};
    Body body;
    if (random_.chance(4)) {
        add(body, {.codes = {is_ab9() ? "G92.1" : random_.pick(kCancel)}});
        return body;
    }
    Block block{.codes = {random_.chance(2) ? "G52" : "G92"}};
    for (const char letter : some_of("XYZA"))
        block.words.push_back({std::string(1, letter), values_.filled(scope.names)});
    add(body, std::move(block));
    return body;
}

Body Shapes::tool(const Scope& scope) {
    Body body;
    const ExprPtr location = number(std::to_string(random_.random_integer(1, 3)));
    if (!is_ab9() && random_.chance(2)) {
        // rs274, which such programs can be compared with, forgets an offset that no move follows before M6.
        body = lines(scope);
        add(body, {.codes = {"M6"}, .words = {{"T", location}}});
    }
    if (random_.chance(2)) {
        Block table{.codes = {"G10"}, .words = {{"P", location}}};
        const char* const list = is_ab9() ? (random_.chance(2) ? "10" : "11") : "1";
        table.words.push_back({"L", number(list)});
        table.words.push_back({is_ab9() ? "R" : "Z", values_.constant(0, 30)});
        if (!is_ab9() && random_.chance(3)) table.words.push_back({"X", values_.filled(scope.names)});
        add(body, std::move(table));
    }
    switch (random_.random_integer(0, 4)) {
        case 0: add(body, {.codes = {"G49"}}); break;
        case 1: add(body, {.codes = {"G43"}}); break;
        case 2:
            if (is_ab9()) {
                add(body, {.words = {{"H", location}}});
            } else {
                add(body, {.codes = {"G43.1"},
                           .words = {{random_.chance(2) ? "Z" : "Y", values_.filled(scope.names)}}});
            }
            break;
        default:
            add(body, {.codes = {is_ab9() && random_.chance(3) ? "G44" : "G43"}, .words = {{"H", location}}});
    }
    return body;
}

// --- Canned cycles ---

std::string Shapes::cycle_code() {
    static constexpr const char* kCycles[] = {"G81", "G82", "G83", "G85"};
    return random_.pick(kCycles);
}

// The R level lies above the bottom. `all`: with every word that the cycle `code` needs. On the 9/Series it
// may have those of other cycles.
void Shapes::add_cycle_words(Block& block, const Scope& scope, const std::string& code, int plane,
                             bool incremental, bool all) {
    static constexpr const char* kLetters[] = {"XYZ", "ZXY", "YZX"};
    const std::string letters = kLetters[plane];
    add_axes(block, scope, some_of(letters.substr(0, 2)));
    if (all || random_.chance(3))
        block.words.push_back(
            {letters.substr(2), values_.constant(incremental ? -40 : -30, incremental ? -1 : 5)});
    if (all || random_.chance(4))
        block.words.push_back({"R", values_.constant(incremental ? -30 : 6, incremental ? 20 : 40)});
    if (all && code == "G83") block.words.push_back({"Q", values_.constant(4.1, 15)});
    if (all && (code == "G82" || (is_ab9() && code == "G83" && random_.chance(2))))
        block.words.push_back({"P", values_.constant(0.5, 2)});
    if (random_.chance(4)) block.words.push_back({"L", values_.constant(1, 3, 0)});
}

Body Shapes::cycle(const Scope& scope) {
    const int plane = scope.turned_systems ? 0 : random_.random_integer(0, 2);
    const bool incremental = random_.chance(3);
    Body body;
    add(body, line_block(scope));
    std::string code = cycle_code();
    Block first{.codes = {code, fmt::format("G{}", 17 + plane), incremental ? "G91" : "G90"}};
    if (random_.chance(2)) first.codes.emplace_back(random_.chance(2) ? "G98" : "G99");
    add_cycle_words(first, scope, code, plane, incremental, true);
    add(body, std::move(first));
    while (random_.chance(2)) {
        Block next;
        const bool changes = random_.chance(4);
        if (changes) code = cycle_code();
        if (changes) next.codes.push_back(code);
        if (random_.chance(4)) next.codes.emplace_back(random_.chance(2) ? "G98" : "G99");
        add_cycle_words(next, scope, code, plane, incremental, changes);
        add(body, std::move(next));
    }
    if (random_.chance(2)) return body;  // the next motion code ends it
    add(body, {.codes = {"G80"}});
    if (is_ab9()) {
        Block repeated;
        add_axes(repeated, scope, some_of("XYZ"));
        add(body, std::move(repeated));
    }
    return body;
}

Body Shapes::polar(const Scope& scope) {
    Body body;
    add(body, {.codes = {"G16"}});
    const int blocks = random_.random_integer(1, 4);
    for (int i = 0; i < blocks; ++i) {
        Block block;
        if (i == 0 || random_.chance(2)) block.codes.emplace_back(random_.chance(3) ? "G0" : "G1");
        if (random_.chance(3)) block.codes.emplace_back(random_.chance(2) ? "G90" : "G91");
        if (random_.chance(6)) block.codes.push_back(fmt::format("G{}", random_.random_integer(17, 19)));
        add_axes(block, scope, some_of("XYZ"));
        add(body, std::move(block));
    }
    add(body, {.codes = {"G15"}});
    return body;
}

}  // namespace gsim::roundtrip
