// Response of grbl to $$ and $# as a machine.

#include "machine/import/grbl_dump.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "machine/file/machine_file.h"
#include "machine/import/import_machine.h"
#include "tests/build_files/build_files.h"

namespace gsim::import::grbl_dump_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// The settings with which the motion of samples/machines/grbl-router.toml was recorded.
constexpr const char* kRouter =
    "$11=0.010\n$12=0.002\n$22=0\n$100=250.000\n$101=250.000\n$102=250.000\n$110=6000.000\n$111=6000.000\n"
    "$112=6000.000\n$120=1000.000\n$121=1000.000\n$122=1000.000\n$130=10000.000\n$131=10000.000\n$132=10000."
    "000\n"
    "ok\n";

ImportResult import_text(const std::string& text) {
    const auto imported = import_grbl(text, "router.txt");
    EXPECT_TRUE(imported) << imported.error().message;
    return imported.value_or(ImportResult{});
}

TEST(GrblDump, ImportOfRecordedMachineMatchesSample) {
    machine::Machine machine = import_text(kRouter).machine;
    machine::Machine sample =
        machine::load_machine(tests::source_path("samples/machines/grbl-router.toml")).value();
    machine.name = sample.name;
    machine.program = sample.program;
    machine.process = sample.process;
    for (std::size_t i = 0; i < sample.axes.size(); ++i) {  // without homing there are no ranges
        machine.axes.at(i).min = sample.axes[i].min;
        machine.axes.at(i).max = sample.axes[i].max;
    }
    EXPECT_EQ(machine::print_machine(machine), machine::print_machine(sample));
}

TEST(GrblDump, HomingSetsRangeFromMinusTravelToZero) {
    const ImportResult imported =
        import_text(std::string(kRouter) + "$22=1\n$23=3\n$27=1.000\n$130=300.000\n$13=0\n$32=1\n");
    const machine::Axis& x = imported.machine.axes.at(0);
    EXPECT_EQ(x.min, -300);
    EXPECT_EQ(x.max, 0);
    EXPECT_EQ(x.home, -299);                          // its switch is at the low end
    EXPECT_EQ(imported.machine.axes.at(2).home, -1);  // that of Z is not
    EXPECT_THAT(imported.left_out, ElementsAre("$32=1"));
    EXPECT_THAT(imported.warnings, testing::IsEmpty());
    EXPECT_EQ(machine::read_machine(machine_toml(imported, "m.txt").value(), "m.toml").value(),
              imported.machine);
}

TEST(GrblDump, ImportsPlannerRulesAndFourthAxis) {
    const ImportResult imported = import_text(
        std::string(kRouter) + "$11=0.020\n$12=0.004 (arc tolerance, mm)\n$103=10\n$113=3600\n$123=50\n");
    EXPECT_EQ(imported.machine.controller.corners.junction_deviation_mm, 0.02);
    EXPECT_EQ(imported.machine.controller.curves.arc_chord_tolerance_mm, 0.004);
    ASSERT_EQ(imported.machine.axes.size(), 4U);
    EXPECT_EQ(imported.machine.axes[3].letter, 'A');
    EXPECT_EQ(imported.machine.axes[3].max_speed, 60);
}

TEST(GrblDump, ConvertsStoredPointsFromUnitOfReports) {
    const ImportResult imported =
        import_text(std::string(kRouter) +
                    "$13=1\n[G54:1.000,-2.000,0.500]\n[G28:1.000,0.000,0.000]\n"
                    "[G92:0.000,0.000,0.000]\n[TLO:0.000]\n[PRB:0.000,0.000,0.000:0]\n");
    EXPECT_EQ(imported.data.offsets.at("54"), (machine::AxisValues{{'X', 25.4}, {'Y', -50.8}, {'Z', 12.7}}));
    EXPECT_NEAR(imported.data.variables.at(5161), 1, 1e-12);
    EXPECT_EQ(imported.data.variables.count(5210), 0U) << "a G92 of zeros is none";
    EXPECT_THAT(imported.left_out, ElementsAre("[TLO:0.000]", "[PRB:0.000,0.000,0.000:0]"));
}

TEST(GrblDump, RejectsInvalidDumpsWithLocation) {
    EXPECT_TRUE(is_grbl_dump("ok\n$110=500\n"));
    EXPECT_FALSE(is_grbl_dump("[machine]\nname = \"m\"\n"));
    EXPECT_EQ(import_grbl("$100=80\nhello\n", "router.txt").error().message,
              "router.txt:2: 'hello' is not a line of grbl's output for $$ and $#");
    EXPECT_EQ(import_grbl("$100=80\n$110=500\n", "router.txt").error().message,
              "router.txt: $120 is missing; axis X needs it");
    EXPECT_EQ(import_grbl("$100=80\n$110=0\n", "router.txt").error().message,
              "router.txt:2: $110, which axis X needs, must be greater than 0");
    EXPECT_EQ(import_grbl(std::string(kRouter) + "[G54:1.000]\n", "router.txt").error().message,
              "router.txt:17: '[G54:1.000]' must have numbers for its axes, separated by commas");
}

}  // namespace
}  // namespace gsim::import::grbl_dump_test
