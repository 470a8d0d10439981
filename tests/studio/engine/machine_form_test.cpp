#include <gtest/gtest.h>

#include "tests/studio/engine/asked.h"

namespace gsim::studio {
namespace {

constexpr const char* kMachine = R"([machine]
name = "small"

[[axis]]
letter = "X"
kind = "linear"
min_mm = 0.0
max_mm = 100.0
direction = "x"
)";

constexpr const char* kAsked = R"({"do": "machine", "machine": "m.toml"})";

std::string with(std::string text, const std::string& old, const std::string& now) {
    return text.replace(text.find(old), old.size(), now);
}

/// Returns "file:line:column text" of all reported messages.
std::vector<std::string> reported(const std::vector<Frame>& frames) {
    std::vector<std::string> all;
    for (const Frame& frame : filter_frames(frames, "diagnostic")) {
        const auto& header = frame.header;
        EXPECT_EQ(header["severity"], "error");
        all.push_back(header["file"].get<std::string>() + ":" + header["line"].dump() + ":" +
                      header["column"].dump() + " " + header["text"].get<std::string>());
    }
    return all;
}

TEST(MachineForm, ReturnsCheckAsTextAndJson) {
    const auto frames = request_frames(kAsked, {{"m.toml", kMachine}});
    ASSERT_EQ(last(frames).is(), "done") << last(frames).header;
    const Frame response = filter_frames(frames, "machine").at(0);
    EXPECT_EQ(response.header["check"]["machine"], "small");
    EXPECT_NE(response.header["text"].get<std::string>().find("small"), std::string::npos);
    EXPECT_EQ(request_frames(R"({"do": "machine"})").back().is(), "done");  // the one that is built in
}

TEST(MachineForm, ReportsEachErrorOfMachineWithLocation) {
    std::string machine = with(kMachine, "name = \"small\"", "name = \"small\"\ninverted = 3");
    machine = with(machine, "max_mm = 100.0", "max_mm = \"far\"\nmax_speed_mm_s = -1.0");
    machine += "[[axis]]\nletter = \"X\"\nkind = \"linear\"\nmin_mm = 5.0\nmax_mm = 1.0\ndirection = \"x\"\n";
    const auto frames = request_frames(kAsked, {{"m.toml", machine}});
    EXPECT_EQ(reported(frames), (std::vector<std::string>{
                                    "m.toml:3:1 unknown key 'inverted' in [machine]; did you mean 'inverse'?",
                                    "m.toml:9:10 'max_mm' must be a number, not a string",
                                    "m.toml:10:18 'max_speed_mm_s' must be greater than 0, not -1",
                                    "m.toml:15:10 'min_mm' is 5, greater than 'max_mm', 1",
                                    "m.toml:12:1 'home_mm' is 0, outside the axis range 5 .. 1",
                                    "m.toml:13:10 the letter X is given twice; first in line 6",
                                }));
    EXPECT_EQ(last(frames).is(), "failed");
    EXPECT_EQ(last(frames).header["message"],
              "m.toml:3:1: unknown key 'inverted' in [machine]; did you mean 'inverse'?");
}

TEST(MachineForm, ReportsEachErrorOfCellWithLocation) {
    const Files files{{"m.toml", kMachine},
                      {"c.toml",
                       "[cell]\nname = 3\nmachine = \"m.toml\"\n[[object]]\nname = \"a\"\nattached_to = "
                       "\"b\"\nshape = { box = [1, 2, 3] }\n[[object]]\nname = \"a\"\nshape = { "
                       "sphere_mm = 1.0 }\nframe = { x = 1.0 }\n"}};
    const auto frames = request_frames(R"({"do": "machine", "cell": "c.toml"})", files);
    EXPECT_EQ(reported(frames),
              (std::vector<std::string>{
                  "c.toml:2:8 'name' must be a string, not a number",
                  "c.toml:6:15 'b' is not defined above; known names: world, base, X, tool, work",
                  "c.toml:7:11 unknown key 'box' in 'shape'; did you mean 'box_mm'?",
                  "c.toml:9:8 the name 'a' is already used, by the machine or above",
                  "c.toml:11:11 unknown key 'x' in 'frame'; known keys: x_mm, y_mm, z_mm, roll_deg, "
                  "pitch_deg, yaw_deg",
              }));
    EXPECT_EQ(last(frames).is(), "failed");
}

TEST(MachineForm, ReportsInvalidAndMissingFiles) {
    EXPECT_EQ(reported(request_frames(kAsked, {{"m.toml", "[machine\n"}})).at(0).substr(0, 10), "m.toml:1:9");
    EXPECT_EQ(reported(request_frames(R"({"do": "machine", "cell": "c.toml"})", {{"c.toml", "a = \n"}}))
                  .at(0)
                  .substr(0, 10),
              "c.toml:1:5");
    EXPECT_EQ(filter_frames(request_frames(kAsked), "diagnostic").size(), 1U);
    EXPECT_EQ(last(request_frames(kAsked)).is(), "failed");
}

TEST(MachineForm, ReadsCustomControllerFromPage) {
    const std::string machine = std::string(kMachine) + "[controller]\nmodel = \"own.toml\"\n";
    EXPECT_EQ(
        last(request_frames(kAsked, {{"m.toml", machine}, {"own.toml", "[controller]\nname = \"mine\"\n"}}))
            .is(),
        "done");
    EXPECT_EQ(
        reported(
            request_frames(kAsked, {{"m.toml", machine}, {"own.toml", "[controller]\nnam = \"mine\"\n"}})),
        std::vector<std::string>{"own.toml:2:1 unknown key 'nam' in [controller]; did you mean 'name'?"});
}

}  // namespace
}  // namespace gsim::studio
