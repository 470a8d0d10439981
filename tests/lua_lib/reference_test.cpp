// The test part of the thesis: its figures were worked out by hand from the program, see docs.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "runtime/machine/machine_file.h"
#include "tests/lua_lib/run.h"

namespace gsim::script::reference_test {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

const fs::path kSource = GSIM_SOURCE;

TEST(Reference, TheWheelOnTheCalibratedMachine) {
    Conditions setup;
    setup.machine = machine::load_machine(kSource / "samples/machines/af5-measured.toml").value();
    const Outcome r = run(text_of(kSource / "samples/wheel.nc"), setup);
    ASSERT_TRUE(r.completed()) << r.message();
    EXPECT_NEAR(r.report.cycle_time_s, 129.99, 129.99 * 0.0005);
    EXPECT_NEAR(r.report.feed_mm + r.report.rapid_mm, 4525.35, 0.02);
    EXPECT_DOUBLE_EQ(r.report.rapid_mm, 0);
}

// The program as the thesis prints it, which is not part of this project.
TEST(Reference, AppendixJAsWritten) {
    const char* named = std::getenv("GSIM_APPENDIX_J");
    const fs::path path = named != nullptr ? fs::path(named) : kSource / "../shared/reference/appendix_j.nc";
    if (!fs::is_regular_file(path)) GTEST_SKIP() << "no appendix_j.nc; GSIM_APPENDIX_J can name it";
    const Outcome r = run(text_of(path));
    ASSERT_TRUE(r.completed()) << r.message();
    EXPECT_NEAR(r.report.feed_mm, 6752.81, 0.02);
    EXPECT_NEAR(r.report.cycle_time_s, 1635.5, 1635.5 * 0.001);
}

}  // namespace
}  // namespace gsim::script::reference_test
