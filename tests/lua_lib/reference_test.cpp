// The test part of the thesis: its figures were worked out by hand from the program, see docs.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "machine/file/machine_file.h"
#include "tests/build_files/build_files.h"
#include "tests/lua_lib/run.h"

namespace gsim::script::reference_test {
namespace {

namespace fs = std::filesystem;

std::string read_file_text(const fs::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

const fs::path kSource = tests::source_path();

// 129.99 s was worked out by hand, from each joint's own trapezoid, as with independent_ramps.
TEST(Reference, WheelMatchesCalculatedTimeAndLength) {
    Conditions setup;
    setup.machine = machine::load_machine(kSource / "samples/machines/af5-measured.toml").value();
    for (const auto& [independent_ramps, time_s] : {std::pair{true, 129.99}, std::pair{false, 131.44}}) {
        setup.machine.controller.coordination.independent_ramps = independent_ramps;
        const Outcome r = run(read_file_text(kSource / "samples/wheel.nc"), setup);
        ASSERT_TRUE(r.completed()) << r.message();
        EXPECT_NEAR(r.report.cycle_time_s, time_s, time_s * 0.0005);
        EXPECT_NEAR(r.report.distances.feed_mm + r.report.distances.rapid_mm, 4525.35, 0.02);
        EXPECT_DOUBLE_EQ(r.report.distances.rapid_mm, 0);
    }
}

// The program as the thesis prints it, which is not part of this project.
TEST(Reference, AppendixJMatchesCalculatedTimeAndLength) {
    const char* const folder = std::getenv("GSIM_REFERENCE");
    const fs::path path = fs::path(folder != nullptr ? folder : "") / "appendix_j.nc";
    if (!fs::is_regular_file(path)) GTEST_SKIP() << "no appendix_j.nc in the folder GSIM_REFERENCE";
    Conditions setup;
    for (const auto& [independent_ramps, time_s] : {std::pair{true, 1635.5}, std::pair{false, 1653.2}}) {
        setup.machine.controller.coordination.independent_ramps = independent_ramps;
        const Outcome r = run(read_file_text(path), setup);
        ASSERT_TRUE(r.completed()) << r.message();
        EXPECT_NEAR(r.report.distances.feed_mm, 6752.81, 0.02);
        EXPECT_NEAR(r.report.cycle_time_s, time_s, time_s * 0.0005);
    }
}

}  // namespace
}  // namespace gsim::script::reference_test
