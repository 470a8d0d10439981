// The operator's overrides on the command line: what they make of times, their ranges, and their file.

#include <string>
#include <vector>

#include "base/text/json.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::overrides_test {
namespace {

using nlohmann::json;

const std::string kMachines = tests::source_path("samples/machines/");
const std::string kProgram = "G21 G90 G61\nG1 X100 F3000\nM2\n";

class OverrideOption : public Apps {
  protected:
    Ended run(const std::string& machine, const std::vector<std::string>& more) const {
        std::vector<std::string> all{write("part.ngc", kProgram), "--dialect", "rs274ngc", "--machine",
                                     kMachines + machine + ".toml"};
        all.insert(all.end(), more.begin(), more.end());
        return gsim_run(all);
    }
    double time_s(const std::string& machine, std::vector<std::string> more) const {
        more.emplace_back("--json");
        const Ended e = run(machine, more);
        EXPECT_EQ(e.status, 0) << e.err;
        const json report = text::try_parse_json<json>(e.out);
        return report.is_discarded() ? 0 : report["cycle_time_s"].get<double>();
    }
    void rejected(const std::string& machine, const std::vector<std::string>& more, const std::string& text) {
        const Ended e = run(machine, more);
        EXPECT_EQ(e.status, 2);
        EXPECT_TRUE(contains(e.err, text)) << e.err;
    }
    void refused_file(const std::string& toml, const std::string& text) {
        rejected("router3", {"--overrides", write("turned.toml", toml)}, text);
    }
};

// 100 mm at 50 mm/s, or at 25, with 1000 mm/s2.
TEST_F(OverrideOption, FeedOverrideGivesClosedFormTime) {
    EXPECT_NEAR(time_s("grbl-router", {}), 2 + 0.05, 1e-6);
    EXPECT_NEAR(time_s("grbl-router", {"--feed-override", "50"}), 4 + 0.025, 1e-6);
    EXPECT_NEAR(time_s("grbl-router", {"--feed-override", "150"}), 100 / 75.0 + 0.075, 1e-6);
    EXPECT_NEAR(time_s("linuxcnc-router", {"--feed-override", "50"}), 4 + 0.025, 0.004);
}

TEST_F(OverrideOption, ReportHasOverridesOnlyIfSet) {
    const json plain = text::parse_json<json>(run("router3", {"--json"}).out);
    EXPECT_FALSE(plain.contains("overrides"));
    const json overridden = text::parse_json<json>(run("router3", {"--json", "--feed-override", "55"}).out);
    const json expected_value =
        text::parse_json<json>(R"({"changes": [{"at_s": 0.0, "feed_percent": 55.0, "rapid_percent": 100.0,
        "spindle_percent": 100.0}], "feed_locked_s": 0.0, "rapid_locked_s": 0.0, "spindle_locked_s": 0.0})");
    EXPECT_EQ(overridden["overrides"], expected_value);
    EXPECT_TRUE(contains(run("router3", {"--feed-override", "55"}).out,
                         "overrides   feed 55 %, rapid 100 %, spindle 100 % from 0.000 s on"));
}

TEST_F(OverrideOption, RejectsValuesOutsideControllerRange) {
    rejected("grbl-router", {"--feed-override", "9"},
             "--feed-override 9: the controller grbl-1.1 supports from 10 to 200 %");
    rejected("grbl-router", {"--rapid-override", "33"},
             "--rapid-override 33: the controller grbl-1.1 supports 25, 50 or 100 %");
    rejected("klipper-router", {"--feed-override", "90"},
             "--feed-override 90: the planner \"klipper\" supports no override; M220 in the program sets its "
             "speed factor");
    rejected("linuxcnc-router", {"--feed-override", "120"},
             "--feed-override 120: the controller linuxcnc-2.9 supports from 0 to 100 %");
    rejected("linuxcnc-router", {"--spindle-override", "20"},
             "--spindle-override 20: the controller linuxcnc-2.9 supports from 50 to 200 %");
    rejected("router3", {"--rapid-override", "101"},
             "--rapid-override 101: the controller exact-stop supports from 0 to 100 %");
    rejected("router3", {"--feed-override", "nan"}, "from 0 to 200 %");
    rejected("router3", {"--feed-override", "0"}, "--feed-override 0 would stop the machine indefinitely");
    rejected("router3", {"--spindle-override", "0"}, "a spindle at 0 %");
}

TEST_F(OverrideOption, FileChangesOverridesDuringRun) {
    const std::string file = write("turned.toml",
                                   "[[override]]\nat_s = 1\nfeed_percent = 0\n"
                                   "[[override]]\nat_s = 3\nfeed_percent = 50\n");
    // The axis brakes from 50 mm/s in 0.1 s and 2.5 mm; the remainder runs at 25 mm/s, with 500 mm/s2.
    const double rest_mm = 100 - (50 - 2.5) - 2.5;
    EXPECT_NEAR(time_s("router3", {"--overrides", file}), 3 + rest_mm / 25 + 0.05, 1e-6);
    EXPECT_NEAR(time_s("router3", {"--overrides", file, "--feed-override", "50"}),
                3 + (100 - (25 - 0.625) - 0.625) / 25 + 0.05, 1e-6);
}

TEST_F(OverrideOption, RejectsInvalidFile) {
    refused_file("[[override]]\nat_s = 1\nfeed = 50\n",
                 "turned.toml:3:1: unknown key 'feed' in [[override]]");
    refused_file("[[override]]\nfeed_percent = 50\n", "turned.toml:1:1: [[override]] lacks the key 'at_s'");
    refused_file("[[override]]\nat_s = 1\n", "turned.toml:2:8: [[override]] changes nothing");
    refused_file("[[override]]\nat_s = -1\nfeed_percent = 50\n", "turned.toml:2:8: 'at_s' must be");
    refused_file(
        "[[override]]\nat_s = 1\nfeed_percent = 250\n",
        "turned.toml:3:16: 'feed_percent' is 250: the controller exact-stop supports from 0 to 200 %");
    refused_file("[[override]]\nat_s = 5\nfeed_percent = 50\n[[override]]\nat_s = 5\nfeed_percent = 60\n",
                 "turned.toml:5:8: 'at_s' is 5; it must be greater than the one above, 5");
    refused_file("[[override]]\nat_s = 5\nrapid_percent = 0\n", "stops the machine (0 %)");
    refused_file("overrides = 3\n", "turned.toml:1:1: unknown key 'overrides'");
    rejected("router3", {"--overrides", "none.toml"}, "none.toml");
}

TEST_F(OverrideOption, RejectsOverrideWithControllerModule) {
    for (const std::string option : {"--feed-override", "--rapid-override", "--spindle-override"}) {
        rejected(
            "router3", {option, "50", "--rcs", tests::default_module_path()},
            option + " cannot be combined with --rcs: a module has a separate override, SetOverrideSpeed");
    }
}

TEST_F(OverrideOption, AppliesToEachRobot) {
    write("r.toml", "[[robot]]\nname = \"left\"\n[[robot]]\nname = \"right\"\n");
    const std::string script =
        write("cell.lua",
              "process('a', function() local _ENV = robot 'left' F(600) G1{x=100} end)\n"
              "process('b', function() local _ENV = robot 'right' F(600) G1{x=100} end)\n");
    const auto time_s = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all{"--robots", "r.toml", script, "--json"};
        all.insert(all.end(), more.begin(), more.end());
        const Ended e = gsim_run(all);
        EXPECT_EQ(e.status, 0) << e.err << e.out;
        const json report = text::try_parse_json<json>(e.out);
        return report.is_discarded() ? 0.0 : report["cycle_time_s"].get<double>();
    };
    EXPECT_NEAR(time_s({"--feed-override", "50"}), 20 + 5 / 490.33, 1e-6);
    EXPECT_NEAR(time_s({}), 10 + 10 / 490.33, 1e-6);
}

}  // namespace
}  // namespace gsim::apps::overrides_test
