#include "engine/path_translation.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/run.h"
#include "tests/build_files/build_files.h"
#include "tests/engine/memory_files.h"

namespace gsim::engine::path_translation_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr const char* kScript =
    "return path{name='p', point{motion='rapid', position_mm={1, 2, 3}, tool_axis={0, 0, 1}},"
    " point{position_mm={11, 2, 3}, tool_axis={0, 0, 1}, feed_mm_min=600}}\n";

PathRequest request_of_path(const std::string& name, std::map<std::string, std::string> files) {
    PathRequest request;
    request.path = name;
    request.post = "ab9";
    request.host.files = given(std::move(files));
    return request;
}

tl::expected<std::string, Error> program_of(PathRequest request) {
    return PathTranslation::open(std::move(request))
        .and_then([](PathTranslation result) -> tl::expected<std::string, Error> {
            if (auto read = result.read(); !read) return tl::unexpected(read.error());
            if (auto planned = result.plan(); !planned) return tl::unexpected(planned.error());
            std::string text;
            const auto written = result.write([&](const std::string&) {
                return [&](std::string_view part) {
                    text += part;
                    return true;
                };
            });
            if (!written) return tl::unexpected(written.error());
            return text;
        });
}

TEST(PathTranslation, ProgramHasLengthOfPath) {
    const auto program = program_of(request_of_path("p.lua", {{"p.lua", kScript}}));
    ASSERT_TRUE(program) << program.error().message;
    engine::Run run = engine::Run::open(make_request("p.nc", {{"p.nc", *program}})).value();
    ASSERT_TRUE(run.prepare());
    const Report report = run.go().value();
    EXPECT_NEAR(report.distances.feed_mm, 10, 1e-9);
}

std::string sample(const std::string& name) {
    std::ifstream file(tests::source_path("samples/") + name);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

/// The extents of X and Y in a run of a path's program.
std::array<double, 4> extents_of(const std::string& program, const std::string& data) {
    Request request = make_request("p.ngc", {{"p.ngc", program}, {"d.txt", data}});
    request.machine = "router3.toml";
    request.language.dialect = "rs274ngc";
    request.host.files =
        given({{"p.ngc", program}, {"d.txt", data}, {"router3.toml", sample("machines/router3.toml")}});
    if (!data.empty()) request.machine_data = "d.txt";
    Run run = Run::open(std::move(request)).value();
    EXPECT_TRUE(run.prepare());
    std::array<double, 4> extents{1e9, -1e9, 1e9, -1e9};
    run.on_moves([&](std::span<const Move> moves) {
        for (const Move& move : moves) {
            if (move.kind != MoveKind::linear) continue;
            for (const std::size_t axis : {0U, 1U}) {
                extents[2 * axis] = std::min(extents[2 * axis], move.end[axis]);
                extents[2 * axis + 1] = std::max(extents[2 * axis + 1], move.end[axis]);
            }
        }
    });
    EXPECT_TRUE(run.go().value().is_clean());
    return extents;
}

// The numbers of a path are counted from its work offset; those of the frame that it moves with are not.
TEST(PathTranslation, FrameChangeMovesPathWithAnyWorkOffset) {
    constexpr const char* kPoints =
        "point{motion='rapid', position_mm={0, 0, -5}}, point{position_mm={0, 0, -10}, feed_mm_min=600},"
        " point{position_mm={80, 0, -10}}, point{motion='rapid', position_mm={80, 0, -5}}}\n";
    const std::string set = "return path{name='p', work_offset='G55', set_offset_mm={100, 50, -80}, ";
    const std::string kept = "return path{name='p', work_offset='G55', ";
    const std::string bare = "return path{name='p', ";
    const std::string data = "NCFILE\nOFFSET\n54 100 50 -80\n55 100 50 -80\nENDFILE\n";
    // From 100, 50 along X, turned about that position by 90 degrees: along Y.
    const FramePose fixture{.origin_mm = {100, 50, -80}};
    FramePose turned = fixture;
    turned.rpy_deg[0] = 90;
    for (const auto& [head, of_run] : {std::pair{set, std::string()}, {kept, data}, {bare, data}}) {
        PathRequest request = request_of_path(
            "p.lua",
            {{"p.lua", head + kPoints}, {"d.txt", data}, {"router3.toml", sample("machines/router3.toml")}});
        request.post = "rs274ngc";
        request.machine = "router3.toml";
        if (!of_run.empty()) request.machine_data = "d.txt";
        const auto plain = program_of(request);
        ASSERT_TRUE(plain) << plain.error().message;
        const std::array<double, 4> before = extents_of(*plain, of_run);
        EXPECT_NEAR(before[0], 100, 1e-6);
        EXPECT_NEAR(before[1], 180, 1e-6);
        request.changes.from = fixture;
        request.changes.to = turned;
        const auto program = program_of(request);
        ASSERT_TRUE(program) << program.error().message;
        const std::array<double, 4> behind = extents_of(*program, of_run);
        EXPECT_NEAR(behind[0], 100, 1e-3) << head;
        EXPECT_NEAR(behind[1], 100, 1e-3) << head;
        EXPECT_NEAR(behind[2], 50, 1e-3) << head;
        EXPECT_NEAR(behind[3], 130, 1e-3) << head;
    }
}

TEST(PathTranslation, WritesRequestedDecimals) {
    PathRequest request =
        request_of_path("p.lua", {{"p.lua",
                                   "return path{name='p', point{motion='rapid', position_mm={1.23456, 2, 3}, "
                                   "tool_axis={0, 0, 1}}}\n"}});
    request.format.decimals_mm = 2;
    const std::string coarse = program_of(request).value();
    request.format.decimals_mm = 4;
    EXPECT_THAT(coarse, HasSubstr("X1.23"));
    EXPECT_THAT(coarse, testing::Not(HasSubstr("X1.234")));
    EXPECT_THAT(program_of(request).value(), HasSubstr("X1.2346"));
}

TEST(PathTranslation, MarksErrorOfPathAsInProgramWithLine) {
    const auto result = program_of(request_of_path("p.lua", {{"p.lua", "return path{point{nonsense=1}}\n"}}));
    ASSERT_FALSE(result);
    EXPECT_TRUE(result.error().in_program);
    EXPECT_THAT(result.error().message, HasSubstr("p.lua:1"));
}

TEST(PathTranslation, UnreadablePathIsNoErrorInProgram) {
    const auto missing = program_of(request_of_path("none.path.json", {}));
    ASSERT_FALSE(missing);
    EXPECT_FALSE(missing.error().in_program);
    EXPECT_EQ(missing.error().code, "file");

    PathRequest broken = request_of_path("pipe", {});
    broken.bytes = [](char*, std::size_t) -> tl::expected<std::size_t, std::string> {
        return tl::unexpected<std::string>("the pipe broke");
    };
    const auto result = program_of(broken);
    ASSERT_FALSE(result);
    EXPECT_FALSE(result.error().in_program);
    EXPECT_EQ(result.error().message, "the pipe broke");
}

TEST(PathTranslation, TakesFixedPointsFromMachineData) {
    PathRequest request =
        request_of_path("p.lua", {{"p.lua", "return path{name='p', point{fixed='park'}}\n"},
                                  {"d.txt", "NCFILE\nFIXED\n3 10 20 30 NAME=PARK\nENDFILE\n"},
                                  {"broken.txt", "NCFILE\nFIXED\n3 10\nENDFILE\n"}});
    const auto nowhere = program_of(request);
    ASSERT_FALSE(nowhere);
    EXPECT_TRUE(nowhere.error().in_program);
    EXPECT_THAT(nowhere.error().message,
                HasSubstr("p.lua:1: the position of the fixed point 'park' is not defined"));

    request.machine_data = "broken.txt";
    const auto broken = program_of(request);
    ASSERT_FALSE(broken);
    EXPECT_FALSE(broken.error().in_program);
    EXPECT_THAT(broken.error().message, HasSubstr("broken.txt:3"));

    request.machine_data = "d.txt";
    EXPECT_THAT(program_of(request).value(), HasSubstr("G53 G00 X10.000 Y20.000\n"));
}

TEST(PathTranslation, RejectsUnknownPost) {
    EXPECT_THAT(post_names(), Contains("ab9"));
    PathRequest request = request_of_path("p.lua", {{"p.lua", kScript}});
    request.post = "nobody";
    const auto result = PathTranslation::open(request);
    ASSERT_FALSE(result);
    EXPECT_THAT(result.error().message, HasSubstr("nobody"));
    EXPECT_FALSE(result.error().in_program);
}

}  // namespace
}  // namespace gsim::engine::path_translation_test
