// path2gcode in full: the test part of the thesis word by word, files, messages, and LinuxCNC's interpreter.
#include <cmath>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "base/text/json.h"
#include "tests/apps/canon_ends.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::path2gcode_test {
namespace {

const std::string kWheel = tests::source_path("samples/wheel.path.json");

class Path2Gcode : public Apps {
  protected:
    Ended path2gcode(const std::vector<std::string>& arguments, const std::string& input = {}) const {
        return run_program(tests::program_path("path2gcode"), arguments, folder_, input);
    }
    static std::string built_in_post(const std::string& name) {
        std::ifstream file(tests::source_path("samples/posts/") + name + ".toml");
        return {std::istreambuf_iterator<char>(file), {}};
    }
};

/// Words of a block with the machine's target, and whether an arc turns clockwise.
struct Block {
    std::string name;  ///< Its N word.
    std::map<char, double> words;
    int motion = -1;  ///< G0 to G3, if the block has one.
};

// Blocks with any of X Y Z B C I J, in their order.
std::vector<Block> blocks_of(const std::string& text) {
    static const std::regex kWord("([A-Z])(-?[0-9.]+)");
    std::vector<Block> blocks;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        Block block;
        for (std::sregex_iterator word(line.begin(), line.end(), kWord), end; word != end; ++word) {
            const char letter = (*word)[1].str()[0];
            const double value = std::stod((*word)[2].str());
            if (letter == 'N') block.name = (*word)[0];
            if (letter == 'G' && value <= 3) block.motion = static_cast<int>(value);
            if (std::string("XYZBCIJ").find(letter) != std::string::npos) block.words[letter] = value;
        }
        if (!block.words.empty()) blocks.push_back(block);
    }
    return blocks;
}

std::string appendix_j() {
    const char* folder = std::getenv("GSIM_REFERENCE");
    if (folder == nullptr) return {};
    std::ifstream file(std::string(folder) + "/appendix_j.nc");
    return {std::istreambuf_iterator<char>(file), {}};
}

// Arcs that the thesis's writer ran round the longer side.
const std::set<std::string> kMendedArcs = {"N00120", "N00130", "N00140", "N00165", "N00185", "N00190",
                                           "N00195", "N00220", "N00225", "N00245", "N00285", "N00300"};

TEST_F(Path2Gcode, MatchesThesisTestPartWordByWord) {
    const std::string reference = appendix_j();
    if (reference.empty()) GTEST_SKIP() << "no appendix_j.nc in GSIM_REFERENCE";
    const Ended ended = path2gcode({"--rotary", "as-given", kWheel});
    ASSERT_EQ(ended.status, 0) << ended.err;
    const std::vector<Block> expected_value = blocks_of(reference), got = blocks_of(ended.out);
    ASSERT_EQ(got.size(), expected_value.size());
    int wanted_motion = -1, got_motion = -1;
    for (std::size_t i = 0; i < expected_value.size(); ++i) {
        ASSERT_EQ(got[i].words.size(), expected_value[i].words.size()) << expected_value[i].name;
        for (const auto& [letter, value] : expected_value[i].words) {
            ASSERT_TRUE(got[i].words.contains(letter)) << expected_value[i].name << letter;
            EXPECT_NEAR(got[i].words.at(letter), value, 0.001 + 1e-9) << expected_value[i].name << letter;
        }
        if (expected_value[i].motion >= 0) wanted_motion = expected_value[i].motion;
        if (got[i].motion >= 0) got_motion = got[i].motion;
        const bool other_sense = kMendedArcs.contains(expected_value[i].name);
        EXPECT_EQ(got_motion, other_sense ? 5 - wanted_motion : wanted_motion) << expected_value[i].name;
    }
}

TEST_F(Path2Gcode, ReducesTurningWithSameOrientations) {
    const std::vector<Block> given =
        blocks_of(path2gcode({"--rotary", "as-given", "--verbose-words", kWheel}).out);
    const std::vector<Block> min = blocks_of(path2gcode({"--verbose-words", kWheel}).out);
    ASSERT_EQ(min.size(), given.size());
    double turned_given = 0, turned_least = 0;
    for (std::size_t i = 0; i < given.size(); ++i) {
        EXPECT_NEAR(std::remainder(min[i].words.at('B') - given[i].words.at('B'), 360), 0, 1e-9) << i;
        EXPECT_EQ(min[i].words.at('C'), given[i].words.at('C'));
        if (i == 0) continue;
        turned_given += std::abs(given[i].words.at('B') - given[i - 1].words.at('B'));
        turned_least += std::abs(min[i].words.at('B') - min[i - 1].words.at('B'));
    }
    EXPECT_LT(turned_least, 0.5 * turned_given);
}

TEST_F(Path2Gcode, RunFindsSubPathsInSeparateFiles) {
    const auto end_of = [this](const std::string& program, const std::string& dialect) {
        const Ended ran = gsim_run({"--dialect", dialect, "--quiet", "--report", "r.json", program});
        EXPECT_EQ(ran.status, 0) << ran.err;
        return text::parse_json<nlohmann::json>(read("r.json"))["cycle_time_s"].get<double>();
    };
    for (const std::string dialect : {"ab9", "rs274ngc"}) {
        ASSERT_EQ(path2gcode({"--dialect", dialect, "-o", "whole.nc", kWheel}).status, 0);
        ASSERT_EQ(path2gcode({"--dialect", dialect, "--separate-files", "-o", "wheel.nc", kWheel}).status, 0);
        EXPECT_TRUE(exists(dialect == "ab9" ? "wheel_O0002.ppg" : "wheel_o0002.ngc"));
        EXPECT_NEAR(end_of("wheel.nc", dialect), end_of("whole.nc", dialect), 1e-6) << dialect;
    }
}

TEST_F(Path2Gcode, SubPathFilesReplaceOthersOnlyOnRequest) {
    write("wheel_O0002.ppg", "of somebody else");
    const std::vector<std::string> repeated = {"--separate-files", "-o", "wheel.nc", kWheel};
    const Ended rejected = path2gcode(repeated);
    EXPECT_EQ(rejected.status, 2);
    EXPECT_EQ(rejected.err,
              "path2gcode: the subprogram file 'wheel_O0002.ppg' of the post already exists; --overwrite "
              "replaces it\n");
    EXPECT_EQ(read("wheel_O0002.ppg"), "of somebody else");
    EXPECT_EQ(files(), 1U) << "nothing is written";
    EXPECT_EQ(path2gcode({"--separate-files", "--overwrite", "-o", "wheel.nc", kWheel}).status, 0);
    EXPECT_TRUE(contains(read("wheel_O0002.ppg"), "X"));
    EXPECT_EQ(path2gcode({"--overwrite", "-o", "wheel.nc", kWheel}).status, 2) << "has nothing to say";
}

TEST_F(Path2Gcode, RejectsSubPathFileOverProgramOrInput) {
    const std::string post = built_in_post("ab9");
    write("mine.toml",
          std::regex_replace(post, std::regex("\\nfile = .*\n"), "\nfile = \"sub{number}.nc\"\n"));
    const auto rejected = [this](const std::string& output, const std::string& input) {
        const Ended ended =
            path2gcode({"--dialect", "mine.toml", "--separate-files", "--overwrite", "-o", output, input});
        EXPECT_EQ(ended.status, 2);
        return ended.err;
    };
    EXPECT_EQ(rejected("./sub0002.nc", kWheel),
              "path2gcode: the subprogram file './sub0002.nc' of the post is also the program itself; choose "
              "another name or folder for the output\n");
    std::ifstream file(kWheel);
    const std::string path{std::istreambuf_iterator<char>(file), {}};
    write("sub0002.nc", path);
    std::filesystem::create_hard_link(folder_ / "sub0002.nc", folder_ / "in.path.json");
    EXPECT_TRUE(contains(rejected("wheel.nc", "in.path.json"), "'sub0002.nc' of the post is also the path;"));
    EXPECT_EQ(read("sub0002.nc"), path);
    std::filesystem::remove(folder_ / "sub0002.nc");
    std::filesystem::create_symlink("in.path.json", folder_ / "sub0002.nc");
    EXPECT_TRUE(
        contains(rejected("wheel.nc", kWheel), "'sub0002.nc' of the post exists and is not a regular file"));
    EXPECT_EQ(read("in.path.json"), path);
}

// Standstill at both ends: distance / speed + speed / acceleration.
TEST_F(Path2Gcode, WritesOrReportsAccelerations) {
    write("a.path.json", R"json({"paths": [{"name": "a", "targets": [
        {"motion": "rapid", "position_mm": [100, 100, 100], "rotary_deg": {"B": 0, "C": 0}},
        {"position_mm": [300, 100, 100], "feed_mm_min": 6000, "acceleration_mm_s2": 50},
        {"position_mm": [300, 200, 100]}, {"position_mm": [100, 200, 100], "acceleration_mm_s2": 200}]}]})json");
    const Ended written = path2gcode({"-o", "a.nc", "a.path.json"});
    EXPECT_EQ(written.status, 0);
    EXPECT_EQ(written.err, "");
    EXPECT_TRUE(contains(read("a.nc"), " G48\n")) << "taken back at the end";
    ASSERT_EQ(gsim_run({"--quiet", "--moves", "m.jsonl", "a.nc"}).status, 0);
    std::istringstream lines(read("m.jsonl"));
    std::vector<double> seconds;
    for (std::string line; std::getline(lines, line);) {
        const auto move = text::parse_json<nlohmann::json>(line);
        seconds.push_back(move["end_s"].get<double>() - move["start_s"].get<double>());
    }
    ASSERT_EQ(seconds.size(), 4U);
    EXPECT_NEAR(seconds[1], 200.0 / 100 + 100.0 / 50, 1e-6);
    EXPECT_NEAR(seconds[2], 2 * std::sqrt(100.0 / 50), 1e-6)
        << "as at the point before; too short for the feed";
    EXPECT_NEAR(seconds[3], 200.0 / 100 + 100.0 / 200, 1e-6);
    EXPECT_EQ(
        path2gcode({"--dialect", "fanuc", "-o", "a.nc", "a.path.json"}).err,
        "note: 'acceleration_mm_s2' of 2 points is not written: the post 'fanuc' has no words for it\n");
}

TEST_F(Path2Gcode, ReportsErrorLocationAndWritesNoFile) {
    const auto rejected = [this](const std::string& text, std::vector<std::string> options = {}) {
        write("p.path.json", text);
        options.insert(options.end(), {"-o", "out.nc", "p.path.json"});
        const Ended ended = path2gcode(options);
        EXPECT_EQ(ended.status, 1) << text;
        EXPECT_TRUE(ended.out.empty());
        EXPECT_EQ(files(), 1U) << "only the input";
        return ended.err;
    };
    const std::string head = R"({"paths": [{"name": "a", "targets": [)"
                             "\n";
    const std::string start =
        R"({"position_mm": [1, 2, 3], "rotary_deg": {"B": 0, "C": 0}, "feed_mm_min": 100})";
    EXPECT_EQ(rejected(head),
              "p.path.json:2:1: error: syntax error while parsing value - unexpected end of input; "
              "expected '[', '{', or a literal\n");
    EXPECT_TRUE(contains(rejected(head + R"({"position_mm": [1, 2, 3], "feed_mm_min": 1}]}]})"),
                         "p.path.json:2:1: error: the point needs an orientation"));
    EXPECT_TRUE(contains(rejected(head + start + ",\n" + R"({"position_mm": [1, 2, 3000]}]}]})"),
                         "p.path.json:3:1: error: out of reach: Z 3000 is outside 0 to 609.6"));
    EXPECT_TRUE(contains(rejected(head + start + ",\n" + R"({"path": "a"}]}]})"),
                         "p.path.json:3:1: error: the path 'a' contains itself"));
    EXPECT_TRUE(contains(rejected(head + R"({"position_mm": [1, 2, 3], "rotary_deg": {"B": 0}}]}]})"),
                         "p.path.json:2:1: error: the motion needs 'feed_mm_min'"));
    EXPECT_TRUE(contains(rejected(head + start + "]}]}", {"--dialect", "grbl"}), "axes XYZ"));
}

TEST_F(Path2Gcode, RejectsInvalidOptions) {
    EXPECT_EQ(path2gcode({"--dialect", "x", kWheel}).status, 2);
    EXPECT_EQ(path2gcode({"--machine", "no.toml", kWheel}).status, 2);
    EXPECT_EQ(path2gcode({"--separate-files", kWheel}).status, 2);
    EXPECT_EQ(path2gcode({"-o", "no/such/folder.nc", kWheel}).status, 2);
    EXPECT_EQ(path2gcode({"no.path.json"}).status, 2);
}

TEST_F(Path2Gcode, ReadsStandardInputAndScripts) {
    std::ifstream file(kWheel);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(path2gcode({"-"}, text).out, path2gcode({kWheel}).out);
    const Ended flange = path2gcode({tests::source_path("samples/flange.path.lua")});
    EXPECT_EQ(flange.status, 0) << flange.err;
    EXPECT_TRUE(contains(flange.out, "G17 G03 X348.000 Y369.282 I-8.000 J0.000 F900.000")) << flange.out;
}

/// The post is the user's own.
TEST_F(Path2Gcode, ReadsPostFromFile) {
    std::ifstream file(tests::source_path("samples/posts/fanuc.toml"));
    std::string text{std::istreambuf_iterator<char>(file), {}};
    write("mine.toml", text.replace(text.find("M30"), 3, "M99"));
    EXPECT_TRUE(contains(path2gcode({"--dialect", "mine.toml", kWheel}).out, " M99\n%\n"));
}

TEST_F(Path2Gcode, LinuxCncReachesSamePositions) {
    if (!has_rs274()) GTEST_SKIP() << "LinuxCNC's rs274 is not installed";
    write("part.path.json", R"json({"name": "part", "root": "all", "paths": [
        {"name": "all", "targets": [
            {"motion": "rapid", "position_mm": [100, 100, 100], "rotary_deg": {"B": 0, "C": 0}},
            {"path": "lap", "repeats": 3},
            {"motion": "linear", "position_mm": [200, 100, 100], "rotary_deg": {"B": 90, "C": 30}, "feed_mm_min": 500}]},
        {"name": "lap", "targets": [
            {"position_mm": [150, 100, 100], "rotary_deg": {"B": 10, "C": 5}, "feed_mm_min": 700},
            {"motion": "circular", "position_mm": [100, 150, 100], "center_mm": [100, 100, 100], "turn_deg": 90},
            {"motion": "circular", "position_mm": [100, 150, 100], "center_mm": [100, 100, 100], "turn_deg": 720},
            {"motion": "circular", "position_mm": [100, 100, 150], "center_mm": [100, 100, 100], "normal": [1, 0, 0], "turn_deg": 90},
            {"motion": "circular", "position_mm": [150, 110, 100], "center_mm": [100, 100, 100], "normal": [0, 1, 0], "turn_deg": 90},
            {"motion": "circular", "position_mm": [120, 120, 140], "via_mm": [110, 130, 120], "dwell_s": 0.1,
             "actions": ["abrasive_on", "waterjet_on", "a (name)", "waterjet_off", "abrasive_off"]}]}]})json");
    for (const std::string& input : {std::string("part.path.json"), kWheel}) {
        const Ended written =
            path2gcode({"--dialect", "rs274ngc", "--continue-on-unknown", "-o", "part.ngc", input});
        ASSERT_EQ(written.status, 0) << written.err;
        const Ended canon = run_rs274(folder_, "part.ngc");
        ASSERT_EQ(canon.status, 0) << canon.err.substr(0, 2000);
        const Ended ran = gsim_run({"--dialect", "rs274ngc", "--quiet", "--moves", "m.jsonl", "part.ngc"});
        ASSERT_EQ(ran.status, 0) << ran.err;
        const Ends expected_value = ends_of_canon(canon.out), got = ends_of_moves(read("m.jsonl"));
        ASSERT_EQ(got.size(), expected_value.size());
        ASSERT_GT(expected_value.size(), 20U);
        for (std::size_t i = 0; i < expected_value.size(); ++i) {
            for (std::size_t k = 0; k < 5; ++k)
                EXPECT_NEAR(got[i][k], expected_value[i][k], 1e-4) << i << "XYZBC"[k];
        }
    }
}

}  // namespace
}  // namespace gsim::apps::path2gcode_test
