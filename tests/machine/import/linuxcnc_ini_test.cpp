// INI files of LinuxCNC as machines.

#include "machine/import/linuxcnc_ini.h"

#include <filesystem>
#include <fstream>
#include <limits>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "base/os/input_file.h"
#include "machine/file/controller_file.h"
#include "machine/file/machine_file.h"
#include "machine/import/import_machine.h"
#include "tests/build_files/build_files.h"

namespace gsim::import::linuxcnc_ini_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string limits(const std::string& section, double range, double speed, double acceleration) {
    return fmt::format("[{}]\nMIN_LIMIT = {}\nMAX_LIMIT = {}\nMAX_VELOCITY = {}\nMAX_ACCELERATION = {}\n",
                       section, -range, range, speed, acceleration);
}

// The configuration with which the motion of samples/machines/linuxcnc-*.toml was recorded.
std::string recorded(double speed, double acceleration, double turn_acceleration, double path_speed) {
    std::string ini = fmt::format(
        "[KINS]\nKINEMATICS = trivkins coordinates=XYZBC\nJOINTS = 5\n"
        "[EMCMOT]\nSERVO_PERIOD = 1000000\n"
        "[TRAJ]\nCOORDINATES = X Y Z B C\nLINEAR_UNITS = mm\nANGULAR_UNITS = degree\nMAX_LINEAR_VELOCITY = "
        "{}\n",
        path_speed);
    for (const char letter : {'X', 'Y', 'Z'})
        ini += limits(fmt::format("AXIS_{}", letter), 10000, speed, acceleration);
    for (const char letter : {'B', 'C'})
        ini += limits(fmt::format("AXIS_{}", letter), 36000, 90, turn_acceleration);
    return ini;
}

ImportResult import_text(const std::string& ini) {
    const auto imported = import_linuxcnc(ini, "mill.ini");
    EXPECT_TRUE(imported) << imported.error().message;
    return imported.value_or(ImportResult{});
}

Result<ImportResult> import_file(const std::filesystem::path& path) {
    return os::read_text_file(path).and_then(
        [&](const std::string& text) { return import_machine(text, path); });
}

std::string error_of(const std::string& ini) {
    const auto imported = import_linuxcnc(ini, "mill.ini");
    return imported ? "no error" : imported.error().message;
}

// All values that decide on positions and times are those of the samples that match recordings.
TEST(LinuxcncIni, ImportOfRecordedMachinesMatchesSamples) {
    for (const auto& [name, ini] : {std::pair{"linuxcnc-gantry.toml", recorded(508, 490.3, 20, 2000)},
                                    std::pair{"linuxcnc-gantry254.toml", recorded(508, 490.3, 20, 254)},
                                    std::pair{"linuxcnc-router.toml", recorded(100, 1000, 200, 1000)}}) {
        machine::Machine machine = import_text(ini).machine;
        machine::Machine sample =
            machine::load_machine(tests::source_path("samples/machines/") + name).value();
        machine.name = sample.name;
        machine.program = sample.program;
        machine.process = sample.process;
        machine.times = sample.times;
        EXPECT_EQ(machine::print_machine(machine), machine::print_machine(sample)) << name;
    }
}

constexpr const char* kMill =
    "[EMC]\nMACHINE = My mill\n[KINS]\nKINEMATICS = trivkins\nJOINTS = 3\n"
    "[TRAJ]\nCOORDINATES = XYZ\nLINEAR_UNITS = inch\n";

std::string mill() {
    return std::string(kMill) + limits("AXIS_X", 3, 2, 20) + limits("AXIS_Y", 2, 2, 20) +
           limits("AXIS_Z", 2, 1, 10);
}

TEST(LinuxcncIni, ConvertsInchesAndSetsProgramUnit) {
    const machine::Machine machine = import_text(mill()).machine;
    EXPECT_EQ(machine.name, "My mill");
    EXPECT_EQ(machine.axes.at(0).max, 76.2);
    EXPECT_NEAR(machine.axes.at(0).max_speed, 50.8, 1e-12);
    EXPECT_NEAR(machine.axes.at(2).max_acceleration, 254, 1e-12);
    EXPECT_EQ(machine.program.units, machine::ProgramUnits::inch);
    EXPECT_EQ(machine.program.dialect, "linuxcnc");
    EXPECT_EQ(machine.inverse, machine::InverseKind::gantry);
}

TEST(LinuxcncIni, AxisHasNarrowerLimitsOfAxisAndJoint) {
    std::string ini = mill();
    ini.replace(ini.find("trivkins"), 8, "trivkins coordinates=XYYZ");
    ini.replace(ini.find("JOINTS = 3"), 10, "JOINTS = 4");
    ini += limits("JOINT_1", 1.5, 9, 90) + limits("JOINT_2", 5, 0.5, 90) + "HOME = 1\n" +
           limits("JOINT_3", 5, 0.7, 90) + "HOME = 1.5\n";
    const machine::Machine machine = import_text(ini).machine;
    EXPECT_EQ(machine.axes.at(1).max, 38.1);                  // of joint 1
    EXPECT_NEAR(machine.axes.at(1).max_speed, 12.7, 1e-12);   // of joint 2
    EXPECT_NEAR(machine.axes.at(2).max_speed, 17.78, 1e-12);  // of joint 3
    EXPECT_EQ(machine.axes.at(2).home, 38.1);
}

TEST(LinuxcncIni, ReadsNumberedAxesOfOldFiles) {
    const std::string ini = std::string(kMill) + limits("AXIS_0", 3, 2, 20) + limits("AXIS_1", 2, 2, 20) +
                            limits("AXIS_2", 1, 1, 10);
    EXPECT_EQ(import_text(ini).machine.axes.at(2).max, 25.4);
}

TEST(LinuxcncIni, ReportsZeroLimitsAndInvalidSettings) {
    std::string ini = mill();
    ini.replace(ini.find("MAX_VELOCITY = 2"), 16, "MAX_VELOCITY = 0");
    EXPECT_EQ(error_of(ini), "mill.ini:12: MAX_VELOCITY of [AXIS_X] must be greater than 0");
    ini = mill();
    ini.replace(ini.find("JOINTS = 3"), 10, "JOINTS = 1e300");
    EXPECT_EQ(import_text(ini).machine.axes.size(), 3U);
    for (const std::string_view setting :
         {"[TRAJ]\nARC_BLEND_OPTIMIZATION_DEPTH = 1e300\n", "[EMCMOT]\nSERVO_PERIOD = -5\n"}) {
        const auto imported = import_machine(mill() + std::string(setting), "mill.ini");
        ASSERT_FALSE(imported) << setting;
        EXPECT_THAT(imported.error().message,
                    testing::StartsWith("mill.ini: its settings do not make a valid machine: "));
    }
}

TEST(LinuxcncIni, ImportsPlannerTypesOfLinuxcnc210) {
    const auto of_traj = [](const std::string& traj, const std::string& axes = "") {
        return import_text(mill() + "[TRAJ]\n" + traj + axes);
    };
    const ImportResult straight = of_traj("PLANNER_TYPE = 0\nMAX_LINEAR_JERK = 500\n");
    EXPECT_EQ(straight.machine.controller, machine::built_in_controller("linuxcnc-2.10").value());
    EXPECT_EQ(straight.machine.path.max_jerk_mm_s3, std::numeric_limits<double>::infinity());

    const std::string jerks =
        "[AXIS_X]\nMAX_JERK = 500\n[AXIS_Y]\nMAX_JERK = 600\n[AXIS_Z]\nMAX_JERK = 700\n";
    const ImportResult curves = of_traj("PLANNER_TYPE = 1\nMAX_LINEAR_JERK = 400\n", jerks);
    EXPECT_TRUE(curves.machine.controller.ramps.limit_jerk);
    EXPECT_EQ(curves.machine.controller.model, "linuxcnc-2.10");
    EXPECT_NEAR(curves.machine.path.max_jerk_mm_s3, 400 * 25.4, 1e-6);
    EXPECT_NEAR(curves.machine.axes.at(1).max_jerk, 600 * 25.4, 1e-6);
    EXPECT_THAT(curves.warnings, testing::Not(Contains(HasSubstr("MAX_JERK"))));

    const ImportResult silent = of_traj("PLANNER_TYPE = 1\n");
    EXPECT_EQ(silent.machine.path.max_jerk_mm_s3, 1e9);
    EXPECT_THAT(silent.warnings, Contains(HasSubstr("does not use S-curves for moves of X, Y, Z")));
    EXPECT_EQ(of_traj("").machine.controller.model, "linuxcnc-2.9");
    const ImportResult pecks = of_traj("PLANNER_TYPE = 1\n[RS274NGC]\nG83_PECK_CLEARANCE = 0.05\n");
    EXPECT_NEAR(pecks.machine.controller.drilling.peck_clearance_mm, 0.05 * 25.4, 1e-9);
}

TEST(LinuxcncIni, ImportsOverrideRangesFromDisplay) {
    const auto overrides_of = [](const std::string& display) {
        return import_text("[DISPLAY]\n" + display + mill()).machine.controller.overrides;
    };
    const rrs::OverrideRules wide =
        overrides_of("MAX_FEED_OVERRIDE = 1.5\nMIN_SPINDLE_OVERRIDE = 0.25\nMAX_SPINDLE_OVERRIDE = 1.25\n");
    EXPECT_EQ(wide.feed_max_percent, 150);
    EXPECT_EQ(wide.planned_feed_percent, 150) << "junctions are planned for it";
    EXPECT_EQ(wide.spindle_min_percent, 25);
    EXPECT_EQ(wide.spindle_max_percent, 125);
    EXPECT_EQ(overrides_of("").feed_max_percent, 100);
}

TEST(LinuxcncIni, ReportsSettingsNotImported) {
    const ImportResult imported =
        import_text("[DISPLAY]\nDISPLAY = axis\nCYCLE_TIME = 0.1\n" + mill() +
                    "[TRAJ]\nARC_BLEND_ENABLE = 0\nARC_BLEND_OPTIMIZATION_DEPTH = "
                    "80\nMAX_LINEAR_JERK = 9\n"
                    "[JOINT_0]\nMAX_VELOCITY = 2\nMAX_ACCELERATION = 20\nTYPE = ANGULAR\nBACKLASH = 0.1\n"
                    "[RS274NGC]\nPARAMETER_FILE = none.var\nRS274NGC_STARTUP_CODE = G21 G64P0.01\n");
    EXPECT_EQ(imported.machine.controller.blocks.look_ahead, 80U);
    EXPECT_EQ(imported.machine.program.units, machine::ProgramUnits::mm);
    EXPECT_THAT(
        imported.warnings,
        ElementsAre(
            "[JOINT_0] TYPE = ANGULAR is not imported: axis X is linear",
            "[RS274NGC] RS274NGC_STARTUP_CODE = G21 G64P0.01 is not run before programs; only its units are "
            "imported",
            "[TRAJ] ARC_BLEND_ENABLE = 0 is not imported: the planner here is that of LinuxCNC with 1",
            "[RS274NGC] PARAMETER_FILE = none.var is not imported: cannot read 'none.var': No such file or "
            "directory"));
    EXPECT_THAT(imported.left_out,
                ElementsAre("[DISPLAY] DISPLAY, CYCLE_TIME", "[TRAJ] MAX_LINEAR_JERK", "[JOINT_0] BACKLASH"));
}

TEST(LinuxcncIni, RejectsOtherKinematicsByName) {
    std::string ini = mill();
    ini.replace(ini.find("trivkins"), 8, "scarakins");
    EXPECT_EQ(error_of(ini),
              "mill.ini:4: the kinematics 'scarakins' cannot be imported, only trivkins; write a machine "
              "file with its frames and copy the limits from here");
}

TEST(LinuxcncIni, ErrorsHaveSourceLocation) {
    EXPECT_EQ(error_of("[TRAJ]\nCOORDINATES = XYZ\nLINEAR_UNITS = furlong\n"),
              "mill.ini:3: LINEAR_UNITS is 'furlong'; allowed values are mm, metric, inch, in, imperial, cm");
    EXPECT_EQ(error_of("[TRAJ]\nfast\n"), "mill.ini:2: a line must be [SECTION], KEY = VALUE or a comment");
    EXPECT_EQ(error_of("[TRAJ\n"), "mill.ini:1: the section name has no ']'");
    EXPECT_EQ(error_of("[TRAJ]\nCOORDINATES = X\n[AXIS_X]\nMAX_VELOCITY = fast\nMAX_ACCELERATION = 1\n"),
              "mill.ini:4: MAX_VELOCITY is 'fast', which is not a number");
    EXPECT_EQ(error_of("[TRAJ]\nCOORDINATES = X\n"),
              "mill.ini: neither [AXIS_X] nor a section [JOINT_n] exists for axis X");
    EXPECT_EQ(error_of("#INCLUDE none.inc\n"),
              "mill.ini:1: cannot read 'none.inc': No such file or directory");
}

/// A folder with files; gone at the end.
class LinuxcncFiles : public testing::Test {
  protected:
    LinuxcncFiles()
        : folder_(std::filesystem::temp_directory_path() / fmt::format("gsim_ini_{}", ::getpid())) {
        std::filesystem::create_directories(folder_);
    }
    ~LinuxcncFiles() override {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
        return folder_ / name;
    }

    std::filesystem::path folder_;
};

TEST_F(LinuxcncFiles, ReadsTablesAndIncludedFiles) {
    write("limits.inc", limits("AXIS_X", 3, 2, 20) + limits("AXIS_Y", 2, 2, 20) + limits("AXIS_Z", 2, 1, 10));
    write("mill.var", "5221 1.5\n5222 -2\n5230 30\n5161 1\n31 7\n");
    write("mill.tbl", "T2 P5 Z1.25 D0.5 ; end mill\n");
    const auto path = write("mill.ini", std::string(kMill) +
                                            "#INCLUDE limits.inc\n[RS274NGC]\nPARAMETER_FILE = mill.var\n"
                                            "[EMCIO]\nTOOL_TABLE = mill.tbl\n");
    ASSERT_TRUE(is_controller_file("", path));
    const auto imported = import_file(path);
    ASSERT_TRUE(imported) << imported.error().message;
    EXPECT_EQ(imported->machine.axes.size(), 3U);
    EXPECT_TRUE(imported->has_data);
    const machine::AxisValues& offset = imported->data.offsets.at("54");
    EXPECT_NEAR(offset.at('X'), 38.1, 1e-12);
    EXPECT_NEAR(offset.at('Y'), -50.8, 1e-12);
    EXPECT_EQ(imported->data.variables.at(5230), 30);
    EXPECT_NEAR(imported->data.variables.at(5161), 1, 1e-12);  // inches here, whatever the machine has
    EXPECT_NEAR(imported->data.tools.at(2).length_mm, 31.75, 1e-12);
    EXPECT_THAT(imported->left_out, ElementsAre("mill.tbl: P5 of tool 2: magazine pockets"));
    EXPECT_THAT(machine_data_text(*imported).value(), HasSubstr("TOOL\n2  31.75  12.7\n"));
}

// Four files that name the next one forty times each are 2.5 million.
TEST_F(LinuxcncFiles, RejectsTooManyIncludes) {
    constexpr int kFiles = 4;
    for (int i = 0; i < kFiles; ++i) {
        std::string text;
        for (int line = 0; line < 40; ++line) text += fmt::format("#INCLUDE {}.inc\n", i + 1);
        write(fmt::format("{}.inc", i), text);
    }
    write(fmt::format("{}.inc", kFiles), "");
    const auto imported = import_file(write("mill.ini", mill() + "#INCLUDE 0.inc\n"));
    ASSERT_FALSE(imported);
    EXPECT_THAT(imported.error().message, testing::EndsWith("more than 1000 files are included"));
}

// The machine file reads back as the machine, and names its source.
TEST_F(LinuxcncFiles, MachineFileReadsBackEqualAndNamesSource) {
    const auto path = write("mill.ini", mill() + "[HAL]\nHALFILE = a.hal\n");
    const auto imported = import_file(path);
    ASSERT_TRUE(imported) << imported.error().message;
    const auto toml = machine_toml(*imported, path);
    ASSERT_TRUE(toml) << toml.error().message;
    EXPECT_EQ(machine::read_machine(*toml, "mill.toml").value(), imported->machine);
    EXPECT_THAT(*toml, testing::StartsWith("# Made from mill.ini.\n#\n# Not imported:\n#   [HAL] HALFILE\n"));
    EXPECT_THAT(*toml, HasSubstr("units = \"inch\"\n"));
}

}  // namespace
}  // namespace gsim::import::linuxcnc_ini_test
