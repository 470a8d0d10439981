#include "engine/path_translation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/run.h"
#include "tests/engine/given.h"

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

tl::expected<std::string, Failure> program_of(PathRequest request) {
    return PathTranslation::open(std::move(request))
        .and_then([](PathTranslation made) -> tl::expected<std::string, Failure> {
            if (auto read = made.read(); !read) return tl::unexpected(read.error());
            if (auto planned = made.plan(); !planned) return tl::unexpected(planned.error());
            std::string text;
            const auto written = made.write([&](const std::string&) {
                return [&](std::string_view part) {
                    text += part;
                    return true;
                };
            });
            if (!written) return tl::unexpected(written.error());
            return text;
        });
}

TEST(PathTranslation, ItsProgramGoesTheWayOfThePath) {
    const auto program = program_of(request_of_path("p.lua", {{"p.lua", kScript}}));
    ASSERT_TRUE(program) << program.error().message;
    engine::Run run = engine::Run::open(request_of("p.nc", {{"p.nc", *program}})).value();
    ASSERT_TRUE(run.prepare());
    const Report report = run.go().value();
    EXPECT_NEAR(report.feed_mm, 10, 1e-9);
}

TEST(PathTranslation, DecimalsAreThoseThatAreAskedFor) {
    PathRequest request =
        request_of_path("p.lua", {{"p.lua",
                                   "return path{name='p', point{motion='rapid', position_mm={1.23456, 2, 3}, "
                                   "tool_axis={0, 0, 1}}}\n"}});
    request.decimals_mm = 2;
    const std::string coarse = program_of(request).value();
    request.decimals_mm = 4;
    EXPECT_THAT(coarse, HasSubstr("X1.23"));
    EXPECT_THAT(coarse, testing::Not(HasSubstr("X1.234")));
    EXPECT_THAT(program_of(request).value(), HasSubstr("X1.2346"));
}

TEST(PathTranslation, AMistakeOfThePathIsInTheProgramAndHasItsPlace) {
    const auto made = program_of(request_of_path("p.lua", {{"p.lua", "return path{point{nonsense=1}}\n"}}));
    ASSERT_FALSE(made);
    EXPECT_TRUE(made.error().in_program);
    EXPECT_THAT(made.error().message, HasSubstr("p.lua:1"));
}

TEST(PathTranslation, APathThatCannotBeReadIsNoMistakeOfIts) {
    const auto missing = program_of(request_of_path("none.path.json", {}));
    ASSERT_FALSE(missing);
    EXPECT_FALSE(missing.error().in_program);
    EXPECT_EQ(missing.error().code, "file");

    PathRequest broken = request_of_path("pipe", {});
    broken.bytes = [](char*, std::size_t) -> tl::expected<std::size_t, std::string> {
        return tl::unexpected<std::string>("the pipe broke");
    };
    const auto made = program_of(broken);
    ASSERT_FALSE(made);
    EXPECT_FALSE(made.error().in_program);
    EXPECT_EQ(made.error().message, "the pipe broke");
}

TEST(PathTranslation, FixedPointsLieWhereTheMachineDataHaveThem) {
    PathRequest request =
        request_of_path("p.lua", {{"p.lua", "return path{name='p', point{fixed='park'}}\n"},
                                  {"d.txt", "NCFILE\nFIXED\n3 10 20 30 NAME=PARK\nENDFILE\n"},
                                  {"broken.txt", "NCFILE\nFIXED\n3 10\nENDFILE\n"}});
    const auto nowhere = program_of(request);
    ASSERT_FALSE(nowhere);
    EXPECT_TRUE(nowhere.error().in_program);
    EXPECT_THAT(nowhere.error().message,
                HasSubstr("p.lua:1: nothing says where the fixed point 'park' lies"));

    request.machine_data = "broken.txt";
    const auto broken = program_of(request);
    ASSERT_FALSE(broken);
    EXPECT_FALSE(broken.error().in_program);
    EXPECT_THAT(broken.error().message, HasSubstr("broken.txt:3"));

    request.machine_data = "d.txt";
    EXPECT_THAT(program_of(request).value(), HasSubstr("G53 G00 X10.000 Y20.000\n"));
}

TEST(PathTranslation, PostsHaveNamesAndOthersAreRefused) {
    EXPECT_THAT(post_names(), Contains("ab9"));
    PathRequest request = request_of_path("p.lua", {{"p.lua", kScript}});
    request.post = "nobody";
    const auto made = PathTranslation::open(request);
    ASSERT_FALSE(made);
    EXPECT_THAT(made.error().message, HasSubstr("nobody"));
    EXPECT_FALSE(made.error().in_program);
}

}  // namespace
}  // namespace gsim::engine::path_translation_test
