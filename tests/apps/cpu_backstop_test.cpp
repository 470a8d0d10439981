// --max-cpu-seconds in code that queries no source location: studies of a machine, drawings, the planning of
// axes.

#include <filesystem>
#include <random>

#include <fmt/format.h>

#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::cpu_backstop_test {
namespace {

class CpuLimitGuard : public Apps {
  protected:
    Ended gsim(const std::vector<std::string>& arguments) const {
        return run_program(tests::program_path("gsim"), arguments, folder_);
    }
    void expect_ended(const std::vector<std::string>& arguments, const char* output) const {
        SCOPED_TRACE(arguments.front());
        const Ended ended = gsim(arguments);
        EXPECT_EQ(ended.status, 1) << ended.err;
        EXPECT_EQ(ended.err, "error: the processor time exceeds --max-cpu-seconds\n");
        EXPECT_FALSE(exists(output));
        for (const auto& entry : std::filesystem::directory_iterator(folder_))
            EXPECT_EQ(entry.path().filename().string().find(output), std::string::npos)
                << "a temporary is left";
    }
};

std::string long_drawing() {
    constexpr int kLines = 60'000;
    std::mt19937 random(14);
    std::uniform_int_distribution<int> anywhere(0, 1'000'000);
    std::string dxf = "0\nSECTION\n2\nENTITIES\n";
    for (int i = 0; i < kLines; ++i) {
        const double x = anywhere(random) / 1000.0;
        const double y = anywhere(random) / 1000.0;
        dxf += fmt::format("0\nLINE\n8\n0\n10\n{}\n20\n{}\n11\n{}\n21\n{}\n", x, y, x + 1, y + 1);
    }
    return dxf + "0\nENDSEC\n0\nEOF\n";
}

TEST_F(CpuLimitGuard, EndsLongDrawing) {
    write("long.dxf", long_drawing());
    expect_ended({"autopath", "long.dxf", "--speed", "400", "--kerf", "1", "--max-cpu-seconds", "0.02", "-o",
                  "out.json"},
                 "out.json");
}

TEST_F(CpuLimitGuard, EndsLongEnvelope) {
    expect_ended({"run", "--machine", "arm6", "--envelope", "out.stl", "--max-cpu-seconds", "0.05"},
                 "out.stl");
}

TEST_F(CpuLimitGuard, WritesOutputWithinTime) {
    write(
        "part.svg",
        R"(<svg width="20mm" height="20mm" viewBox="0 0 20 20"><rect x="2" y="2" width="9" height="9"/></svg>)");
    EXPECT_EQ(gsim({"autopath", "part.svg", "--speed", "400", "--kerf", "1", "--at", "100", "100", "0",
                    "--max-cpu-seconds", "600", "-o", "p.json"})
                  .status,
              0);
    EXPECT_EQ(gsim({"path2gcode", "p.json", "--max-cpu-seconds", "600", "-o", "p.nc"}).status, 0);
    EXPECT_TRUE(exists("p.nc"));
}

}  // namespace
}  // namespace gsim::apps::cpu_backstop_test
