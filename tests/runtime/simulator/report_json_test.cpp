#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/text/json.h"
#include "runtime/report/report.h"

namespace gsim::simulation::report_json_test {
namespace {

using nlohmann::ordered_json;
using testing::ElementsAre;

constexpr double kInf = std::numeric_limits<double>::infinity();

Report sample() {
    Report report;
    report.source.program = "part.nc";
    report.source.machine = "m";
    report.source.controller = "ab9";
    report.source.files = {"part.nc", "sub.nc"};
    report.cycle_time_s = 0.1 + 0.2;
    report.times.rapid_s = 1;
    report.distances.feed_mm = -0.0;
    report.counts.blocks = 12;
    report.counts.moves = 11;
    report.bounds = {
        {.letter = 'X', .min = 1, .max = 2, .limit_min = -kInf, .limit_max = 10},
        {.letter = 'B', .rotary = true, .min = -90, .max = 0, .limit_min = -360, .limit_max = 360}};
    report.events = {{1.5, {1, 3}, "jet_on", ""}, {2, {0, 0}, "stop", "by the operator"}};
    report.messages.warnings = {"something"};
    report.slowest = {{{0, 9}, MoveKind::arc_cw, 3.5, 20, "feed"}, {{0, 10}, MoveKind::dwell, 1, 0}};
    return report;
}

std::vector<std::string> keys(const ordered_json& json) {
    std::vector<std::string> keys;
    for (const auto& item : json.items()) keys.push_back(item.key());
    return keys;
}

TEST(ReportJson, WritesKeysInFixedOrder) {
    const auto json = text::parse_json<ordered_json>(to_json(sample()));
    EXPECT_THAT(keys(json),
                ElementsAre("format", "program", "machine", "controller", "status", "alarm", "violations",
                            "violation_count", "suggested_fix", "cycle_time_s", "valid_until_s", "time",
                            "process", "length", "blocks", "moves", "blends", "bounds", "events", "warnings",
                            "diagnostics", "findings", "slowest"));
    EXPECT_THAT(keys(json["time"]), ElementsAre("rapid_s", "feed_s", "dwell_s"));
    EXPECT_THAT(keys(json["length"]), ElementsAre("rapid_mm", "feed_mm", "process_on_mm"));
    EXPECT_THAT(keys(json["blends"]),
                ElementsAre("count", "max_deviation_mm", "file", "line", "feed", "rapid"));
    EXPECT_THAT(keys(json["bounds"]), ElementsAre("X", "B"));
    EXPECT_THAT(keys(json["bounds"]["X"]), ElementsAre("min", "max", "limit_min", "limit_max"));
    EXPECT_THAT(keys(json["slowest"][0]),
                ElementsAre("file", "line", "kind", "duration_s", "length_mm", "limited_by"));
}

TEST(ReportJson, WritesPassesOfRepeatedMainProgram) {
    Report report = sample();
    report.passes = Passes{3, {1, 7}, std::nullopt};
    auto json = text::parse_json<ordered_json>(to_json(report));
    EXPECT_EQ(json["passes"].dump(), R"({"count":3,"file":"sub.nc","line":7,"to_block":null})");
    report.passes->to_block = 20;
    json = text::parse_json<ordered_json>(to_json(report));
    EXPECT_EQ(json["passes"]["to_block"], 20);
}

TEST(ReportJson, WritesViolationsAndFindings) {
    Report report = sample();
    report.status = RunStatus::violations;
    report.violations.list = {{.t_s = 0.25,
                               .location = {0, 4},
                               .message = "axis X goes to -5 mm",
                               .axis = 'X',
                               .value = -5,
                               .limit = 0,
                               .offset = "G54"}};
    report.violations.count = 3;
    report.violations.suggested_fix = {{.offset = "G54", .axis = 'X', .shift_mm = 5}};
    report.findings = {.list = {{.t_s = 1, .location = {1, 2}, .message = "a rapid"}}, .count = 1};
    report.source.process = "laser";
    const auto json = text::parse_json<ordered_json>(to_json(report));
    EXPECT_EQ(json["status"], "violations");
    EXPECT_EQ(
        json["violations"][0].dump(),
        R"({"t_s":0.25,"file":"part.nc","line":4,"axis":"X","unit":"mm","value":-5.0,"limit":0.0,"amount":5.0,)"
        R"("zone":null,"offset":"G54","message":"axis X goes to -5 mm","calls":[]})");
    EXPECT_EQ(json["violation_count"], 3);
    EXPECT_EQ(json["valid_until_s"], 0.25);
    EXPECT_EQ(json["suggested_fix"].dump(), R"([{"offset":"G54","axis":"X","shift_mm":5.0}])");
    EXPECT_EQ(json["findings"].dump(),
              R"([{"t_s":1.0,"file":"sub.nc","line":2,"code":"rapid-with-process-on","message":"a rapid"}])");
    EXPECT_EQ(json["process"], "laser");
    EXPECT_EQ(text::parse_json<ordered_json>(to_json(sample()))["valid_until_s"], nullptr);
}

TEST(ReportJson, WritesValues) {
    const auto json = text::parse_json<ordered_json>(to_json(sample()));
    EXPECT_EQ(json["status"], "completed");
    EXPECT_EQ(json["controller"], "ab9");
    EXPECT_EQ(json["alarm"], nullptr);
    EXPECT_EQ(json["cycle_time_s"], 0.3);
    EXPECT_EQ(json["length"]["feed_mm"].dump(), "0.0");
    EXPECT_EQ(json["blocks"], 12);
    EXPECT_EQ(json["bounds"]["X"]["limit_min"], nullptr);
    EXPECT_EQ(json["bounds"]["X"]["limit_max"], 10);
    EXPECT_EQ(json["events"][0],
              (ordered_json{{"t_s", 1.5}, {"file", "sub.nc"}, {"line", 3}, {"kind", "jet_on"}}));
    EXPECT_EQ(json["events"][1], (ordered_json{{"t_s", 2.0},
                                               {"file", "part.nc"},
                                               {"line", nullptr},
                                               {"kind", "stop"},
                                               {"detail", "by the operator"}}));
    EXPECT_EQ(json["warnings"], ordered_json::array({"something"}));
    EXPECT_EQ(json["slowest"][0]["kind"], "arc_cw");
    EXPECT_EQ(json["slowest"][0]["limited_by"], "feed");
    EXPECT_EQ(json["slowest"][1]["limited_by"], nullptr);
}

TEST(ReportJson, WritesRoundedCorners) {
    Report report = sample();
    EXPECT_EQ(text::parse_json<ordered_json>(to_json(report))["blends"].dump(),
              R"({"count":0,"max_deviation_mm":0.0,"file":null,"line":null,)"
              R"("feed":{"max_deviation_mm":0.0,"file":null,"line":null},)"
              R"("rapid":{"max_deviation_mm":0.0,"file":null,"line":null}})");
    report.blends = {.count = 7, .feed = {0.05, {0, 9}}, .rapid = {0.75, {0, 4}}};
    EXPECT_EQ(text::parse_json<ordered_json>(to_json(report))["blends"].dump(),
              R"({"count":7,"max_deviation_mm":0.75,"file":"part.nc","line":4,)"
              R"("feed":{"max_deviation_mm":0.05,"file":"part.nc","line":9},)"
              R"("rapid":{"max_deviation_mm":0.75,"file":"part.nc","line":4}})");
    report.blends.measured = false;
    EXPECT_TRUE(text::parse_json<ordered_json>(to_json(report))["blends"].is_null())
        << "nothing is known, so nothing is said";
}

TEST(ReportJson, WritesExplanationLastOnlyIfPresent) {
    Report report = sample();
    EXPECT_FALSE(text::parse_json<ordered_json>(to_json(report)).contains("time_by_limit"));
    report.explanation = Explanation{{{"feed", 0.25}, {"dwell", 0.05}}, 0.2};
    const auto json = text::parse_json<ordered_json>(to_json(report));
    const std::vector<std::string> all = keys(json);
    EXPECT_EQ(all[all.size() - 2], "time_by_limit");
    EXPECT_EQ(all.back(), "lower_bound_s");
    EXPECT_EQ(json["time_by_limit"],
              text::parse_json<ordered_json>(R"([{"limited_by":"feed","time_s":0.25},)"
                                             R"({"limited_by":"dwell","time_s":0.05}])"));
    EXPECT_EQ(json["lower_bound_s"], 0.2);
}

TEST(ReportJson, AlarmHasAxisAndValues) {
    Report report = sample();
    report.status = RunStatus::alarm;
    report.alarm =
        Alarm{.message = "X beyond its limit", .location = {0, 4}, .axis = 'X', .value = 12, .limit = 10};
    auto json = text::parse_json<ordered_json>(to_json(report));
    EXPECT_EQ(json["status"], "alarm");
    EXPECT_EQ(json["alarm"], (ordered_json{{"code", "script"},
                                           {"message", "X beyond its limit"},
                                           {"file", "part.nc"},
                                           {"line", 4},
                                           {"axis", "X"},
                                           {"value", 12.0},
                                           {"limit", 10.0},
                                           {"calls", ordered_json::array()}}));
    report.alarm = Alarm{.message = "no such program", .location = {9, 0}, .value = {}, .limit = {}};
    json = text::parse_json<ordered_json>(to_json(report));
    EXPECT_THAT(keys(json["alarm"]),
                ElementsAre("code", "message", "file", "line", "axis", "value", "limit", "calls"));
    for (const char* key : {"file", "line", "axis", "value", "limit"}) EXPECT_EQ(json["alarm"][key], nullptr);
}

TEST(ReportJson, AlarmListsActiveCalls) {
    Report report = sample();
    report.alarm = Alarm{.message = "m",
                         .location = {0, 9},
                         .calls = {{"O3", {0, 5}}, {"O2", {0, 2}}},
                         .value = {},
                         .limit = {}};
    const auto calls = text::parse_json<ordered_json>(to_json(report))["alarm"]["calls"];
    ASSERT_EQ(calls.size(), 2U);
    EXPECT_EQ(calls[0], (ordered_json{{"program", "O3"}, {"file", "part.nc"}, {"line", 5}}));
    EXPECT_EQ(calls[1]["program"], "O2");
    EXPECT_NE(to_text(report).find("O3 at part.nc:5"), std::string::npos) << to_text(report);
}

TEST(ReportJson, EmptyListsStayLists) {
    const auto json = text::parse_json<ordered_json>(to_json(Report{}));
    EXPECT_TRUE(json["events"].is_array());
    EXPECT_TRUE(json["warnings"].is_array());
    EXPECT_TRUE(json["slowest"].is_array());
    EXPECT_TRUE(json["bounds"].is_object());
}

TEST(ReportJson, ReplacesValuesInvalidInJson) {
    Report report = sample();
    report.cycle_time_s = kInf;
    report.times.rapid_s = std::numeric_limits<double>::quiet_NaN();
    report.source.program = "\xff.nc";
    const auto json = text::parse_json<ordered_json>(to_json(report));
    EXPECT_EQ(json["cycle_time_s"], nullptr);
    EXPECT_EQ(json["time"]["rapid_s"], nullptr);
    EXPECT_EQ(json["program"], "\ufffd.nc");
}

}  // namespace
}  // namespace gsim::simulation::report_json_test
