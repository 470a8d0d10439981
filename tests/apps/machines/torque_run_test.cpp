// Motors' peaks while the controller turns the work under the TCP, and while the operator changes the
// override.

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "base/text/json.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::torque_run_test {
namespace {

using nlohmann::json;
using TorqueRun = Apps;

std::string file_text(const std::string& name) {
    const std::ifstream in(name);
    return (std::stringstream() << in.rdbuf()).str();
}

void replace(std::string& text, const std::string& old, const std::string& by) {
    const std::size_t at = text.find(old);
    ASSERT_NE(at, std::string::npos) << old;
    text.replace(at, old.size(), by);
}

/// Returns the sample mill with masses and motors; none of the values is a manufacturer's.
std::string mill(const std::string& controller) {
    std::string text = file_text(tests::source_path("samples/machines/mill-table-table.toml"));
    replace(text, "[path]",
            "[controller]\nmodel = \"" + controller + "\"\n[dynamics]\nlimit = \"torque\"\n[path]");
    const std::map<std::string, std::string> motors{{"X", "peak_n = 3000"},
                                                    {"Y", "peak_n = 2500"},
                                                    {"Z", "peak_n = 3500"},
                                                    {"A", "peak_nm = 150"},
                                                    {"C", "peak_nm = 60"}};
    for (const auto& [letter, motor] : motors) {
        std::string line = "letter = \"";
        line.append(letter).append("\"");
        replace(text, line, line + "\n" + motor + "\n#");
    }
    return text + R"(
[[mass]]
on = "X"
mass_kg = 300
[[mass]]
on = "Y"
mass_kg = 400
[[mass]]
on = "Z"
mass_kg = 150
[[mass]]
on = "A"
mass_kg = 60
centre_mm = [0, 0, -40]
inertia_kg_m2 = [1, 2, 2]
[[mass]]
on = "C"
mass_kg = 30
inertia_kg_m2 = [0.3, 0.3, 0.5]
)";
}

constexpr const char* kTurns = R"([[override]]
at_s = 0.5
feed_percent = 120
[[override]]
at_s = 1.5
feed_percent = 40
[[override]]
at_s = 3
feed_percent = 0
[[override]]
at_s = 4
feed_percent = 100
)";

// The sample dome, of the table that tilts about X.
std::string dome() {
    std::string text = file_text(tests::source_path("samples/mill/dome.nc"));
    replace(text, " B#1", " A-#1");
    return text;
}

TEST_F(TorqueRun, LimitsMotorsToPeakUnderTcpControl) {
    write("dome.nc", dome());
    write("turns.toml", kTurns);
    for (const std::string controller : {"exact-stop", "ab9", "blend"}) {
        SCOPED_TRACE(controller);
        const std::string machine = write(controller + ".toml", mill(controller));
        std::vector<std::string> words{"--machine", machine, "--json", "dome.nc"};
        for (const bool turned : {false, true}) {
            if (turned) words.insert(words.end(), {"--overrides", "turns.toml"});
            const Ended ended = gsim_run(words);
            ASSERT_EQ(ended.status, 0) << ended.err;
            const json report = text::parse_json<json>(ended.out);
            const json& efforts = report.at("efforts");
            EXPECT_TRUE(efforts.at("excesses").empty());
            double nearest = 0;
            for (const json& axis : efforts.at("axes")) {
                const double share =
                    std::abs(axis.at("peak").get<double>()) / axis.at("motor_peak").get<double>();
                EXPECT_LE(share, 1 + 1e-6) << axis;
                nearest = std::max(nearest, share);
            }
            EXPECT_NEAR(nearest, 1, 1e-6);  // it is the motors that limit
        }
    }
}

}  // namespace
}  // namespace gsim::apps::torque_run_test
