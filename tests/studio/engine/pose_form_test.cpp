#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/studio/engine/asked.h"

namespace gsim::studio {
namespace {

using nlohmann::json;
using testing::HasSubstr;

Files files_of_poses() {
    return {{"mill.toml", sample("machines/mill-head-table.toml")},
            {"mill2.toml", sample("machines/mill-table-table.toml")},
            {"offset.toml", sample("machines/gantry-offset-head.toml")},
            {"router.toml", sample("machines/router3.toml")},
            {"machines/af5.toml", sample("machines/af5.toml")},
            {"cell/table.toml", sample("cell/table.toml")},
            {"cell/mould.stl", sample("cell/mould.stl")}};
}

std::string pose_request(json request_json) {
    request_json["do"] = "pose";
    return request_json.dump();
}

json request_pose(const json& request_json) {
    const auto frames = request_frames(pose_request(request_json), files_of_poses());
    const auto poses = filter_frames(frames, "pose");
    return poses.empty() ? last(frames).header : poses.front().header;
}

TEST(PoseForm, ReturnsPoseOfJoints) {
    const json pose = request_pose({{"machine", "router.toml"}, {"joints", {100, 50, -20}}});
    ASSERT_EQ(pose["is"], "pose") << pose;
    EXPECT_EQ(pose["joints"], json({100, 50, -20}));
    EXPECT_EQ(pose["tip_mm"], json({100, 50, -20}));
    EXPECT_EQ(pose["tool_axis"], json({0, 0, 1}));
    EXPECT_EQ(pose["rpy_deg"], json({0, 0, 0}));
    EXPECT_EQ(pose["solutions"], json::array({{100, 50, -20}}));
    EXPECT_EQ(pose["beyond"], json({0, 0, 0}));
    EXPECT_EQ(pose["collisions"], json::array());
}

TEST(PoseForm, FindsAxesForTcp) {
    const json pose = request_pose({{"machine", "mill.toml"},
                                    {"tip_mm", {10, 20, 30}},
                                    {"tool_axis", {1, 0, 2}},
                                    {"near", {0, 0, 0, 0, 0}}});
    ASSERT_EQ(pose["is"], "pose") << pose;
    EXPECT_NEAR(pose["tool_axis"][0].get<double>(), 1 / std::sqrt(5), 1e-9);
    EXPECT_EQ(pose["solutions"][0], pose["joints"]);
    EXPECT_GT(pose["solutions"].size(), 1U);
}

// A path at the same point with the same axis of the tool is written with one of the solutions.
TEST(PoseForm, UsesFrameOfPaths) {
    for (const std::string machine : {"mill.toml", "mill2.toml", "offset.toml"}) {
        const json pose =
            request_pose({{"machine", machine}, {"tip_mm", {60, 70, 80}}, {"tool_axis", {0.1, 0.2, 1}}});
        ASSERT_EQ(pose["is"], "pose") << pose;
        Files files = files_of_poses();
        files["point.json"] = R"({"name": "point", "root": "p", "paths": [{"name": "p", "targets": [
            {"motion": "rapid", "position_mm": [60, 70, 80], "tool_axis": [0.1, 0.2, 1]}]}]})";
        const json request_json{{"do", "write"},      {"path", "point.json"},  {"machine", machine},
                                {"post", "rs274ngc"}, {"verbose_words", true}, {"decimals_mm", 6}};
        const auto programs = filter_frames(request_frames(request_json.dump(), files), "program");
        ASSERT_EQ(programs.size(), 1U) << last(request_frames(request_json.dump(), files)).header;
        const std::string& text = programs[0].columns.at("text");
        const std::size_t line = text.find("G00 ");
        ASSERT_NE(line, std::string::npos) << text;
        bool is_one = false;
        for (const json& solution : pose["solutions"]) {
            bool all = true;
            for (const char letter : {'X', 'Y', 'Z'}) {
                const double written = std::stod(text.substr(text.find(letter, line) + 1));
                all = all && std::abs(written -
                                      solution[static_cast<std::size_t>(letter - 'X')].get<double>()) < 1e-4;
            }
            is_one = is_one || all;
        }
        EXPECT_TRUE(is_one) << machine << '\n' << pose << '\n' << text;
    }
}

// The TCP that a run draws after G43 is that of a pose.
TEST(PoseForm, ToolLengthMatchesCompensationOfRun) {
    for (const std::string machine : {"", "mill.toml", "mill2.toml", "router.toml"}) {
        Files files = files_of_poses();
        files["part.nc"] = "G21 G90\nG43 H1\nG0 X10\nM2\n";
        files["tools.txt"] = "NCFILE\nTOOL\n1 30 2\nENDFILE\n";
        json run{{"do", "run"}, {"program", "part.nc"}, {"machine_data", "tools.txt"}, {"dialect", "ab9"}};
        json request_json{{"tip_mm", {100, 100, -50}}, {"tool_mm", 30}};
        if (!machine.empty()) run["machine"] = request_json["machine"] = machine;
        const auto frames = request_frames(run.dump(), files);
        const auto scenes = filter_frames(frames, "scene");
        ASSERT_FALSE(scenes.empty()) << last(frames).header;
        const json tcp = scenes.back().header["scene"]["tcps_mm"].back();
        EXPECT_NEAR(tcp[2].get<double>(), -30, 1e-9) << machine << tcp;
        const json with = request_pose(request_json);
        request_json.erase("tool_mm");
        request_json.erase("tip_mm");
        request_json["joints"] = with["joints"];
        const json without = request_pose(request_json);
        double off = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            off += (with["tip_mm"][i].get<double>() - without["tip_mm"][i].get<double>()) *
                   with["tool_axis"][i].get<double>();
        }
        EXPECT_NEAR(off, -30, 1e-9) << machine;
    }
}

TEST(PoseForm, ReportsContactsInCell) {
    const json pose = request_pose({{"cell", "cell/table.toml"}, {"tip_mm", {100, 400, 10}}});
    ASSERT_EQ(pose["is"], "pose") << pose;
    const json pair = {"nozzle", "left clamp"};
    EXPECT_NE(std::find(pose["collisions"].begin(), pose["collisions"].end(), pair), pose["collisions"].end())
        << pose;
    const json free = request_pose({{"cell", "cell/table.toml"}, {"tip_mm", {600, 400, 200}}});
    EXPECT_EQ(free["collisions"], json::array());
}

TEST(PoseForm, RejectsInvalidRequests) {
    const auto error = [](const json& request_json) {
        return make_error(pose_request(request_json), files_of_poses());
    };
    EXPECT_EQ(error(json::object()), "a pose must have either 'joints' or 'tip_mm'");
    EXPECT_EQ(error({{"joints", {1, "2"}}}), "'joints' must be numbers; one is of type string");
    EXPECT_EQ(error({{"joints", {1, 2}}}),
              "'joints' must have 5 values, one for each axis of the machine, not 2");
    EXPECT_EQ(error({{"tip_mm", {1, 2}}}), "'tip_mm' must be three numbers, not 2");
    EXPECT_EQ(error({{"tip", {1, 2, 3}}}), "unknown key 'tip' of a pose");
    EXPECT_THAT(error({{"machine", "none.toml"}, {"joints", {1}}}), HasSubstr("none.toml"));
}

}  // namespace
}  // namespace gsim::studio
