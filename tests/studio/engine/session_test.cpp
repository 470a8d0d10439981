#include "studio/engine/session.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/studio/engine/asked.h"

namespace gsim::studio {
namespace {

constexpr const char* kRun = R"({"do": "run", "program": "part.nc"})";

TEST(Session, RunSendsSceneSegmentsAndReport) {
    const auto frames =
        request_frames(kRun, {{"part.nc", "G21 G90\nG0 X10\nG1 X10 Y20 F6000\nG2 X30 Y20 I10\nM2\n"}});
    EXPECT_EQ(last(frames).is(), "done");
    EXPECT_EQ(filter_frames(frames, "diagnostic").size(), 0U);
    const auto scenes = filter_frames(frames, "scene");
    ASSERT_EQ(scenes.size(), 2U);
    EXPECT_EQ(scenes[0].header["scene"]["axes"][0]["letter"], "X");
    EXPECT_EQ(scenes[1].header["files"], nlohmann::json::array({"part.nc"}));
    const auto segments = filter_frames(frames, "segments");
    ASSERT_EQ(segments.size(), 1U);
    EXPECT_EQ(segments[0].column<std::uint32_t>("line"), (std::vector<std::uint32_t>{2, 3, 4}));
    const auto reports = filter_frames(frames, "report");
    ASSERT_EQ(reports.size(), 1U);
    const auto start_s = segments[0].column<double>("start_s");
    const auto duration_s = segments[0].column<double>("duration_s");
    EXPECT_NEAR(start_s.back() + duration_s.back(), reports[0].header["report"]["cycle_time_s"].get<double>(),
                1e-9);
}

TEST(Session, DrawnPathIsWithinHundredthOfMmOfArc) {
    const auto frames = request_frames(kRun, {{"part.nc", "G21 G90 F6000\nG1 X100\nG2 X100 I-50\nM2\n"}});
    const Frame segments = filter_frames(frames, "segments").at(0);
    const auto vertices = segments.column<float>("vertex_mm");
    const auto of = segments.column<std::uint32_t>("vertex_segment");
    const auto time_s = segments.column<float>("vertex_s");
    ASSERT_EQ(vertices.size(), 3 * of.size());
    ASSERT_EQ(time_s.size(), of.size());
    std::size_t is_on_arc = 0;
    for (std::size_t i = 0; i < of.size(); ++i) {
        if (of[i] != 1) continue;
        ++is_on_arc;
        EXPECT_NEAR(std::hypot(vertices[3 * i] - 50, vertices[3 * i + 1]), 50, 1e-4);
        EXPECT_LE(time_s[i - 1], time_s[i]);
    }
    // A chord is off its arc by r (1 - cos(half its angle)).
    EXPECT_LT(50 * (1 - std::cos(3.14159265 / static_cast<double>(is_on_arc))), 0.01);
    EXPECT_LT(is_on_arc, 400U);
}

TEST(Session, DrawnPathFollowsTcp) {
    const auto frames = request_frames(R"({"do": "run", "program": "part.nc", "machine_data": "tools.txt"})",
                                       {{"part.nc", "G21 G90\nG0 Z100\nG43 H1\nG0 Z100\nM2\n"},
                                        {"tools.txt", "NCFILE\nTOOL\n1 30 2\nENDFILE\n"}});
    const Frame segments = filter_frames(frames, "segments").at(0);
    const auto vertices = segments.column<float>("vertex_mm");
    ASSERT_EQ(segments.column<std::uint32_t>("tip"), (std::vector<std::uint32_t>{0, 1}))
        << last(frames).header;
    EXPECT_NEAR(vertices.back(), 100, 1e-4);  // the axis moves to 130
    // The new TCP begins at its position at the change: 30 mm below the old one.
    ASSERT_GE(vertices.size(), 6U);
    EXPECT_NEAR(vertices[vertices.size() - 4], 70, 1e-4);
    const auto tcps = filter_frames(frames, "scene").back().header["scene"]["tcps_mm"];
    ASSERT_EQ(tcps.size(), 2U);
    EXPECT_NEAR(std::hypot(tcps[1][0].get<double>(), tcps[1][1].get<double>(), tcps[1][2].get<double>()), 30,
                1e-9);
}

TEST(Session, DrawnPathWindsWithRotaryTable) {
    std::string machine = sample("machines/mill-table-table.toml");
    const std::string shortest = "turning = \"shortest\"";
    machine.erase(machine.find(shortest), shortest.size());  // full turns are made
    const auto frames = request_frames(
        R"({"do": "run", "program": "part.nc", "machine": "mill.toml"})",
        {{"part.nc", "G21 G90\nG1 X100 Y0 F100000\nG1 C1440 F100000\nM2\n"}, {"mill.toml", machine}});
    const Frame segments = filter_frames(frames, "segments").at(0);
    const auto vertices = segments.column<float>("vertex_mm");
    const auto of = segments.column<std::uint32_t>("vertex_segment");
    double rotation_rad = 0;
    for (std::size_t i = 1; i < of.size(); ++i) {
        if (of[i] != of.back()) continue;
        const auto angle = [&](std::size_t vertex) {
            return std::atan2(vertices[3 * vertex + 1], vertices[3 * vertex]);
        };
        rotation_rad += std::abs(std::remainder(angle(i) - angle(i - 1), 2 * std::numbers::pi));
    }
    EXPECT_NEAR(rotation_rad, 8 * std::numbers::pi, 1e-3);
}

TEST(Session, ChecksProgramInDialectOfCellMachine) {
    const Files files{
        {"part.nc", "G64 P0.1\n#<a> = 3\nG1 X[#<a>] F100\nM2\n"},
        {"cell.toml", "[cell]\nname = \"c\"\nmachine = \"mine.toml\"\n"},
        {"mine.toml",
         "[machine]\nname = \"m\"\n[program]\ndialect = \"rs274ngc\"\n[[axis]]\nletter = \"X\"\nkind = "
         "\"linear\"\nmin_mm = 0.0\nmax_mm = 10.0\ndirection = \"x\"\n"}};
    EXPECT_EQ(
        filter_frames(request_frames(R"({"do": "check", "program": "part.nc", "cell": "cell.toml"})", files),
                      "diagnostic")
            .size(),
        0U);
    EXPECT_GT(
        filter_frames(request_frames(R"({"do": "check", "program": "part.nc"})", files), "diagnostic").size(),
        0U);
}

TEST(Session, ReportsErrorWithLocation) {
    const auto frames =
        request_frames(R"({"do": "check", "program": "part.nc"})", {{"part.nc", "G0 X1\nG999\n"}});
    const auto reported = filter_frames(frames, "diagnostic");
    ASSERT_EQ(reported.size(), 1U);
    EXPECT_EQ(reported[0].header["severity"], "error");
    EXPECT_EQ(reported[0].header["line"], 2);
    EXPECT_EQ(reported[0].header["column"], 1);
    EXPECT_EQ(last(frames).is(), "done");
}

TEST(Session, TranslatesLineByLine) {
    const auto frames =
        request_frames(R"({"do": "translate", "program": "part.nc"})", {{"part.nc", "G21\nG0 X1\nM2\n"}});
    const auto scripts = filter_frames(frames, "script");
    ASSERT_EQ(scripts.size(), 1U);
    const std::string& lua = scripts[0].columns.at("lua");
    EXPECT_NE(lua.find("\nG21()\nG0{x=1}\nM2()\n"), std::string::npos) << lua;
}

std::string channel_names(const Frame& frame) {
    std::string names;
    for (const auto& channel : frame.header["channels"]) {
        const std::string axis = channel.contains("axis") ? channel["axis"].dump() : "";
        names += channel["of"].get<std::string>() + axis + " ";
    }
    return names;
}

TEST(Session, SendsEffortsAndFollowingErrorsOverTime) {
    const auto frames = request_frames(R"({"do": "run", "program": "part.nc", "machine": "gantry.toml"})",
                                       {{"part.nc", "G21 G90\nG1 X100 Y-50 F6000\nG0 X0\nM2\n"},
                                        {"gantry.toml", sample("machines/gantry-dynamics.toml")}});
    ASSERT_EQ(last(frames).is(), "done") << last(frames).header;
    const auto report = filter_frames(frames, "report").at(0).header["report"];
    const Frame efforts = filter_frames(frames, "efforts").at(0);
    const Frame following = filter_frames(frames, "following").at(0);
    // Only the motor of X has less at high speeds.
    EXPECT_EQ(channel_names(efforts), "power effort0 effort1 effort2 motor_peak0 share0 ");
    EXPECT_EQ(channel_names(following), "contour error0 error1 error2 ");
    const auto peak = [](const Frame& frame, std::size_t channel) {
        const auto values = frame.column<float>("values");
        double max = 0;
        for (std::size_t i = channel; i < values.size(); i += frame.header["channels"].size())
            max = std::max(max, std::abs(static_cast<double>(values[i])));
        return max;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double effort = report["efforts"]["axes"][axis]["peak"];
        EXPECT_NEAR(peak(efforts, 1 + axis), std::abs(effort), 1e-6 * std::abs(effort));
        const double error_mm = report["following"]["axes"][axis]["peak"];
        EXPECT_NEAR(peak(following, 1 + axis), std::abs(error_mm), 1e-3 * std::abs(error_mm) + 1e-9);
    }
    EXPECT_NEAR(following.column<double>("t_s").back(), report["cycle_time_s"].get<double>(), 1e-9);
}

TEST(Session, SendsNoEffortsOrFollowingErrorsByDefault) {
    const auto frames = request_frames(kRun, {{"part.nc", "G21 G90\nG0 X10\nM2\n"}});
    EXPECT_EQ(filter_frames(frames, "efforts").size() + filter_frames(frames, "following").size(), 0U);
}

TEST(Session, RejectedProgramHasReportAndFails) {
    const auto frames = request_frames(kRun, {{"part.nc", "G999\n"}});
    EXPECT_EQ(filter_frames(frames, "report").size(), 1U);
    EXPECT_EQ(last(frames).is(), "failed");
    EXPECT_EQ(last(frames).header["in_program"], true);
}

TEST(Session, RejectsInvalidRequests) {
    EXPECT_EQ(last(request_frames("{")).header["message"], "a request must be JSON");
    EXPECT_EQ(last(request_frames("[]")).header["message"], "a request must be an object");
    EXPECT_NE(last(request_frames(R"({"do": 3})"))
                  .header["message"]
                  .get<std::string>()
                  .find("'do' must be a string, one of run, check, translate, envelope, languages"),
              std::string::npos);
    EXPECT_EQ(last(request_frames(R"({"do": "run", "tool_mm": 3})")).header["message"],
              "unknown key 'tool_mm' of a run");
    EXPECT_EQ(last(request_frames(R"({"do": "run", "program": )" + std::string(100, '[') +
                                  std::string(100, ']') + "}"))
                  .header["message"],
              "'program' must be a string, not of type array");
    EXPECT_EQ(last(request_frames(R"({"do": "\nfly"})")).header["message"], "unknown request '\\x0afly'");
    EXPECT_EQ(last(request_frames(R"({"do": "fly"})")).header["message"], "unknown request 'fly'");
    EXPECT_EQ(last(request_frames(kRun)).is(), "failed");
    EXPECT_NE(last(request_frames(kRun)).header["message"].get<std::string>().find("part.nc"),
              std::string::npos);
}

TEST(Session, ListsLanguagesWithCodes) {
    const auto frames = request_frames(R"({"do": "languages"})");
    const auto languages = filter_frames(frames, "languages").at(0).header["languages"];
    ASSERT_EQ(languages.size(), 3U);
    for (const auto& language : languages) {
        const auto& codes = language["codes"];
        const auto arc =
            std::find_if(codes.begin(), codes.end(), [](const auto& code) { return code["code"] == "G2"; });
        ASSERT_NE(arc, codes.end());
        EXPECT_EQ((*arc)["group"], "motion");
        EXPECT_EQ((*arc)["supported"], true);
    }
}

}  // namespace
}  // namespace gsim::studio
