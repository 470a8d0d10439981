#include <array>
#include <vector>

#include <fmt/format.h>

#include "tests/codegen/random_choice.h"
#include "tests/codegen/random_program.h"

namespace gsim::codegen {
namespace {

std::string parameter(Random& random) {
    static constexpr std::array<std::string_view, 6> kParameters = {"#1",          "# 30",      "#<a>",
                                                                    "#<_Glob al>", "#[#2 + 1]", "##3"};
    return one_of(random, kParameters);
}

std::string ngc_expression(Random& random, int depth) {
    static constexpr std::array<std::string_view, 14> kOperators = {
        "+", "-", "*", "/", "**", " MOD ", " AND ", " OR ", " XOR ", " EQ ", " ne ", " GT ", " LE ", "-"};
    static constexpr std::array<std::string_view, 6> kFunctions = {"SIN", "abs", "SQRT", "ROUND", "-", "FUP"};
    switch (below(random, depth > 0 ? 9 : 3)) {
        case 0: return fmt::format("{}", below(random, 100));
        case 1: return parameter(random);
        case 2: return fmt::format("{}.{}", below(random, 9), below(random, 99));
        case 3: return fmt::format("{}[{}]", one_of(random, kFunctions), ngc_expression(random, depth - 1));
        case 4:
            return fmt::format("ATAN[{}]/[{}]", ngc_expression(random, depth - 1),
                               ngc_expression(random, depth - 1));
        case 5: return fmt::format("EXISTS[{}]", parameter(random));
        default:
            return fmt::format("[{}]{}[{}]", ngc_expression(random, depth - 1), one_of(random, kOperators),
                               ngc_expression(random, depth - 1));
    }
}

std::string bracketed(Random& random) {
    return "[" + ngc_expression(random, 3) + "]";
}

std::string ngc_value(Random& random) {
    static constexpr std::array<std::string_view, 6> kNumberTexts = {"5",  "- .5", " 1 2 . 5",
                                                                     "+7", "007",  "-123.456"};
    switch (below(random, 5)) {
        case 0: return bracketed(random);
        case 1: return parameter(random);
        default: return one_of(random, kNumberTexts);
    }
}

std::string ngc_move(Random& random) {
    static constexpr std::array<std::string_view, 6> kCodes = {"", "G0", "g 0 1", "G91 G1", "M8 G1", "G53G0"};
    std::string out = one_of(random, kCodes);
    for (const char letter : {'X', 'y', 'Z', 'B', 'U', 'F'}) {
        if (below(random, 3) == 0) out += letter + ngc_value(random);
    }
    for (unsigned settings = below(random, 3); settings > 0; --settings)
        out += fmt::format("{}={}", parameter(random), below(random, 2) == 0 ? bracketed(random) : "-5.");
    return out;
}

std::string plain_block(Random& random) {
    static constexpr std::array<std::string_view, 16> kBlocks = {
        "",
        "(a comment -- [[ ]] end)",
        "(DEBUG,#1 is %d #<a> \" \\ ]] %)",
        "(MSG,go) ; on",
        "; a remark (with",
        "G4 P0.5 (PRINT,x)",
        "G2 X1 Y1 I5 P2",
        "g90 g17 g40 g54 g94",
        "/G1 X1",
        "N10 G81 X1 Z-2 R1 L3",
        "M3 S100 $1",
        "o<other> call [1] [#2]",
        "o#1 call",
        "T1 M6 G43 H1",
        "G10 L2 P1 X5",
        "@5 ^30",
    };
    return below(random, 2) == 0 ? one_of(random, kBlocks) : ngc_move(random);
}

/// A structure that is open, by the keyword that ends it.
struct Open {
    std::string name;
    bool loop;
    std::string_view end;
};

class Program {
  public:
    Program(Random& random, int lines) : random_(random) {
        for (int i = 0; i < lines; ++i) add_block();
        while (!open_.empty()) close();
        if (below(random_, 2) == 0) text_ += "M2";
    }
    const std::string& text() const { return text_; }

  private:
    void add(const std::string& line) { text_ += line + (below(random_, 4) == 0 ? "\r\n" : "\n"); }

    void add_block() {
        const unsigned choice = below(random_, 20);
        if (choice == 0 && open_.empty()) {
            open("sub", "endsub", false);
        } else if (choice < 4 && open_.size() < 6) {
            open_structure(choice);
        } else if (choice < 7 && !open_.empty()) {
            close();
        } else if (choice == 7) {
            leave();
        } else {
            add(plain_block(random_));
        }
    }

    void open(const std::string& keyword, std::string_view end, bool loop) {
        const std::string name =
            below(random_, 2) == 0 ? fmt::format("{}", 100 + next_++) : fmt::format("<s {}>", next_++);
        add(fmt::format("o{} {}", name, keyword));
        open_.push_back({name, loop, end});
    }

    void open_structure(unsigned choice) {
        if (choice == 1) return open("if " + bracketed(random_), "endif", false);
        switch (below(random_, 3)) {
            case 0: return open("while " + bracketed(random_), "endwhile", true);
            case 1: return open("repeat " + bracketed(random_), "endrepeat", true);
            default: return open("do", "while", true);
        }
    }

    void close() {
        const Open last = open_.back();
        if (last.end == "endif" && below(random_, 2) == 0) add(fmt::format("o{} else", last.name));
        add(fmt::format("O{} {}{}", last.name, last.end, last.end == "while" ? bracketed(random_) : ""));
        open_.pop_back();
    }

    /// break or continue of some loop around, or a return.
    void leave() {
        if (open_.empty()) return;
        const Open& any = open_[below(random_, static_cast<unsigned>(open_.size()))];
        if (any.loop) add(fmt::format("o{} {}", any.name, below(random_, 2) == 0 ? "break" : "continue"));
        if (any.end == "endsub") add(fmt::format("o{} return {}", any.name, bracketed(random_)));
    }

    Random& random_;
    std::string text_;
    std::vector<Open> open_;
    int next_ = 0;
};

}  // namespace

std::string random_ngc_program(Random& random, int lines) {
    return Program(random, lines).text();
}

}  // namespace gsim::codegen
