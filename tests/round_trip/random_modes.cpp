#include "tests/round_trip/random_modes.h"

#include <cmath>
#include <random>
#include <vector>

#include <fmt/format.h>

namespace gsim::round_trip {

namespace {

class RandomModes {
  public:
    RandomModes(const std::string& dialect, unsigned seed) : ab9_(dialect == "ab9"), random_(seed) {}

    std::string text() {
        std::string text = fmt::format("{}G21 G90 G94 F1500\nS1000 M3\n", ab9_ ? "O1\n" : "");
        for (int i = 0; i < 25; ++i) text += block();
        text += ab9_ ? "G90 G94 F900\nM98 P2 L2\n" : "G90 G94 F900\no100 call\no100 call\n";
        for (int i = 0; i < 5; ++i) text += block();
        text += ab9_ ? "M30\n%\nO2\n" : "";
        std::string sub;
        for (int i = 0; i < 6; ++i) sub += block();
        return ab9_ ? text + sub + "G90 G94 F800\nM99\n"
                    : "o100 sub\n" + sub + "G90 G94 F800\no100 endsub\n" + text + "M2\n";
    }

  private:
    double number(double low, double high) {
        return std::round(std::uniform_real_distribution<double>(low, high)(random_) * 1000) / 1000;
    }
    std::string one_of(const std::vector<std::string>& list) { return list[random_() % list.size()] + "\n"; }

    std::string move() {
        switch (random_() % 4) {
            case 0: {
                const double x = number(0, 50), z = number(0, 20);
                return fmt::format("G0 X{:.3f} Z{:.3f}\n", x, z);
            }
            case 1: return arc("");
            default: return line("") + "\n";
        }
    }
    // The draws are declared, since the order in which arguments are worked out is not.
    std::string line(const std::string& mode) {
        const double x = number(0, 50), y = number(0, 50);
        return fmt::format("{}G1 X{:.3f} Y{:.3f}", mode, x, y);
    }
    std::string per_minute() { return fmt::format("G94 F{:.1f}\n", number(100, 3000)); }
    // Returns a half circle to the right and one back, in increments from the tool's position.
    std::string arc(const std::string& feed) {
        const double radius = number(2, 20);
        const unsigned long sense = 2 + random_() % 2;
        return fmt::format("G91 G{0} X{1:.3f} I{2:.3f} J0 {3}\nX{4:.3f} I{5:.3f} J0 {3}\nG90\n", sense,
                           2 * radius, radius, feed, -2 * radius, -radius);
    }
    std::string timed() {
        std::string text = line("G93 ");
        text += fmt::format(" F{:.3f}\n", number(1, 30));
        text += arc(fmt::format("F{:.3f}", number(2, 40)));
        return text += per_minute();
    }
    std::string turned() {
        std::string text = fmt::format("G95 F{:.4f}\n", number(0.05, 1));
        text += moves(2);
        text += fmt::format("S{:.0f}\n", number(500, 2000));
        text += move();
        return text += per_minute();
    }
    std::string switched() {
        std::vector<std::string> list{
            "M8", "M9", "M7", "M3", "M4", "M5", "M0", "M1", "M3", "T2\nM5\nM6\nM3 S900", "T3\nM6"};
        const std::vector<std::string> own =
            ab9_ ? std::vector<std::string>{"M10", "M11", "#1105=1", "#1117=0", "M19", "M48"}
                 : std::vector<std::string>{"M62 P1",    "M65 P2",         "M67 E1 Q2.5", "M68 E0 Q-1", "M48",
                                            "M66 P0 L0", "(MSG,half way)", "M19 R45",     "M61 Q4"};
        list.insert(list.end(), own.begin(), own.end());
        return one_of(list) + "M3\n";
    }
    std::string mode() {
        if (!ab9_) return one_of({"G61", "G61.1", "G64", "G64 P0.05", "G64 P0.1 Q0.02"});
        return one_of({"G61", "G64", "G9 G1 X5 Y5", "G48.1 X300 Y400", "G48.2 Z200", "G48", "G47.1", "G47"});
    }
    std::string moves(int count) {
        std::string text;
        for (int i = 0; i < count; ++i) text += move();
        return text;
    }
    std::string block() {
        switch (random_() % 9) {
            case 0: return fmt::format("G4 P{:.3f}\n", number(0.01, 0.9));
            case 1: return timed();
            case 2: return turned();
            case 3: return switched();
            case 4: return mode();
            case 5: {
                const std::string system = one_of({"G54", "G55", "G57"});
                return system + move();
            }
            case 6: {
                const std::string feed = fmt::format("F{:.1f}\n", number(200, 4000));
                return feed + move();
            }
            default: return moves(2);
        }
    }

    bool ab9_;
    std::mt19937 random_;
};

}  // namespace

std::string random_modes(const std::string& dialect, unsigned seed) {
    return RandomModes(dialect, seed).text();
}

}  // namespace gsim::round_trip
