// Written paths are read back; errors are reported with their source location.
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/mangled_text.h"
#include "tests/toolpath/random_path.h"
#include "toolpath/json/json_reader.h"
#include "toolpath/json/json_writer.h"

namespace gsim::path::json_test {
namespace {

using test::is_located;

std::string error_of(const std::string& text) {
    const auto file = read_json(text, "f");
    return file ? "no error" : file.error().message;
}

TEST(PathJson, RoundTripsRandomPrograms) {
    std::mt19937 random(1);
    for (int i = 0; i < 300; ++i) {
        RandomPathOptions options;
        options.machine_points = i % 2 == 0;
        const Program program = random_program(random, options);
        const auto read = read_json(to_json(program), "f");
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->program, program);
    }
}

TEST(PathJson, RoundTripsAllKindsOfOrientation) {
    Program program{"n", {{"p", {}}}, 0};
    Point point;
    for (const Orientation& each : std::vector<Orientation>{ToolAxis{{0, 1e-3, 2}}, RollPitchYaw{1, 2, 3},
                                                            RotaryAxes{{'A', -1.5}, {'C', 1e-17}}}) {
        point.orientation = each;
        point.feed_deg_min = 0.1;
        program.paths[0].targets.emplace_back(point);
    }
    EXPECT_EQ(read_json(to_json(program), "f").value().program, program);
}

TEST(PathJson, ReportsSourceLocationsOfTargets) {
    const auto file = read_json(
        "{\"paths\": [\n {\"name\": \"a\", \"targets\": [\n  {\"position_mm\": [1, 2, 3]},\n"
        "  {\"path\": \"b\", \"repeats\": 2}]},\n {\"name\": \"b\", \"targets\": [{\"position_mm\": "
        "[4,5,6]}]}]}",
        "f");
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_EQ(file->with_location({0, 1}, "x"), "f:4:3: x");
    EXPECT_EQ(file->with_location({1, 0}, "x"), "f:5:28: x");
    EXPECT_EQ(file->with_location({1, std::nullopt}, "x"), "f:5:2: x");
    EXPECT_EQ(std::get<SubPath>(file->program.paths[0].targets[1]), (SubPath{1, 2}));
}

TEST(PathJson, RootIsFirstPathUnlessNamed) {
    const std::string paths =
        "\"paths\": [{\"name\": \"a\", \"targets\": [{\"position_mm\": [1, 2, 3]}]},"
        "{\"name\": \"b\", \"targets\": [{\"position_mm\": [1, 2, 3]}]}]";
    EXPECT_EQ(read_json("{" + paths + "}", "f").value().program.root, 0U);
    EXPECT_EQ(read_json("{\"root\": \"b\", " + paths + "}", "f").value().program.root, 1U);
}

std::string with_target(const std::string& target) {
    return "{\"paths\": [{\"name\": \"a\", \"targets\": [\n" + target + "]}]}";
}

struct Wrong {
    std::string text;
    std::string error;
};

TEST(PathJson, ErrorsNameLocationAndReason) {
    const std::vector<Wrong> cases = {
        {"", "f:1:1: syntax error while parsing value - unexpected end of input"},
        {"[]", "f:1:1: a path file must be an object {...}, not an array"},
        {"{}", "f:1:1: a path file needs 'paths' with at least one path"},
        {"{\"pahts\": []}", "f:1:2: unknown key 'pahts' in the path file; did you mean 'paths'?"},
        {"{\"paths\": 3}", "f:1:11: 'paths' must be an array of paths, not a number"},
        {"{\"name\": \"a\", \"name\": \"b\"}", "f:1:15: 'name' is given twice"},
        {"{\"paths\": [{\"name\": \"a\"}]}", "f:1:12: a path lacks the key 'targets'"},
        {"{\"root\": \"b\", " + with_target("{\"position_mm\": [1, 2, 3]}").substr(1),
         "f:1:10: no path has the name 'b'"},
        {with_target("{\"position_mm\": [1, 2]}"),
         "f:2:21: 'position_mm' must contain three numbers; it contains 2"},
        {with_target("{\"position_mm\": [1, 2, 3, 4]}"),
         "f:2:27: 'position_mm' must contain three numbers, not more"},
        {with_target("{\"position_mm\": [1, 2, true]}"),
         "f:2:24: 'position_mm' must contain three numbers, not true or false"},
        {with_target("{\"motion\": \"liner\", \"position_mm\": [1, 2, 3]}"),
         "f:2:12: 'motion' must be \"rapid\" or \"linear\" or \"circular\""},
        {with_target("{\"motion\": \"linear\"}"), "f:2:1: a point lacks the key 'position_mm'"},
        {with_target("{\"path\": \"b\"}"), "f:2:1: no path has the name 'b'"},
        {with_target("{\"path\": \"a\", \"dwell_s\": 1}"),
         "f:2:1: a target with the key 'path' is a sub-path and cannot have 'dwell_s'"},
        {with_target("{\"path\": \"a\", \"repeats\": 1.5}"),
         "f:2:26: 'repeats' must be an integer from 1 to 1000000000; it is 1.5"},
        {with_target("{\"position_mm\": [1, 2, 3], \"via_mm\": [1, 2, 3]}"),
         "f:2:1: 'via_mm' is only for circular motions"},
        {with_target("{\"position_mm\": [1, 2, 3], \"tool_axis\": [0, 0, 1], \"rpy_deg\": [0, 0, 0]}"),
         "f:2:1: a point may have only one of 'tool_axis', 'rpy_deg' and 'rotary_deg'"},
        {with_target("{\"position_mm\": [1, 2, 3], \"rotary_deg\": {\"BC\": 1}}"),
         "f:2:49: 'rotary_deg' must contain axes by one capital letter each, such as B, not 'BC'"},
        {with_target("{\"position_mm\": [1, 2, 3], \"feed_mm_min\": -1}"),
         "f:2:1: 'feed_mm_min' must be greater than 0 and at most 1e9; it is -1"},
        {with_target("{\"position_mm\": [1, 2, 3], \"feed_mm_min\": \"fast\"}"),
         "f:2:43: 'feed_mm_min' must be a number, not a string"},
    };
    for (const Wrong& each : cases) {
        EXPECT_EQ(error_of(each.text).substr(0, each.error.size()), each.error) << each.text;
    }
}

TEST(PathJson, CorruptFilesAreReadOrRejectedWithLocation) {
    std::mt19937 random(2);
    const std::string full = to_json(random_program(random));
    for (int i = 0; i < 3000; ++i) {
        const std::string text = test::mangled(random, full);
        const auto file = read_json(text, "f");
        EXPECT_TRUE(file || is_located(file.error().message)) << error_of(text);
    }
}

TEST(PathJson, RejectsDeepNestingAndHugeNumbers) {
    EXPECT_TRUE(is_located(error_of(std::string(1'000'000, '['))));
    EXPECT_TRUE(is_located(error_of(with_target("{\"position_mm\": [1e999, 0, 0]}"))));
    EXPECT_TRUE(is_located(error_of(with_target("{\"position_mm\": [1e300, 0, 0]}"))));
    EXPECT_TRUE(is_located(error_of(with_target("{\"position_mm\": [99999999999999999999999, 0, 0]}"))));
    EXPECT_TRUE(is_located(error_of(std::string("{\"name\": \"a\0b\"}", 15))));
}

}  // namespace
}  // namespace gsim::path::json_test
