// gsim-run --rcs: a controller module in place of the built-in planner.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/apps/run_program.h"

namespace gsim::apps::controller_module_test {
namespace {

using nlohmann::json;

constexpr const char* kPart = "G0 X50 Y20\nG1 X150 F6000\nG2 X150 Y120 J50\nG4 P1\nM8\nG1 X0 Y0\nM2\n";

class ControllerModule : public Apps {
  protected:
    static std::string test_module(const std::string& name) {
        return fmt::format("{}/{}.so", GSIM_TEST_MODULES, name);
    }
};

TEST_F(ControllerModule, OurOwnPlannerTakesTheTimeThatItTakesInProcess) {
    const std::string part = write("part.nc", kPart);
    const json built_in = json::parse(gsim_run({part, "--json"}).out);
    const Ended e = gsim_run({part, "--json", "--explain", "--rcs", GSIM_RCS_DEFAULT});
    ASSERT_EQ(e.status, 0) << e.err;
    const json module = json::parse(e.out);
    EXPECT_NEAR(module["cycle_time_s"].get<double>(), built_in["cycle_time_s"].get<double>(), 1e-6);
    EXPECT_NEAR(module["time"]["feed_s"].get<double>(), built_in["time"]["feed_s"].get<double>(), 0.005);
    EXPECT_EQ(module["moves"], built_in["moves"]);
    EXPECT_NEAR(module["events"][0]["t_s"].get<double>(), built_in["events"][0]["t_s"].get<double>(), 1e-6);
    EXPECT_EQ(module["time_by_limit"][0]["limited_by"], "unknown");
    EXPECT_TRUE(module["lower_bound_s"].is_null());
    EXPECT_TRUE(module["blends"].is_null()) << "a module does not tell where it leaves the way";
}

// The tip is led by the module where it offers that; who does not lead it is not moved as if it did.
TEST_F(ControllerModule, ItLeadsTheTip) {
    const std::string part = write("tip.nc",
                                   "T1\nG0 X300 Y300 Z200\nG43.4 H1\nG1 X400 B10 C20 F2000\n"
                                   "G2 X500 I50 B-20 C10\nG49\nM2\n");
    ASSERT_EQ(
        run_program(GSIM_DATA, {"data.txt", "set", "TOOL", "1", "LENGTH=50", "--create"}, folder_).status, 0);
    const auto run = [this](const std::string& program, const std::vector<std::string>& more) {
        std::vector<std::string> arguments{program, "--json", "--machine-data", "data.txt"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return json::parse(gsim_run(arguments).out);
    };
    const json built_in = run(part, {});
    ASSERT_EQ(built_in["status"], "completed") << built_in["alarm"];
    const json module = run(part, {"--rcs", GSIM_RCS_DEFAULT});
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
    EXPECT_EQ(without["alarm"]["message"], "this controller has no tool-centre-point control");
}

TEST_F(ControllerModule, OneThatCannotBeUsedIsAnErrorOfUsage) {
    const std::string part = write("part.nc", kPart);
    const auto refused = [&](const std::string& name, const std::string& why) {
        const Ended e = gsim_run({part, "--rcs", test_module(name)});
        EXPECT_EQ(e.status, 2) << name;
        EXPECT_TRUE(holds(e.err, why)) << e.err;
    };
    refused("crash_on_load",
            "the controller module crash_on_load.so crashed (signal 11) while it was loaded");
    refused("no_module", "no_module.so is no controller module: it has no gsim_rcs_version");
    refused("other_version", "version 3 of the interface");
    refused("no_initialize", "no_initialize.so does not offer the service Initialize");
    refused("there_is_none", "there_is_none.so");
}

TEST_F(ControllerModule, OneThatAnswersGarbageEndsTheRunWithAnAlarm) {
    const Ended e =
        gsim_run({write("part.nc", "G1 X10 F600\nM2\n"), "--quiet", "--rcs", test_module("nan_answer")});
    EXPECT_EQ(e.status, 1);
    EXPECT_TRUE(holds(e.err, "The controller module nan_answer.so answered GetNextStep with the value nan"))
        << e.err;
}

}  // namespace
}  // namespace gsim::apps::controller_module_test
