#include "codegen/post/gcode_writer.h"

#include <array>

#include <gtest/gtest.h>

#include "codegen/post/post_file.h"

namespace gsim::codegen::gcode_writer_test {
namespace {

constexpr std::array<GcodeAxis, 4> kAxes{{{'X', false}, {'Y', false}, {'Z', false}, {'B', true}}};
constexpr GcodeFeed kFeed{1000, false};

struct Text {
    explicit Text(const std::string& post_name, WriterOptions options = {})
        : post(find_post(post_name).value()),
          writer(post, kAxes, options, [this](std::string_view chunk) { text += chunk; }) {}
    std::string all() {
        writer.text().flush();
        return text;
    }
    void to(double x, double y, double z, double b) { writer.move(std::array{x, y, z, b}, kFeed); }
    Post post;
    std::string text;
    GcodeWriter writer;
};

TEST(GcodeWriter, OmitsUnchangedWords) {
    Text ngc("rs274ngc");
    ngc.to(1, 2, 3, 0);
    ngc.to(1, 2.5, 3, 0);
    ngc.to(1, 2.50001, 3, 0);
    ngc.writer.move(std::array{1.0, 2.5, 9.0, -0.00001}, std::nullopt);
    EXPECT_EQ(ngc.all(), "G01 X1 Y2 Z3 B0 F1000\nY2.5\nG00 Z9\n");
}

TEST(GcodeWriter, VerboseOptionWritesAllWords) {
    Text ngc("rs274ngc", {.inch = false, .verbose_words = true});
    ngc.to(1, 2, 3, 0);
    ngc.to(1, 2.5, 3, 0);
    EXPECT_EQ(ngc.all(), "G01 X1 Y2 Z3 B0 F1000\nG01 X1 Y2.5 Z3 B0 F1000\n");
}

TEST(GcodeWriter, FormatsNumbersByPost) {
    Text ab9("ab9"), fanuc("fanuc"), ngc("rs274ngc", {.inch = true, .verbose_words = false});
    for (Text* each : {&ab9, &fanuc, &ngc}) each->to(500, -0.0004, 25.4, -360);
    EXPECT_EQ(ab9.all(), "N00005 G01 X500.000 Y0.000 Z25.400 B-360.000 F1000.000\n");
    EXPECT_EQ(fanuc.all(), "N10 G01 X500. Y0. Z25.4 B-360. F1000.\n");
    EXPECT_EQ(ngc.all(), "G01 X19.68504 Y-0.00002 Z1 B-360 F39.37\n");
}

TEST(GcodeWriter, WritesFullIntermediatePointOfArc) {
    Text ab9("ab9");
    ab9.to(0, 0, 0, 0);
    ab9.writer.arc_through(std::array{20.0, 0.0, 0.0, 0.0}, {10, 0, 10.0004}, kFeed);
    ab9.writer.arc_through(std::array{20.0, 0.0, 20.0, 0.0}, {20, 10, 10}, kFeed);
    ab9.to(1, 0, 20, 0);
    EXPECT_EQ(ab9.all(),
              "N00005 G01 X0.000 Y0.000 Z0.000 B0.000 F1000.000\n"
              "N00010 CIP X20.000 I1=10.000 J1=0.000 K1=10.000\n"
              "N00015 CIP Z20.000 I1=20.000 J1=10.000 K1=10.000\n"
              "N00020 G01 X1.000\n");
}

TEST(GcodeWriter, MeasuresCentresFromPrintedPosition) {
    Text ab9("ab9");
    ab9.to(10.0004, 0, 0, 0);
    ab9.writer.arc(std::array{20.0004, 10.0, 0.0, 0.0}, {Plane::xy, true, {10.0003, 0, 0}}, kFeed);
    ab9.to(20.0001, 10, 0, 0);  // prints no block, and is still there
    ab9.writer.arc(std::array{30.0, 0.0, 0.0, 0.0}, {Plane::xy, true, {-0.0004, -10, 0}}, kFeed);
    EXPECT_EQ(ab9.all(),
              "N00005 G01 X10.000 Y0.000 Z0.000 B0.000 F1000.000\n"
              "N00010 G17 G02 X20.000 Y10.000 I10.001 J0.000\n"
              "N00015 X30.000 Y0.000 I0.000 J-10.000\n");
}

TEST(GcodeWriter, WritesAccelerationIfPostSupportsIt) {
    Text ab9("ab9"), ngc("rs274ngc");
    for (Text* each : {&ab9, &ngc}) {
        each->writer.acceleration(500);
        each->writer.acceleration(500.0001);
        each->to(1, 2, 3, 0);
    }
    EXPECT_EQ(ab9.all(),
              "N00005 G48.1 X500.000 Y500.000 Z500.000\nN00010 G48.2 X500.000 Y500.000 Z500.000\n"
              "N00015 G01 X1.000 Y2.000 Z3.000 B0.000 F1000.000\n");
    EXPECT_EQ(ngc.all(), "G01 X1 Y2 Z3 B0 F1000\n");
    Text inch("ab9", {.inch = true, .verbose_words = false});
    inch.writer.acceleration(254);
    EXPECT_TRUE(inch.all().starts_with("N00005 G48.1 X10.000 Y10.000 Z10.000\n"));
}

TEST(GcodeWriter, WritesArcsInEachPlane) {
    Text ngc("rs274ngc");
    ngc.to(10, 0, 0, 0);
    ngc.writer.arc(std::array{0.0, 10.0, 5.0, 0.0}, {Plane::xy, false, {-10, 0, 0}}, kFeed);
    ngc.writer.arc(std::array{0.0, 10.0, 5.0, 0.0}, {Plane::xy, true, {0, -10, 0}}, kFeed);
    ngc.writer.arc(std::array{0.0, 20.0, 15.0, 0.0}, {Plane::yz, true, {0, 10, 0}}, kFeed);
    ngc.writer.arc(std::array{10.0, 20.0, 5.0, 0.0}, {Plane::zx, true, {0, 0, -10}}, kFeed);
    EXPECT_EQ(ngc.all(),
              "G01 X10 Y0 Z0 B0 F1000\nG17 G03 X0 Y10 Z5 I-10 J0\nG02 X0 Y10 I0 J-10\n"
              "G19 Y20 Z15 J10 K0\nG18 X10 Z5 I0 K-10\n");
}

TEST(GcodeWriter, WritesAllWordsAfterCall) {
    Text ab9("ab9");
    ab9.to(1, 2, 3, 4);
    ab9.writer.text().placeholders()["number"] = "0007";
    ab9.writer.text().lines(ab9.post.subprogram->call);
    ab9.writer.forget();
    ab9.to(1, 2, 3, 4);
    EXPECT_EQ(ab9.all(),
              "N00005 G01 X1.000 Y2.000 Z3.000 B4.000 F1000.000\nN00010 M98P0007\n"
              "N00015 G01 X1.000 Y2.000 Z3.000 B4.000 F1000.000\n");
}

TEST(GcodeWriter, WritesActionsAndDwells) {
    Text ab9("ab9");
    ab9.writer.action("waterjet_on");
    ab9.writer.action("clamp (left) \xc3\xa4;");
    ab9.writer.dwell(0.25);
    EXPECT_EQ(ab9.all(),
              "N00005 M08\n(action: clamp left ?"
              "?)\nN00010 G04 P0.250\n");
}

TEST(GcodeWriter, RestartsBlockNumbersBeforeOverflow) {
    Text ab9("ab9");
    for (int i = 0; i < 20'000; ++i) ab9.writer.dwell(1);
    const std::string text = ab9.all();
    EXPECT_NE(text.find("N99995 G04 P1.000\nN00005 G04"), std::string::npos);
}

// All axes are written again after the retract, and after another system.
TEST(GcodeWriter, WritesAllAxesAfterRetractAndNewOffset) {
    Text ngc("rs274ngc", {.inch = true}), ab9("ab9");
    for (Text* each : {&ngc, &ab9}) {
        each->writer.offsets().set_origin("59.1", {25.4, -50.8, 0});
        each->to(25.4, 0, 0, 0);
        each->writer.machine().retract(127);
        each->to(25.4, 0, 0, 0);
        each->writer.offsets().select("59.1");
        each->to(25.4, 0, 0, 0);
    }
    EXPECT_EQ(
        ngc.all(),
        "G10 L2 P7 X1 Y-2 Z0 R0\nG01 X1 Y0 Z0 B0 F39.37\nG53 G00 Z5\nG01 X1 Y0 Z0 B0\nG59.1\nX1 Y0 Z0 B0\n");
    EXPECT_EQ(ab9.all().substr(0, 51), "N00005 G10 L2 P7 X25.400 Y-50.800 Z0.000\nN00010 G01");
}

TEST(PostFile, FindsBuiltInPosts) {
    for (const std::string name : {"ab9", "fanuc", "rs274ngc", "grbl"}) {
        EXPECT_EQ(find_post(name).value().name, name);
    }
    EXPECT_FALSE(find_post("grbl").value().subprogram);
    EXPECT_EQ(find_post("gbrl").error().message,
              "unknown post 'gbrl'; use ab9, fanuc, rs274ngc, grbl, or a file that ends in .toml");
}

TEST(PostFile, RejectsUnsafeSubprogramFileNames) {
    const auto error_of = [](const std::string& file) {
        const auto post = read_post(
            "name = \"p\"\nreads_as = \"ab9\"\n[numbers]\ndecimals_mm = 3\ndecimals_inch = 4\n"
            "decimals_deg = 3\ndecimals_feed = 1\nzeros = \"cut\"\n[blocks]\nnumber_step = 0\n"
            "number_digits = 0\ndwell = \"G4\"\n[program]\nbegin = []\nend = []\n[subprogram]\n"
            "order = \"after\"\nbegin = []\nend = []\ncall = []\ncall_repeated = []\n"
            "file = '" +
                file + "'\n",
            "p.toml");
        return post ? std::string() : post.error().message;
    };
    for (const std::string file :
         {"O{number}.nc", "{program}_O{number}.ppg", "{lower}_o{number}", "a-b.{number}"})
        EXPECT_EQ(error_of(file), "") << file;
    for (const std::string file :
         {".bashrc{number}", "../{number}", "a/{number}", "-{number}", "{number} {program}", "{number}..nc",
          "{number}~", "{number}*", "{number}\\a", "a:{number}", "", "ä{number}"}) {
        EXPECT_EQ(error_of(file),
                  "p.toml:22:8: 'file' must be a name of letters, digits, '_', '-' and '.', of at most 100 "
                  "characters, that begins with a letter, a digit, '_' or a placeholder, such as "
                  "\"{program}_O{number}.nc\"")
            << file;
    }
    for (const std::string file : {"sub.nc", "{program}.nc", "{lower}"})
        EXPECT_EQ(error_of(file),
                  "p.toml:22:8: 'file' must contain {number}, so that each subprogram has a separate file");
    EXPECT_NE(error_of(std::string(101, 'a') + "{number}"), "");
}

TEST(PostFile, HasBlocksForReferencePoints) {
    const auto count = [](const std::string& name) { return find_post(name).value().references.go.size(); };
    EXPECT_EQ(count("ab9"), 4U);
    EXPECT_EQ(count("fanuc"), 4U);
    EXPECT_EQ(count("rs274ngc"), 2U) << "G28 and G30";
    EXPECT_EQ(count("grbl"), 2U) << "G28 and G30";
}

TEST(PostFile, DefinesEffectOfToolChange) {
    const auto stops = [](const std::string& name) { return find_post(name).value().tool_change; };
    EXPECT_EQ(stops("rs274ngc"), (ToolChangeWords{true, false}));
    EXPECT_EQ(stops("fanuc"), (ToolChangeWords{true, true}));
    EXPECT_EQ(stops("ab9"), ToolChangeWords{});
}

TEST(PostFile, ErrorsNameSourceLocation) {
    const auto error = [](const std::string& text) { return read_post(text, "p").error().message; };
    EXPECT_EQ(error("name = 1"), "p:1:8: 'name' must be a string, not a number");
    EXPECT_EQ(error("nmae = \"x\""), "p:1:1: unknown key 'nmae' in the post; did you mean 'name'?");
    const std::string head = "name = \"x\"\nreads_as = \"ab9\"\n";
    EXPECT_EQ(error(head + "[numbers]\ndecimals_mm = 2.5"),
              "p:4:15: 'decimals_mm' must be an integer from 0 to 6");
    const std::string numbers =
        "[numbers]\ndecimals_mm = 3\ndecimals_inch = 4\ndecimals_deg = 3\ndecimals_feed = 3\nzeros = "
        "\"cut\"\n";
    EXPECT_EQ(error(head + numbers + "[blocks]\nnumber_step = 0\nnumber_digits = 0\ndwell = \"G4 P{sec}\""),
              "p:12:9: 'dwell' has no placeholder {sec}; it may contain {seconds}, {milliseconds}");
    EXPECT_EQ(error("[program]\nbegin = [3]").substr(0, 2), "p:");
    const std::string blocks = "[blocks]\nnumber_step = 0\nnumber_digits = 0\ndwell = \"G4\"\n";
    EXPECT_EQ(error(head + numbers + blocks + "[arcs]\nthrough_point = [\"CIP\", \"I1=\"]"),
              "p:14:17: 'through_point' must have four strings: the code, and the letters of X, Y and Z of "
              "the point");
    EXPECT_EQ(error(head + numbers + blocks +
                    "[program]\nbegin = []\nend = []\n[offsets]\nset = \"G10 P{index} X{x} Y{y}\""),
              "p:17:7: 'set' must contain {index}, {x}, {y}, {z}");
    EXPECT_EQ(
        error(head + numbers + blocks + "[program]\nbegin = []\nend = []\n[tool_change]\nstops = [\"jet\"]"),
        "p:17:9: 'stops' must contain spindle and coolant, not \"jet\"");
    const std::string full = head + numbers + blocks + "[program]\nbegin = []\nend = []\n";
    EXPECT_EQ(error(full + "[reference_points]\ngo = [\"G28\"]"),
              "p:17:6: each line of 'go' must contain {axes}");
    EXPECT_EQ(error(full + "[reference_points]\ngo = [\"G28 {axis}\"]"),
              "p:17:7: 'go' has no placeholder {axis}; it may contain {axes}");
    EXPECT_EQ(
        error(full + "[reference_points]\ngo = [\"{axes}\", \"{axes}\", \"{axes}\", \"{axes}\", \"{axes}\"]"),
        "p:17:6: 'go' must have a line for each reference point, at most 4");
    EXPECT_EQ(error(full + "[probe]\ntouch = [\"G31 {axis}{to}\"]"),
              "p:17:9: 'touch' must contain {axis}, {to}, {surface}");
}

}  // namespace
}  // namespace gsim::codegen::gcode_writer_test
