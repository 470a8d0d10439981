#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/studio/engine/asked.h"

namespace gsim::studio {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const char* const kSquare = R"({"name": "square", "root": "side", "paths": [{"name": "side", "targets": [
  {"motion": "rapid", "position_mm": [10, 10, -10], "tool_axis": [0, 0, 1]},
  {"position_mm": [60, 10, -10], "feed_mm_min": 1000}]}]})";

Files files_of_writing() {
    return {{"wheel.path.json", sample("wheel.path.json")},
            {"square.json", kSquare},
            {"router.toml", sample("machines/router3.toml")},
            {"cell.toml", "[cell]\nname = \"c\"\nmachine = \"router.toml\"\n"}};
}

std::string write_request(json request_json) {
    request_json["do"] = "write";
    return request_json.dump();
}

Frame written(const json& request_json) {
    const auto frames = request_frames(write_request(request_json), files_of_writing());
    const auto programs = filter_frames(frames, "program");
    return programs.empty() ? last(frames) : programs.front();
}

TEST(WriteForm, WrittenPathRunsToCompletion) {
    const Frame program = written({{"path", "wheel.path.json"}, {"program_name", "wheel"}});
    ASSERT_TRUE(program.columns.contains("text")) << program.header;
    EXPECT_EQ(program.header["files"], json::array());
    const auto frames =
        request_frames(R"({"do": "run", "program": "wheel.nc"})", {{"wheel.nc", program.columns.at("text")}});
    ASSERT_EQ(last(frames).is(), "done") << last(frames).header;
    const json report = filter_frames(frames, "report").at(0).header["report"];
    EXPECT_EQ(report["status"], "completed");
    EXPECT_GT(report["cycle_time_s"], 1);
}

TEST(WriteForm, AppliesFrameAndTool) {
    const std::string program = written({{"path", "square.json"},
                                         {"post", "rs274ngc"},
                                         {"cell", "cell.toml"},
                                         {"work_offset", "G55"},
                                         {"set_offset_mm", {100, 50, 0}},
                                         {"tool", 3},
                                         {"retract_mm", -5}})
                                    .columns.at("text");
    EXPECT_THAT(program, HasSubstr("G10 L2 P2 X100 Y50 Z0 R0\nG53 G00 Z-5\nT3\nM6\nG43 H3\nG55\n"));
}

TEST(WriteForm, UsesWordsOfPostAndRequestedUnit) {
    const std::string mm =
        written({{"path", "square.json"}, {"post", "grbl"}, {"cell", "cell.toml"}}).columns.at("text");
    EXPECT_THAT(mm, HasSubstr("G21"));
    EXPECT_THAT(mm, HasSubstr("X60"));
    const std::string inch = written({{"path", "square.json"},
                                      {"post", "grbl"},
                                      {"cell", "cell.toml"},
                                      {"inch", true},
                                      {"decimals_mm", 3}})
                                 .columns.at("text");
    EXPECT_THAT(inch, HasSubstr("G20"));
    EXPECT_THAT(inch, HasSubstr("X2.3622"));
}

TEST(WriteForm, WritesSubPathsToSeparateFiles) {
    const Frame program = written(
        {{"path", "wheel.path.json"}, {"post", "ab9"}, {"program_name", "wheel"}, {"separate_files", true}});
    ASSERT_TRUE(program.header.contains("files")) << program.header;
    const auto names = program.header["files"].get<std::vector<std::string>>();
    ASSERT_FALSE(names.empty());
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string& text = program.columns.at("file" + std::to_string(i));
        EXPECT_FALSE(text.empty()) << names[i];
    }
}

TEST(WriteForm, RejectsInvalidRequests) {
    const auto error = [](const json& request_json) {
        return make_error(write_request(request_json), files_of_writing());
    };
    EXPECT_EQ(error(json::object()), "write needs 'path'");
    EXPECT_EQ(error({{"path", "square.json"}, {"offsets", "all"}}),
              "'offsets' must be one of as_path, keep, none, machine, not 'all'");
    EXPECT_EQ(error({{"path", "square.json"}, {"decimals_mm", 7}}),
              "'decimals_mm' must be from 1 to 6, not 7");
    EXPECT_EQ(error({{"path", "square.json"}, {"decimal", 3}}), "unknown key 'decimal' of write");
    EXPECT_THAT(error({{"path", "square.json"}, {"post", "fidia"}}), HasSubstr("unknown post 'fidia'"));
    EXPECT_THAT(error({{"path", "none.json"}}), HasSubstr("none.json"));
    EXPECT_THAT(error({{"path", "square.json"}, {"machine", "none.toml"}}), HasSubstr("none.toml"));
}

TEST(WriteForm, ListsPosts) {
    const json names = filter_frames(request_frames(R"({"do": "posts"})"), "posts").at(0).header["names"];
    EXPECT_NE(std::find(names.begin(), names.end(), "grbl"), names.end());
    EXPECT_EQ(make_error(R"({"do": "posts", "path": "a"})"), "unknown key 'path' of posts");
}

}  // namespace
}  // namespace gsim::studio
