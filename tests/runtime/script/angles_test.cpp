// SIN and COS of degrees against the C library's functions of long double, as LinuxCNC calls them.

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "tests/lua_lib/run.h"

namespace gsim::script::angles_test {
namespace {

constexpr int kAngles = 20'000;

/// Returns angles in thousandths of a degree, up to the given size.
std::vector<double> angles(double most_deg) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-most_deg, most_deg);
    std::vector<double> angles;
    for (int i = 0; i < kAngles; ++i) angles.push_back(std::round(uniform(random) * 1000) / 1000);
    return angles;
}

/// A line for each angle, which counts the values that are not the nearest one to the library's.
std::string script(const std::vector<double>& angles) {
    std::string text =
        "local bad = 0\nlocal function look(got, want)\n"
        "  if got ~= want then bad = bad + 1 end\n"
        "  assert(math.abs(got - want) <= 0x1p-52 * math.abs(want))\nend\n";
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const long double angle_rad =
            static_cast<long double>(angles[i]) * std::numbers::pi_v<long double> / 180;
        const auto sine = static_cast<double>(std::sin(angle_rad));
        const auto cosine = static_cast<double>(std::cos(angle_rad));
        // A function of Lua holds so many constants only.
        if (i % 1000 == 0) text += i == 0 ? "do\n" : "end do\n";
        text += fmt::format("look(SIN({0:.3f}), {1:a}) look(COS({0:.3f}), {2:a})\n", angles[i], sine, cosine);
    }
    return text + fmt::format("end\nassert(bad <= {}, bad)\n", angles.size() / 1000);
}

TEST(Angles, SineAndCosineMatchLongDouble) {
    for (const double most_deg : {1.0, 360.0, 36'000.0}) {
        const Outcome r = run_lua(script(angles(most_deg)));
        EXPECT_TRUE(r.completed()) << most_deg << ": " << r.message();
    }
}

TEST(Angles, SpecialAnglesEqualRoundedLongDouble) {
    const std::vector<double> quarters{0, 30, 45, 60, 90, 180, 270, 360, -90, -180, 450, 1e6, 1e9};
    const Outcome r = run_lua(script(quarters));
    EXPECT_TRUE(r.completed()) << r.message();
}

}  // namespace
}  // namespace gsim::script::angles_test
