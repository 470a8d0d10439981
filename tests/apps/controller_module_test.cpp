// gsim-run --rcs: a controller module in place of the built-in planner.

#include <csignal>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/format.h>

#include "base/os/spawn.h"
#include "base/text/json.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"
#include "tests/support/soon.h"

namespace gsim::apps::controller_module_test {
namespace {

using nlohmann::json;

constexpr const char* kPart = "G0 X50 Y20\nG1 X150 F6000\nG2 X150 Y120 J50\nG4 P1\nM8\nG1 X0 Y0\nM2\n";

class ControllerModule : public Apps {
  protected:
    static std::string sample(const std::string& name) { return tests::source_path("samples/") + name; }
    Ended run(std::vector<std::string> arguments, const std::vector<std::string>& more) const {
        arguments.insert(arguments.end(), more.begin(), more.end());
        return gsim_run(arguments);
    }
    static std::string test_module(const std::string& name) {
        return tests::build_path("lib/test_modules/") + name + ".so";
    }
};

TEST_F(ControllerModule, DefaultModuleMatchesBuiltInPlanner) {
    const std::string part = write("part.nc", kPart);
    const json built_in = text::parse_json<json>(gsim_run({part, "--json"}).out);
    const Ended e = gsim_run({part, "--json", "--explain", "--rcs", tests::default_module_path()});
    ASSERT_EQ(e.status, 0) << e.err;
    const json module = text::parse_json<json>(e.out);
    EXPECT_NEAR(module["cycle_time_s"].get<double>(), built_in["cycle_time_s"].get<double>(), 1e-6);
    EXPECT_NEAR(module["time"]["feed_s"].get<double>(), built_in["time"]["feed_s"].get<double>(), 0.005);
    EXPECT_EQ(module["moves"], built_in["moves"]);
    EXPECT_NEAR(module["events"][0]["t_s"].get<double>(), built_in["events"][0]["t_s"].get<double>(), 1e-6);
    EXPECT_EQ(module["time_by_limit"][0]["limited_by"], "unknown");
    EXPECT_TRUE(module["lower_bound_s"].is_null());
    EXPECT_TRUE(module["blends"].is_null()) << "a module does not tell where it leaves the way";
}

// The module controls the TCP if it offers that. A module without TCP control is not moved as if it had it.
TEST_F(ControllerModule, UsesTcpControlIfModuleOffersIt) {
    const std::string part = write("tip.nc",
                                   "T1\nG0 X300 Y300 Z200\nG43.4 H1\nG1 X400 B10 C20 F2000\n"
                                   "G2 X500 I50 B-20 C10\nG49\nM2\n");
    ASSERT_EQ(run_program(tests::program_path("gsim-data"),
                          {"data.txt", "set", "TOOL", "1", "LENGTH=50", "--create"}, folder_)
                  .status,
              0);
    const auto run = [this](const std::string& program, const std::vector<std::string>& more) {
        std::vector<std::string> arguments{program, "--json", "--machine-data", "data.txt"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return text::parse_json<json>(gsim_run(arguments).out);
    };
    const json built_in = run(part, {});
    ASSERT_EQ(built_in["status"], "completed") << built_in["alarm"];
    const json module = run(part, {"--rcs", tests::default_module_path()});
    EXPECT_EQ(module["status"], "completed") << module["alarm"];
    EXPECT_NEAR(module["cycle_time_s"].get<double>(), built_in["cycle_time_s"].get<double>(), 1e-6);
    for (const char* axis : {"X", "Y", "Z"}) {
        EXPECT_NEAR(module["bounds"][axis]["min"].get<double>(),
                    built_in["bounds"][axis]["min"].get<double>(), 0.01);
        EXPECT_NEAR(module["bounds"][axis]["max"].get<double>(),
                    built_in["bounds"][axis]["max"].get<double>(), 0.01);
    }
    const json without = run(write("feed.nc", "T1\nG1 X100 F2000\nG43.4 H1\nG1 X200 B10\nM2\n"),
                             {"--rcs", test_module("small_module")});
    EXPECT_EQ(without["alarm"]["message"], "this controller does not support TCP control");
}

TEST_F(ControllerModule, ReportsUnusableModuleAsUsageError) {
    const std::string part = write("part.nc", kPart);
    const auto rejected = [&](const std::string& name, const std::string& reason) {
        const Ended e = gsim_run({part, "--rcs", test_module(name)});
        EXPECT_EQ(e.status, 2) << name;
        EXPECT_TRUE(contains(e.err, reason)) << e.err;
    };
    rejected("crash_on_load",
             "the controller module crash_on_load.so crashed (signal 11) while it was loaded");
    rejected("no_module", "no_module.so is not a controller module: it has no gsim_rcs_version");
    rejected("other_version", "version 3 of the interface");
    rejected("no_initialize", "no_initialize.so does not support the service Initialize");
    rejected("there_is_none", "there_is_none.so");
}

TEST_F(ControllerModule, RaisesAlarmOnInvalidResponse) {
    const Ended e =
        gsim_run({write("part.nc", "G1 X10 F600\nM2\n"), "--quiet", "--rcs", test_module("nan_answer")});
    EXPECT_EQ(e.status, 1);
    EXPECT_TRUE(e.err.starts_with("part.nc:1: alarm: ")) << e.err;
    for (const char* part : {"nan_answer.so", "GetNextStep with the value nan", "joint 4"})
        EXPECT_TRUE(contains(e.err, part)) << part << '\n' << e.err;
}

TEST_F(ControllerModule, RejectsMissingHostButRunsInProcess) {
    const std::string part = write("part.nc", kPart);
    const std::string standalone = folder_ / "gsim";
    std::filesystem::copy_file(std::filesystem::canonical(tests::program_path("gsim")), standalone);
    std::vector<std::string> arguments{"run", "--quiet", part, "--rcs", tests::default_module_path()};
    const Ended rejected = run_program(standalone, arguments, folder_);
    EXPECT_EQ(rejected.status, 2);
    EXPECT_TRUE(contains(rejected.err, "the program gsim-rcs-host is neither in '")) << rejected.err;
    EXPECT_TRUE(contains(rejected.err, "(--rcs-in-process does not require it)")) << rejected.err;
    arguments.emplace_back("--rcs-in-process");
    EXPECT_EQ(run_program(standalone, arguments, folder_).status, 0);
}

/// Programs for machines with a turning tool: heads, tables, arms; with joints, poses and TCP control.
struct Case {
    const char* name;
    const char* machine;
    const char* program;  ///< A sample, or a text with an ending in front: "lua:F(100)".
};

constexpr const char* kArmByJoints =
    "nc:G0 A10 B-30 C20 U30 V40 W50\nG1 A40 B-40 C40 U0 V60 W0 F3000\nG4 P0.5\n"
    "G1 A-20 B-40 C30 U20 V30 W90\nG93 G1 A0 B-30 F30\nM2\n";
constexpr const char* kArmByPoses =
    "lua:F(6000)\nMoveJoint{x=500,y=200,z=300,roll=0,pitch=180,yaw=0}\n"
    "MoveLinear{x=500,y=-200,z=300,roll=30,pitch=180,yaw=0}\n"
    "MoveCircular{via={x=600,y=0,z=300,roll=0,pitch=180,yaw=0},"
    " to={x=500,y=200,z=300,roll=0,pitch=180,yaw=0}}\n"
    "G4{p=0.2}\nMoveJoint{x=400,y=300,z=400,roll=0,pitch=170,yaw=10}\n";
constexpr const char* kHeadByPoses =
    "lua:F(3000)\nMoveLinear{x=300,y=250,z=200,roll=0,pitch=0,yaw=0}\n"
    "MoveLinear{x=400,y=280,z=220,roll=0,pitch=20,yaw=0}\n"
    "MoveCircular{via={x=450,y=300,z=220,roll=0,pitch=10,yaw=0},"
    " to={x=400,y=320,z=220,roll=0,pitch=0,yaw=0}}\n";
constexpr const char* kMillByPoses =
    "lua:F(3000)\nMoveLinear{x=100,y=50,z=200,roll=0,pitch=0,yaw=0}\n"
    "MoveLinear{x=200,y=80,z=220,roll=0,pitch=20,yaw=0}\n";

class RotaryMachines : public ControllerModule, public testing::WithParamInterface<Case> {
  protected:
    std::string program() const {
        const std::string text = GetParam().program;
        const std::size_t colon = text.find(':');
        if (colon == std::string::npos) return sample(text);
        return write("part." + text.substr(0, colon), text.substr(colon + 1));
    }
    /// A table of numbers that was written as CSV.
    std::vector<std::vector<double>> table(const std::string& name) const {
        std::vector<std::vector<double>> rows;
        std::istringstream lines(read(name));
        std::string line;
        for (std::getline(lines, line); std::getline(lines, line);) {
            std::istringstream fields(line);
            std::vector<double>& row = rows.emplace_back();
            for (std::string field; std::getline(fields, field, ',');)
                row.push_back(field.empty() ? 0 : std::stod(field));
        }
        return rows;
    }
    /// Returns the moves that take at least a step: of shorter ones a module may show one, or none.
    std::vector<json> long_moves(const std::string& name) const {
        std::vector<json> moves;
        std::istringstream lines(read(name));
        for (std::string line; std::getline(lines, line);) {
            json move = text::parse_json<json>(line);
            if (move["end_s"].get<double>() - move["start_s"].get<double>() >= kStep_s)
                moves.push_back(std::move(move));
        }
        return moves;
    }
    void expect_same_moves() const {
        const std::vector<json> built_in = long_moves("a.moves"), module = long_moves("b.moves");
        ASSERT_EQ(built_in.size(), module.size());
        for (std::size_t i = 0; i < built_in.size(); ++i) {
            EXPECT_EQ(built_in[i]["line"], module[i]["line"]);
            for (const char* const instant : {"start_s", "end_s"}) {
                EXPECT_NEAR(built_in[i][instant].get<double>(), module[i][instant].get<double>(),
                            kStep_s * 1.001)
                    << module[i];
            }
        }
    }

    static constexpr double kStep_s = 0.001;
};

TEST_P(RotaryMachines, ModuleMatchesBuiltInPlanner) {
    const std::string part = program();
    const std::vector<std::string> usual{part, "--machine",
                                         sample(std::string("machines/") + GetParam().machine), "--json"};
    const Ended a = run(usual, {"--trajectory", "a.csv", "--moves", "a.moves"});
    const Ended b =
        run(usual, {"--trajectory", "b.csv", "--moves", "b.moves", "--rcs", tests::default_module_path()});
    const json built_in = text::parse_json<json>(a.out), module = text::parse_json<json>(b.out);
    ASSERT_EQ(module["alarm"], nullptr) << b.out;
    EXPECT_EQ(module["status"], built_in["status"]);
    EXPECT_NEAR(module["cycle_time_s"].get<double>(), built_in["cycle_time_s"].get<double>(), 1e-6);
    expect_same_moves();
    const auto exact = table("a.csv"), stepped = table("b.csv");
    ASSERT_EQ(exact.size(), stepped.size());
    ASSERT_GT(exact.size(), 100U);
    for (std::size_t row = 0; row < exact.size(); ++row) {
        for (std::size_t axis = 2; axis + 1 < exact[row].size(); ++axis)
            ASSERT_NEAR(exact[row][axis], stepped[row][axis], 0.01) << "at " << exact[row][0] << " s";
    }
}

TEST_P(RotaryMachines, OutputsMatchModuleInProcess) {
    const std::string part = program();
    const std::vector<std::string> usual{
        part,     "--machine", sample(std::string("machines/") + GetParam().machine),
        "--json", "--rcs",     tests::default_module_path()};
    const Ended own = run(usual, {"--trajectory", "a.csv", "--moves", "a.moves"});
    const Ended current = run(usual, {"--trajectory", "b.csv", "--moves", "b.moves", "--rcs-in-process"});
    EXPECT_EQ(own.status, current.status);
    EXPECT_EQ(own.out, current.out);
    EXPECT_EQ(read("a.csv"), read("b.csv"));
    EXPECT_EQ(read("a.moves"), read("b.moves"));
}

INSTANTIATE_TEST_SUITE_P(Machines, RotaryMachines,
                         testing::Values(Case{"wheel", "af5.toml", "wheel.nc"},
                                         Case{"dome", "mill-head-table.toml", "mill/dome.nc"},
                                         Case{"turntable", "mill-table-table.toml", "mill/turntable.nc"},
                                         Case{"arm_by_joints", "arm6.toml", kArmByJoints},
                                         Case{"arm_by_poses", "arm6.toml", kArmByPoses},
                                         Case{"gantry_by_poses", "af5.toml", kHeadByPoses},
                                         Case{"offset_head_by_poses", "gantry-offset-head.toml",
                                              kHeadByPoses},
                                         Case{"mill_by_poses", "mill-head-table.toml", kMillByPoses}),
                         [](const auto& param) { return std::string(param.param.name); });

// The module has the machine's ranges, too, and says so in joints and rad.
TEST_F(ControllerModule, ReportsAxisOfTargetBeyondLimit) {
    const std::string part = write("part.nc", "G1 A10 B-60 F3000\nM2\n");
    const json report =
        text::parse_json<json>(gsim_run({part, "--json", "--machine", sample("machines/arm6.toml"), "--rcs",
                                         tests::default_module_path()})
                                   .out);
    EXPECT_EQ(report["alarm"]["message"], "axis B would move to -60 deg, past its limit of -45 deg");
    EXPECT_EQ(report["alarm"]["axis"], "B");
}

/// Module that damages its own process, but not that of the program.
class HostileModule : public ControllerModule {
  protected:
    HostileModule() {
        std::string text;
        for (int i = 1; i <= 50; ++i) text += fmt::format("G1 X{} F6000\n", i);  // 10 ms each
        part_ = write("part.nc", text + "M2\n");
    }
    /// A path to a module that no other program has.
    std::string own_path(const std::string& module) const {
        const std::filesystem::path link = folder_ / (module + ".so");
        std::filesystem::create_symlink(test_module(module), link);
        return link;
    }
    static bool is_running(const std::string& module) {
        for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
            std::ifstream file(entry.path() / "cmdline");
            const std::string line{std::istreambuf_iterator<char>(file), {}};
            if (contains(line, "gsim-rcs-host") && contains(line, module)) return true;
        }
        return false;
    }
    std::string part_;
};

TEST_F(HostileModule, CrashRaisesAlarmAndKeepsEarlierMoves) {
    const Ended e = gsim_run(
        {part_, "--json", "--moves", "moves", "--trajectory", "way.csv", "--rcs", test_module("crashes")});
    EXPECT_EQ(e.status, 1);
    const json report = text::parse_json<json>(e.out);
    EXPECT_EQ(report["status"], "alarm");
    EXPECT_EQ(report["alarm"]["message"],
              "The controller module crashes.so crashed in GetNextStep (signal 11).");
    EXPECT_EQ(report["alarm"]["file"], part_);
    EXPECT_GT(report["alarm"]["line"], 0);
    EXPECT_NEAR(report["cycle_time_s"].get<double>(), 0.05, 1e-9) << "50 steps of 1 ms";
    EXPECT_TRUE(contains(read("moves"), "\"to\":{\"X\":4,"));
    EXPECT_TRUE(contains(read("way.csv"), "\n0.05,"));
}

TEST_F(HostileModule, PrintedTextIsNotInReport) {
    const Ended e = gsim_run({part_, "--json", "--rcs", test_module("prints")});
    EXPECT_EQ(e.status, 0) << e.err;
    EXPECT_EQ(text::parse_json<json>(e.out)["status"], "completed");
    EXPECT_TRUE(contains(e.err, "rubbish"));
}

TEST_F(HostileModule, InterruptedRunLeavesNoProcess) {
    const std::string module = own_path("hangs");
    for (const int signal : {SIGINT, SIGKILL}) {
        const auto run = os::spawn(
            {tests::program_path("gsim-run"), (folder_ / part_).string(), "--quiet", "--rcs", module}, {});
        ASSERT_TRUE(run);
        EXPECT_TRUE(tests::soon([&] { return is_running(module); })) << signal;
        ::kill(*run, signal);
        os::wait_for(*run);
        EXPECT_TRUE(tests::soon([&] { return !is_running(module); })) << signal;
    }
}

}  // namespace
}  // namespace gsim::apps::controller_module_test
