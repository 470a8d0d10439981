#include "tests/lua_lib/roundtrip/roundtrip_transforms.h"

#include <fmt/format.h>

namespace gsim::roundtrip {

namespace {

class Maker {
  public:
    Maker(Scope& inside, Random& random, Values& values)
        : inside_(inside), names_(inside.names), random_(random), values_(values) {
        names_.unbounded.clear();  // a position would change within a block that changes the system
    }

    Bracket rotation() {
        static constexpr const char* kLetters[] = {"XY", "ZX", "YZ"};
        const int plane = random_.random_integer(0, 2);
        Block turn{.codes = {"G68", fmt::format("G{}", 17 + plane)},
                   .words = {{"R", values_.filled(names_)}}};
        if (random_.chance(3)) turn.codes.emplace_back(random_.chance(2) ? "G90" : "G91");
        if (random_.chance(4)) turn.codes.push_back(fmt::format("G{}", random_.random_integer(54, 59)));
        add_centre(turn, kLetters[plane]);
        Bracket bracket{.begin = {}, .end = {.codes = {"G69"}}};
        bracket.begin.push_back({.block = std::move(turn)});
        // In increments the angle adds to the rotation that is in force in that plane.
        if (random_.chance(3))
            bracket.begin.push_back({.block = {.codes = {"G68", random_.chance(3) ? "G90" : "G91"},
                                               .words = {{"R", values_.filled(names_)}}}});
        return bracket;
    }

    Bracket mirror() {
        const char* const letter = random_.chance(2) ? "X" : "Y";
        Block mirror{.codes = {"G51.1"}, .words = {{letter, values_.filled(names_)}}};
        if (random_.chance(3)) mirror.words.push_back({"Z", values_.filled(names_)});
        Bracket bracket{.begin = {}, .end = {.codes = {"G50.1"}}};
        if (random_.chance(2)) bracket.end.words.push_back({letter, number("0")});
        bracket.begin.push_back({.block = std::move(mirror)});
        return bracket;
    }

    // Both codes begin it with a factor and end it without.
    Bracket scale() {
        Block scale{.codes = {scale_code()}};
        if (random_.chance(2)) {
            scale.words.push_back({"P", values_.constant(0.6, 2)});
        } else {
            scale.words.push_back({"I", values_.constant(0.6, 2)});
            if (random_.chance(2)) scale.words.push_back({"K", values_.constant(0.6, 2)});
            inside_.arcs = {};
        }
        add_centre(scale, "XYZ");
        Bracket bracket{.begin = {}, .end = {.codes = {scale_code()}}};
        bracket.begin.push_back({.block = std::move(scale)});
        return bracket;
    }

  private:
    const char* scale_code() { return random_.chance(2) ? "G14" : "G14.1"; }

    void add_centre(Block& block, const std::string& letters) {
        for (const char letter : letters)
            if (random_.chance(2)) block.words.push_back({std::string(1, letter), values_.filled(names_)});
    }

    Scope& inside_;
    Names names_;
    Random& random_;
    Values& values_;
};

}  // namespace

Bracket random_transformation(Scope& inside, Random& random, Values& values) {
    Maker maker(inside, random, values);
    switch (random.random_integer(0, 2)) {
        case 0: return maker.rotation();
        case 1: return maker.mirror();
        default: return maker.scale();
    }
}

}  // namespace gsim::roundtrip
