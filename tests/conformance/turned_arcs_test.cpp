// Arcs in all planes under rotations about Z, compared with LinuxCNC's interpreter if it is installed: random
// programs, move by move, with the normals of their planes.

#include <cmath>
#include <random>
#include <sstream>

#include <fmt/format.h>

#include "tests/apps/canon_ends.h"
#include "tests/build_files/build_files.h"
#include "tests/conformance/canon_reader.h"
#include "tests/conformance/compare.h"
#include "tests/conformance/moves_reader.h"

namespace gsim::conformance::turned_arcs_test {
namespace {

constexpr int kPrograms = 30;
constexpr int kBlocks = 20;

class RandomPart {
  public:
    explicit RandomPart(unsigned seed) : random_(seed) {}

    std::string text() {
        std::string text = "G21 G90 G94\n";
        for (const char* system : {"P1", "P2"}) {
            text += fmt::format("G10 L2 {} X{:.3f} Y{:.3f} Z{:.3f} R{:.4f}\n", system, number(-50, 50),
                                number(-50, 50), number(-50, 50), rotation_deg());
        }
        text += fmt::format("F{:.1f}\nG0 X0 Y0 Z0\n", number(100, 3000));
        for (int i = 0; i < kBlocks; ++i) text += random_() % 5 == 0 ? other() : arc();
        return text + "M2\n";
    }

  private:
    double number(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    double rotation_deg() {
        return random_() % 4 == 0 ? 90.0 * static_cast<double>(random_() % 4) : number(-180, 180);
    }
    std::string other() {
        if (random_() % 2 == 0) return fmt::format("G{}\n", 54 + random_() % 2);
        return fmt::format("G0 X{:.3f} Y{:.3f} Z{:.3f}\n", number(-30, 30), number(-30, 30), number(-30, 30));
    }
    // In increments, by its centre or its radius, with a rise along the plane's normal in some.
    std::string arc() {
        static constexpr const char* kAxes[] = {"XYZ", "ZXY", "YZX"};
        static constexpr const char* kCenter[] = {"IJ", "KI", "JK"};
        const auto plane = random_() % 3;
        const bool ccw = random_() % 2 == 0;
        const double first = number(-30, 30), second = number(5, 30), sweep = number(0.3, 6);
        const double cosine = std::cos(sweep), sine = std::sin(ccw ? sweep : -sweep);
        std::string text = fmt::format("G91 G{} G{} {}{:.6f} {}{:.6f}", 17 + plane, ccw ? 3 : 2,
                                       kAxes[plane][0], first - cosine * first + sine * second,
                                       kAxes[plane][1], second - sine * first - cosine * second);
        if (std::abs(sweep - 3.14) > 0.5 && random_() % 3 == 0) {
            text += fmt::format(" R{:.6f}", (sweep > 3.14 ? -1 : 1) * std::hypot(first, second));
        } else {
            text += fmt::format(" {}{:.6f} {}{:.6f}", kCenter[plane][0], first, kCenter[plane][1], second);
        }
        if (random_() % 3 == 0) text += fmt::format(" {}{:.4f}", kAxes[plane][2], number(-9, 9));
        if (random_() % 5 == 0) text += " P2";
        return text + "\nG90\n";
    }

    std::mt19937 random_;
};

class RotatedArcs : public apps::Apps {};

TEST_F(RotatedArcs, AgreeWithLinuxCnc) {
    if (!apps::has_rs274()) GTEST_SKIP() << "LinuxCNC's rs274 is not installed";
    for (unsigned seed = 1; seed <= kPrograms; ++seed) {
        const std::string part = write("part.ngc", RandomPart(seed).text());
        const apps::Ended canon = apps::run_rs274(folder_, part);
        ASSERT_EQ(canon.status, 0) << seed << canon.err.substr(0, 2000);
        const apps::Ended run = gsim_run({part, "--dialect", "rs274ngc", "--machine",
                                          tests::source_path("samples/machines/unlimited.toml"), "--quiet",
                                          "--moves", "moves.jsonl"});
        ASSERT_EQ(run.status, 0) << seed << run.err;
        std::istringstream calls(canon.out), lines(read("moves.jsonl"));
        const auto expected = read_canon(calls);
        const auto found = read_moves(lines);
        ASSERT_TRUE(expected && found);
        const Verdict verdict = compare(*expected, *found);
        EXPECT_GT(verdict.agreed, 10U);
        ASSERT_FALSE(verdict.difference) << "seed " << seed << ": " << verdict.difference->what << "\n"
                                         << verdict.difference->expected << "\n"
                                         << verdict.difference->found << "\n"
                                         << read(part);
    }
}

}  // namespace
}  // namespace gsim::conformance::turned_arcs_test
