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
