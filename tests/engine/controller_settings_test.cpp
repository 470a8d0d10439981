#include "engine/controller_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/memory_files.h"

namespace gsim::engine::control_settings_test {
namespace {

using testing::HasSubstr;

const std::string kGrbl =
    "$100=250.000\n$101=250.000\n$102=250.000\n$110=5000.000\n$111=5000.000\n$112=500.000\n$120=100.000\n$"
    "121=100.000\n$122=10.000\n"
    "$130=200.000\n$131=200.000\n$132=200.000\n$3=1\n";

std::string ini() {
    std::string text =
        "[TRAJ]\nCOORDINATES = X Y Z\nLINEAR_UNITS = mm\n[KINS]\nJOINTS = 3\n"
        "[EMCIO]\nTOOL_TABLE = tables/mill.tbl\n";
    for (const char* joint : {"0", "1", "2"})
        text += std::string("[JOINT_") + joint +
                "]\nTYPE = LINEAR\nMIN_LIMIT = -100\nMAX_LIMIT = 100\nMAX_VELOCITY = 50\n"
                "MAX_ACCELERATION = 500\n";
    return text;
}

tl::expected<ControllerSettings, Error> read(const std::string& text, const std::string& name,
                                             std::map<std::string, std::string> files = {},
                                             const ControllerSettings::TableOptions& options = {}) {
    return ControllerSettings::read(text, name, given(std::move(files)), options);
}

TEST(ControllerSettings, GrblSettingsBecomeMachineFile) {
    const auto settings = read(kGrbl, "grbl.txt");
    ASSERT_TRUE(settings) << settings.error().message;
    EXPECT_THAT(settings->machine_file(), HasSubstr("# Made from grbl.txt."));
    EXPECT_FALSE(settings->has_machine_data());
    Request request = make_request("p.nc", {{"m.toml", settings->machine_file()}});
    request.machine = "m.toml";
    EXPECT_TRUE(Machine::read(request));
}

TEST(ControllerSettings, ReadsNamedTablesFromGivenFiles) {
    const auto settings = read(ini(), "mill/mill.ini", {{"mill/tables/mill.tbl", "T1 P1 Z10 D5\n"}});
    ASSERT_TRUE(settings) << settings.error().message;
    EXPECT_TRUE(settings->has_machine_data());
    EXPECT_THAT(settings->machine_data().value(), HasSubstr("TOOL\n1  10  5"));
}

TEST(ControllerSettings, ConvertsTableToMachineDataByItsUnit) {
    const auto settings = read("T1 P1 Z1\n", "mill.tbl", {}, {.unit = LengthUnit::inch});
    ASSERT_TRUE(settings) << settings.error().message;
    EXPECT_EQ(settings->machine_file(), "");
    EXPECT_THAT(settings->machine_data().value(), HasSubstr("TOOL\n1  25.4"));
    EXPECT_TRUE(ControllerSettings::is_table("a/MILL.TBL"));
    EXPECT_FALSE(ControllerSettings::is_table("mill.ini"));
}

TEST(ControllerSettings, ReportsSettingsNotImported) {
    const auto settings = read(ini() + "[HAL]\nHALFILE = a.hal\n", "mill.ini", {{"tables/mill.tbl", ""}});
    ASSERT_TRUE(settings) << settings.error().message;
    const std::vector<Diagnostic>& reported = settings->left_out();
    const auto hal = std::find_if(reported.begin(), reported.end(), [](const Diagnostic& each) {
        return each.text.find("HALFILE") != std::string::npos;
    });
    ASSERT_NE(hal, reported.end());
    EXPECT_EQ(hal->severity, Severity::note);
    EXPECT_EQ(hal->file, "mill.ini");
    EXPECT_THAT(hal->text, testing::StartsWith("not imported: "));
}

TEST(ControllerSettings, RejectsOtherText) {
    const auto settings = read("hello\n", "a.txt");
    ASSERT_FALSE(settings);
    EXPECT_EQ(settings.error().message,
              "'a.txt' is not a LinuxCNC .ini, .tbl or .var, and has no lines of grbl's response to $$ "
              "($110=500.000)");
}

}  // namespace
}  // namespace gsim::engine::control_settings_test
