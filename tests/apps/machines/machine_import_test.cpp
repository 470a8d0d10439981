// Settings of controls as machines: gsim-data import, gsim-run --machine mill.ini; against recordings.

#include <cstdlib>
#include <fstream>

#include <fmt/format.h>

#include "base/text/json.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::machine_import_test {
namespace {

using nlohmann::json;

class MachineImport : public Apps {
  protected:
    json report(std::vector<std::string> arguments, int status = 0) const {
        arguments.push_back("--json");
        const Ended e = gsim_run(arguments);
        EXPECT_EQ(e.status, status) << e.err;
        return text::try_parse_json<json>(e.out);
    }
    static std::string sample(const std::string& name) { return tests::source_path("samples/") + name; }
};

std::string section(const std::string& name, double range, double speed, double acceleration) {
    return fmt::format("[{}]\nMIN_LIMIT = {}\nMAX_LIMIT = {}\nMAX_VELOCITY = {}\nMAX_ACCELERATION = {}\n",
                       name, -range, range, speed, acceleration);
}

// The configuration of the recordings of the gantry.
std::string gantry_ini() {
    std::string ini =
        "[EMC]\nMACHINE = gantry\n[KINS]\nKINEMATICS = trivkins coordinates=XYZBC\nJOINTS = 5\n"
        "[EMCMOT]\nSERVO_PERIOD = 1000000\n[TRAJ]\nCOORDINATES = X Y Z B C\nLINEAR_UNITS = mm\n"
        "MAX_LINEAR_VELOCITY = 2000\n[RS274NGC]\nPARAMETER_FILE = gantry.var\n[EMCIO]\nTOOL_TABLE = "
        "gantry.tbl\n"
        "[HAL]\nHALFILE = a.hal\n";
    for (const char* letter : {"X", "Y", "Z"})
        ini += section(fmt::format("AXIS_{}", letter), 10000, 508, 490.3);
    for (const char* letter : {"B", "C"}) ini += section(fmt::format("AXIS_{}", letter), 36000, 90, 20);
    return ini;
}

TEST_F(MachineImport, RunsIniWithOffsetsAndTools) {
    write("gantry.ini", gantry_ini());
    write("gantry.var", "5221 100\n5222 50\n5230 90\n");
    write("gantry.tbl", "T1 P1 Z20 D6\n");
    write("part.ngc", "G21 G54 T1 M6\nG43 H1\nG0 X10 Y0 Z0\nM2\n");
    const Ended e = gsim_run({"--machine", "gantry.ini", "--json", "part.ngc"});
    EXPECT_EQ(e.status, 0) << e.err;
    const json r = text::try_parse_json<json>(e.out);
    EXPECT_EQ(r["machine"], "gantry");
    EXPECT_NEAR(r["bounds"]["X"]["max"].get<double>(), 100, 1e-9) << "turned by 90 degrees, X goes along Y";
    EXPECT_NEAR(r["bounds"]["Y"]["max"].get<double>(), 60, 1e-9);
    EXPECT_NEAR(r["bounds"]["Z"]["max"].get<double>(), 20, 1e-9);
    EXPECT_EQ(std::string(r["diagnostics"][0]["text"]),
              "gantry.ini: lines that are not imported: 1; gsim-data import gantry.ini lists them");
}

TEST_F(MachineImport, ImportedMachineFileRunsLikeIni) {
    write("gantry.ini", gantry_ini());
    write("gantry.var", "5221 100\n5161 7\n");
    write("gantry.tbl", "T1 P1 Z20 D6\n");
    const Ended e = gsim_data({"import", "gantry.ini", "-o", "gantry.toml", "--data", "gantry.txt"});
    EXPECT_EQ(e.status, 0) << e.err;
    EXPECT_EQ(e.err, "gantry.ini: note: not imported: [HAL] HALFILE\n");
    EXPECT_TRUE(
        contains(read("gantry.toml"), "# Made from gantry.ini.\n#\n# Not imported:\n#   [HAL] HALFILE\n"));
    write("part.ngc", "G21 T1 M6\nG43 H1\nG1 X10 Y5 Z0 F3000\nG28\nM2\n");
    json direct = report({"--machine", "gantry.ini", "part.ngc"});
    json imported = report({"--machine", "gantry.toml", "--machine-data", "gantry.txt", "part.ngc"});
    EXPECT_NEAR(direct["bounds"]["X"]["max"].get<double>(), 110, 1e-9);
    for (const char* key : {"cycle_time_s", "bounds", "length"}) EXPECT_EQ(direct[key], imported[key]) << key;
}

TEST_F(MachineImport, ConvertsTablesToMachineData) {
    write("mill.tbl", "T3 P3 Z1.5 D0.25\n");
    const Ended tools = gsim_data({"import", "--inch", "mill.tbl", "-o", "tools.txt"});
    EXPECT_EQ(tools.status, 0) << tools.err;
    EXPECT_EQ(gsim_data({"tools.txt", "get", "TOOL", "3", "LENGTH"}).out, "38.1\n");
    write("mill.var", "5241 12.5\n5245 90\n");
    const Ended offsets = gsim_data({"import", "mill.var", "-o", "offsets.txt"});
    EXPECT_EQ(offsets.status, 0) << offsets.err;
    EXPECT_EQ(offsets.err, "mill.var: note: not imported: B of G55: the machine does not have this axis\n");
    EXPECT_EQ(gsim_data({"offsets.txt", "get", "OFFSET", "55", "X"}).out, "12.5\n");
}

// Of a machine file, for the same diagnostics as of imported settings.
TEST_F(MachineImport, WarnsOfOldKeyNames) {
    write("old.toml",
          read(sample("machines/grbl-router.toml")) + "[calibration]\nruns = 2\nleft_percent = 0.5\n");
    write("part.ngc", "G21 G0 X10\nM2\n");
    const json found = report({"--machine", "old.toml", "part.ngc"})["diagnostics"][0];
    EXPECT_EQ(found["severity"], "warning");
    EXPECT_EQ(found["code"], "machine");
    EXPECT_EQ(found["file"], "old.toml");
    EXPECT_TRUE(contains(found["text"], "residual_percent")) << found;
    for (const Ended& ended :
         {gsim_run({"--machine", "old.toml", "part.ngc"}), gsim_run({"--check-machine", "old.toml"})})
        EXPECT_TRUE(contains(ended.err, "old.toml:") && contains(ended.err, "left_percent")) << ended.err;
}

TEST_F(MachineImport, ReadsGrblSettings) {
    write("router.txt",
          "$11=0.010\n$12=0.002\n$22=0\n$100=250\n$101=250\n$102=250\n$110=6000\n$111=6000\n$112=6000\n$120="
          "1000\n"
          "$121=1000\n$122=1000\n$130=300\n$131=300\n$132=80\n[G54:5.000,0.000,0.000]\nok\n");
    write("part.nc", "G21 G90\nG1 X20 F3000\nX20 Y20\nG2 X40 Y20 I10\nM30\n");
    const json imported = report({"--machine", "router.txt", "part.nc"});
    EXPECT_NEAR(imported["bounds"]["X"]["max"].get<double>(), 45, 1e-6);
    write("shift.txt", "NCFILE\nOFFSET\n54 5 0 0\nENDFILE\n");
    const json by_sample = report({"--machine", sample("machines/grbl-router.toml"), "--dialect", "rs274ngc",
                                   "--machine-data", "shift.txt", "part.nc"});
    EXPECT_EQ(imported["cycle_time_s"], by_sample["cycle_time_s"]);
    EXPECT_EQ(gsim_data({"import", "router.txt", "-o", "router.toml"}).status, 0);
}

TEST_F(MachineImport, ReportsInvalidFilesAndCommands) {
    EXPECT_EQ(gsim_data({"import"}).err, "gsim-data: import requires a file: gsim-data import mill.ini\n");
    write("notes.txt", "hello\n");
    EXPECT_EQ(gsim_data({"import", "notes.txt"}).err,
              "gsim-data: 'notes.txt' is not a LinuxCNC .ini, .tbl or .var, and has no lines of grbl's "
              "response to $$ ($110=500.000)\n");
    write("arm.ini", "[KINS]\nKINEMATICS = genserkins\n[TRAJ]\nCOORDINATES = XYZ\n");
    const Ended e = gsim_run({"--machine", "arm.ini", write("part.nc", "G0 X1\n")});
    EXPECT_EQ(e.status, 2);
    EXPECT_TRUE(contains(e.err, "arm.ini:2: the kinematics 'genserkins' cannot be imported")) << e.err;
    EXPECT_EQ(gsim_data({"list"}).err, "gsim-data: FILE is required: the machine data (NCFILE)\n");
}

// Cycle times by the INI file of the recordings are those by the sample machine, which accuracy is measured
// with.
TEST_F(MachineImport, RecordedProgramsMatchTimesOfSample) {
    const char* folder = std::getenv("GSIM_REFERENCE");
    if (folder == nullptr) GTEST_SKIP() << "no recordings (GSIM_REFERENCE)";
    write("gantry.ini", gantry_ini());
    int compared = 0;
    for (const char* name : {"gantry_arc90_r30", "gantry_contour46", "gantry_square_g64p05",
                             "gantry_line_long", "gantry_circle_r20_g64"}) {
        const std::string program = fmt::format("{}/linuxcnc/{}.ngc", folder, name);
        std::ifstream recorded(fmt::format("{}/linuxcnc/{}.json", folder, name));
        if (!recorded) continue;
        const json by_ini = report({"--machine", "gantry.ini", program});
        const json by_sample =
            report({"--machine", sample("machines/linuxcnc-gantry.toml"), "--dialect", "rs274ngc", program});
        EXPECT_EQ(by_ini["cycle_time_s"], by_sample["cycle_time_s"]) << name;
        const double measured_s = text::parse_json<json>(recorded)["cycle_time_s"].get<double>();
        EXPECT_NEAR(by_ini["cycle_time_s"].get<double>(), measured_s, 0.005 * measured_s) << name;
        ++compared;
    }
    if (compared == 0) GTEST_SKIP() << "no recordings in " << folder;
}

}  // namespace
}  // namespace gsim::apps::machine_import_test
