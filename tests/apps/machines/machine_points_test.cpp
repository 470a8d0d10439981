// Fixed and reference points in paths: written by each post, run with the same machine data, and checked at
// the machine's positions.
#include <fstream>
#include <regex>
#include <sstream>

#include "base/text/json.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::machine_points_test {
namespace {

using nlohmann::json;

const std::string kRouter = tests::source_path("samples/machines/router3.toml");

class MachinePoints : public Apps {
  protected:
    Ended path2gcode(std::vector<std::string> arguments) const {
        return run_program(tests::program_path("path2gcode"), arguments, folder_);
    }
    std::string path(const std::string& targets, const std::string& keys = "",
                     const std::string& more = "") const {
        return write("p.path.json", R"({"paths": [{"name": "p")" + keys + R"(, "targets": [)" + targets +
                                        "]}" + more + "]}");
    }
    std::string written(const std::string& dialect, std::vector<std::string> options) const {
        options.insert(options.end(), {"--quiet", "--dialect", dialect});
        const Ended ended = path2gcode(options);
        EXPECT_EQ(ended.status, 0) << ended.err;
        return ended.out;
    }
    std::string rejected(std::vector<std::string> options, int status = 1) const {
        const Ended ended = path2gcode(options);
        EXPECT_EQ(ended.status, status) << ended.out;
        EXPECT_EQ(ended.out, "");
        return ended.err;
    }
    /// Returns the kind of each move and the axis positions at its end.
    std::vector<std::pair<std::string, json>> driven(const std::string& program, const std::string& dialect,
                                                     std::vector<std::string> options) const {
        const std::string run_dialect = dialect == "fanuc" ? "ab9" : dialect == "grbl" ? "rs274ngc" : dialect;
        options.insert(options.end(),
                       {write("x.nc", program), "--dialect", run_dialect, "--quiet", "--moves", "m.jsonl"});
        const Ended ran = gsim_run(options);
        EXPECT_EQ(ran.status, 0) << ran.err << program;
        std::vector<std::pair<std::string, json>> moves;
        std::istringstream lines(read("m.jsonl"));
        for (std::string line; std::getline(lines, line);) {
            const json move = text::parse_json<json>(line);
            moves.emplace_back(move["kind"], move["to"]);
        }
        return moves;
    }
    static json at(double x, double y, double z) { return {{"X", x}, {"Y", y}, {"Z", z}}; }
    static json at(double x, double y, double z, double b, double c) {
        return {{"X", x}, {"Y", y}, {"Z", z}, {"B", b}, {"C", c}};
    }
};

const char* const kRouterData =
    "NCFILE\nOFFSET\n54 20 15 0\nFIXED\n1 100 50 -30 NAME=PARK\n7 200 60 0\nHOME\n2 110 120 -20\nENDFILE\n";
const char* const kStart = R"({"motion": "rapid", "position_mm": [10, 20, -30]},)";
const char* const kCut = R"({"position_mm": [10, 40, -35], "feed_mm_min": 1000},)";

// The moves are up, across, down; from there up again before the rapid to the work. The cut is where it would
// be without the points.
TEST_F(MachinePoints, EachPostMovesToPointAndBack) {
    path(std::string(kStart) + kCut + R"({"fixed": "park", "dwell_s": 0.5},)" + kStart + kCut +
         R"({"fixed": 7})");
    write("d.txt", kRouterData);
    for (const std::string dialect : {"ab9", "fanuc", "rs274ngc", "grbl"}) {
        const std::vector<std::string> machine = {"--machine", kRouter, "--machine-data", "d.txt"};
        std::vector<std::string> options = machine;
        options.insert(options.begin(), {"p.path.json", "--work-offset", "G54"});
        const std::string program = written(dialect, options);
        const auto moves = driven(program, dialect, machine);
        const std::vector<std::pair<std::string, json>> expected_value = {
            {"rapid", at(30, 35, -30)}, {"linear", at(30, 55, -35)}, {"rapid", at(30, 55, 0)},
            {"rapid", at(100, 50, 0)},  {"rapid", at(100, 50, -30)}, {"dwell", at(100, 50, -30)},
            {"rapid", at(100, 50, 0)},  {"rapid", at(30, 35, -30)},  {"linear", at(30, 55, -35)},
            {"rapid", at(30, 55, 0)},   {"rapid", at(200, 60, 0)},
        };
        EXPECT_EQ(moves, expected_value) << program;
    }
}

// The first point is up already, so Z moves first; the second one is below the path there.
TEST_F(MachinePoints, EachPostWritesReferencePoints) {
    path(R"({"reference": 1},)" + std::string(kStart) + kCut + R"({"reference": 2, "actions": ["stop"]},)" +
         kStart + R"({"position_mm": [10, 40, -35]})");
    write("d.txt", kRouterData);
    const std::vector<std::string> machine = {"--machine", kRouter, "--machine-data", "d.txt"};
    std::vector<std::string> options = machine;
    options.insert(options.begin(), "p.path.json");
    for (const auto& [dialect, words] :
         {std::pair<std::string, std::string>{"ab9", "G91 G30 P2 X0.000 Y0.000\n"},
          {"fanuc", "G91 G30 P2 X0. Y0.\n"},
          {"rs274ngc", "G91 G28 Z0\nG91 G28 X0 Y0\nG90\nG53 G00 Z0\nX10 Y20 Z-30\n"},
          {"grbl", "G53 G00 Z0\nG91 G30 X0 Y0\nG91 G30 Z0\nG90\nM0\nG53 G00 Z0\nX10 Y20 Z-30\n"}}) {
        const std::string program = written(dialect, options);
        EXPECT_TRUE(contains(program, words)) << program;
        const auto moves = driven(program, dialect, machine);
        const auto second = std::find_if(moves.begin(), moves.end(),
                                         [](const auto& move) { return move.second == at(110, 120, -20); });
        ASSERT_NE(second, moves.end()) << program;
        EXPECT_EQ((second - 1)->second, at(110, 120, 0)) << "from above";
        // A stop has no move of its own.
        const auto back =
            std::find_if(second, moves.end(), [](const auto& move) { return move.first == "linear"; });
        ASSERT_NE(back, moves.end()) << program;
        const auto cut =
            std::find_if(moves.begin(), moves.end(), [](const auto& move) { return move.first == "linear"; });
        EXPECT_EQ(back->second, cut->second) << "the same cut behind the point as before it";
    }
}

// The tool is tilted at the point, and the plan continues from there: by the short path, not from the earlier
// position.
TEST_F(MachinePoints, RotaryAxesTakeValuesOfPoint) {
    path(R"({"motion": "rapid", "position_mm": [10, 20, 30], "rotary_deg": {"B": 0, "C": 0}},
            {"position_mm": [10, 40, 30], "feed_mm_min": 1000}, {"fixed": "CLAMP1"},
            {"motion": "rapid", "position_mm": [10, 20, 30], "rotary_deg": {"B": -170}},
            {"position_mm": [10, 40, 30]}, {"path": "park", "repeats": 2},
            {"motion": "rapid", "position_mm": [10, 20, 30]})",
         "", R"(, {"name": "park", "targets": [{"fixed": "PARK"}, {"fixed": 3}]})");
    write("d.txt",
          "NCFILE\nFIXED\n1 100 50 300 NAME=PARK\n2 10 8 12 160 -45 NAME=CLAMP1 inch\n3 90 40 "
          "609.6\nENDFILE\n");
    for (const std::string dialect : {"ab9", "rs274ngc"}) {
        for (const bool inch : {false, true}) {
            std::vector<std::string> options = {"p.path.json", "--machine-data", "d.txt"};
            if (inch) options.emplace_back("--inch");
            const std::string program = written(dialect, options);
            const auto moves = driven(program, dialect, {"--machine-data", "d.txt"});
            ASSERT_EQ(moves.size(), 18U) << program;
            const auto expect_at = [&](std::size_t i, const json& place) {
                for (const auto& [letter, value] : place.items())
                    EXPECT_NEAR(moves[i].second[letter], value.get<double>(), 2e-3) << i << letter << program;
            };
            expect_at(2, at(10, 40, 609.6, 0, 0));
            expect_at(3, at(254, 203.2, 609.6, 160, -45));
            expect_at(4, at(254, 203.2, 304.8, 160, -45));
            expect_at(6, at(10, 20, 30, 190, -45));
            expect_at(7, at(10, 40, 30, 190, -45));
            expect_at(10, at(100, 50, 300, 190, -45));
            expect_at(12, at(90, 40, 609.6, 190, -45));
            expect_at(16, at(90, 40, 609.6, 190, -45));
            expect_at(17, at(10, 20, 30, 190, -45));
        }
    }
}

// On a machine with a TCP that swings as its axes turn, pending lines are written before the path to the
// point.
TEST_F(MachinePoints, TiltingTableMachineReachesPoint) {
    const std::string machine = tests::source_path("samples/machines/mill-table-table.toml");
    path(R"({"motion": "rapid", "position_mm": [10, 10, 20], "rotary_deg": {"A": 0, "C": 0}},
            {"position_mm": [20, 10, 20], "feed_mm_min": 500, "rotary_deg": {"A": 10, "C": 20}}, {"fixed": 1},
            {"motion": "rapid", "position_mm": [10, 10, 20]}, {"position_mm": [20, 10, 20]})");
    write("d.txt", "NCFILE\nFIXED\n1 5 6 40\nENDFILE\n");
    const std::string program =
        written("rs274ngc", {"p.path.json", "--machine", machine, "--machine-data", "d.txt"});
    const auto moves = driven(program, "rs274ngc", {"--machine", machine, "--machine-data", "d.txt"});
    const auto there = std::find_if(moves.begin(), moves.end(), [](const auto& move) {
        return move.second["X"] == 5 && move.second["Y"] == 6 && move.second["Z"] == 40;
    });
    ASSERT_NE(there, moves.end()) << program;
    ASSERT_GE(there - moves.begin(), 3);
    EXPECT_EQ((there - 2)->second["A"], 10) << "up, from where the line ended";
    EXPECT_EQ(there->second["C"], 20) << "the point names no rotary axis";
    EXPECT_EQ(moves.back().second, (there - 3)->second) << "the line ends where it did before";
}

TEST_F(MachinePoints, RejectsUnknownAndUnsupportedPoints) {
    const std::string data = write("d.txt", kRouterData);
    const auto of_router = [&](std::vector<std::string> options) {
        options.insert(options.end(), {"p.path.json", "--machine", kRouter});
        return rejected(options);
    };
    path(std::string(kStart) + R"({"fixed": "CLAMP7"})");
    EXPECT_EQ(of_router({"--machine-data", data}),
              "p.path.json:1:88: error: the fixed point 'CLAMP7' is not defined in d.txt; available: 1 "
              "(PARK), 7\n");
    EXPECT_EQ(of_router({}),
              "p.path.json:1:88: error: the position of the fixed point 'CLAMP7' is not defined; give the "
              "machine data with --machine-data\n");
    EXPECT_TRUE(contains(rejected({"p.path.json", "--machine-data", "none.txt"}, 2), "none.txt"));

    path(std::string(kStart) + R"({"reference": 3})");
    for (const std::string dialect : {"grbl", "rs274ngc"}) {
        EXPECT_EQ(of_router({"--dialect", dialect}),
                  "p.path.json:1:88: error: the post '" + dialect +
                      "' has no word for the reference point 3 ([reference_points] go); it has 1 to 2\n");
    }
    std::ifstream file(tests::source_path("samples/posts/fanuc.toml"));
    const std::string post{std::istreambuf_iterator<char>(file), {}};
    write("mine.toml", std::regex_replace(post, std::regex("\\[reference_points\\]\ngo.*\nend.*\n"), ""));
    EXPECT_TRUE(contains(of_router({"--dialect", "mine.toml"}),
                         "the post 'fanuc' has no words for reference points ([reference_points] go)"));
    write("mine.toml", std::regex_replace(post, std::regex("\nmachine = \"G53\"\n"), "\n"));
    path(std::string(kStart) + R"({"fixed": 7})");
    EXPECT_TRUE(contains(of_router({"--dialect", "mine.toml", "--machine-data", data}),
                         "the post 'fanuc' has no word for machine coordinates ([offsets] machine), which "
                         "are required to move to the fixed point 7"));
    write("e.txt", "NCFILE\nFIXED\n7 700 0 0\nENDFILE\n");
    EXPECT_TRUE(contains(of_router({"--machine-data", "e.txt"}), "out of reach: X 700 is outside 0 to 600"));
}

// Those of the machine data are named, as fixed points are; numbers are the controller's own.
TEST_F(MachinePoints, FindsReferencePointsByName) {
    const std::string data = write(
        "d.txt", "NCFILE\nFIXED\n1 1 1 -1 NAME=DOCK\nREFERENCE\n2 70 80 -25 NAME=Dock\n3 1 2 3\nENDFILE\n");
    path(std::string(kStart) + R"({"reference": "DOCK"})");
    for (const std::string dialect : {"ab9", "grbl"}) {
        const std::string program =
            written(dialect, {"p.path.json", "--machine", kRouter, "--machine-data", data});
        EXPECT_EQ(driven(program, dialect, {"--machine", kRouter, "--machine-data", data}).back().second,
                  at(70, 80, -25))
            << program;
    }
    path(std::string(kStart) + R"({"reference": "PIER"})");
    EXPECT_EQ(rejected({"p.path.json", "--machine", kRouter, "--machine-data", data}),
              "p.path.json:1:88: error: the reference point 'PIER' is not defined in d.txt; available: 2 "
              "(Dock), 3\n");
}

// Only the controller may know where a reference point lies.
TEST_F(MachinePoints, ReportsUndefinedReferencePoint) {
    path(std::string(kStart) + R"({"reference": 4})");
    const Ended ended = path2gcode({"p.path.json", "--machine", kRouter, "--dialect", "fanuc", "-o", "o.nc"});
    EXPECT_EQ(ended.status, 0);
    EXPECT_EQ(ended.err,
              "note: neither the machine file nor machine data define the positions of the reference points "
              "4; Z moves there first, as if it moved up\n");
    EXPECT_TRUE(contains(read("o.nc"), "G91 G30 P4 Z0.\nN50 G91 G30 P4 X0. Y0.\nN60 G90\n")) << read("o.nc");
}

TEST_F(MachinePoints, RejectsProcessOnAndMissingOrientation) {
    const std::string data =
        write("d.txt", "NCFILE\nFIXED\n1 100 50 300\n2 100 50 300 30\n3 100 50 300 30 40\nENDFILE\n");
    const std::string start = R"({"motion": "rapid", "position_mm": [10, 20, 30], "tool_axis": [0, 0, 1],
        "feed_mm_min": 100, "actions": ["waterjet_on"]},)";
    path(start + R"({"fixed": 1})");
    EXPECT_TRUE(contains(rejected({"p.path.json", "--machine-data", data}),
                         "the jet may be on during the move to the fixed point 1; turn it off before"));
    const std::string off = R"({"position_mm": [10, 30, 30], "actions": ["waterjet_off"]},)";
    path(start + off + R"({"fixed": 3}, {"motion": "rapid", "position_mm": [10, 20, 30]})");
    EXPECT_TRUE(
        contains(rejected({"p.path.json", "--machine-data", data}),
                 "the point needs an orientation: the fixed or reference point before it has turned the "
                 "rotary axes"));
    path(R"({"fixed": 2})");
    EXPECT_TRUE(
        contains(rejected({"p.path.json", "--machine-data", data}),
                 "the fixed point 2 defines the positions of only some rotary axes, and the others are "
                 "undefined"));
    path(start + off + R"({"fixed": 1}, {"position_mm": [10, 20, 30]})");
    EXPECT_TRUE(contains(rejected({"p.path.json", "--machine-data", data}),
                         "the first motion after a fixed or reference point must be a rapid"));
}

// A path may begin while the axes' orientation is not known yet; it is known from its first point on.
TEST_F(MachinePoints, PathCanBeginAtPoint) {
    const std::string data = write("d.txt", "NCFILE\nFIXED\n1 100 50 300\nENDFILE\n");
    path(R"({"fixed": 1}, {"path": "q"}, {"fixed": 1})", "",
         R"(, {"name": "q", "targets": [{"fixed": 1}, {"motion": "rapid", "position_mm": [10, 20, 30],
            "rotary_deg": {"B": 20, "C": 10}}, {"position_mm": [20, 20, 30], "feed_mm_min": 100}]})");
    const std::string program = written("rs274ngc", {"p.path.json", "--machine-data", data});
    const auto moves = driven(program, "rs274ngc", {"--machine-data", data});
    EXPECT_EQ(moves.back().second, at(100, 50, 300, 20, 10)) << program;
    EXPECT_EQ(moves[2].second, at(100, 50, 300, 0, 0)) << "as it stood";
}

TEST_F(MachinePoints, ScriptsCreatePoints) {
    write("d.txt", kRouterData);
    write("s.path.lua",
          "return path{name = 's', point{motion = 'rapid', position_mm = {10, 20, -30}}, point{fixed = "
          "'PARK'},\n"
          "  point{fixed = 7, name = 'beside', dwell_s = 1}, point{reference = 1, actions = {'stop'}}}\n");
    path(std::string(kStart) +
         R"({"fixed": "PARK"}, {"fixed": 7, "dwell_s": 1}, {"reference": 1, "actions": ["stop"]})");
    const auto body = [&](const std::string& file) {
        const std::string text = written("rs274ngc", {file, "--machine", kRouter, "--machine-data", "d.txt"});
        return text.substr(text.find('\n'));
    };
    EXPECT_EQ(body("s.path.lua"), body("p.path.json"));
    const auto error = [&](const std::string& point) {
        write("s.path.lua", "return path{name = 's', point" + point + "}\n");
        return rejected({"s.path.lua", "--machine", kRouter, "--machine-data", "d.txt"});
    };
    EXPECT_TRUE(contains(error("{fixed = 'PARK', motion = 'rapid'}"),
                         "a target with the key 'fixed' is a point of the machine, which is reached by a "
                         "rapid; it cannot have 'motion'"));
    EXPECT_TRUE(contains(error("{reference = 5}"), "'reference' must be an integer from 1 to 4; it is 5"));
    EXPECT_TRUE(contains(error("{fixed = {}}"), "'fixed' must be a name or a number"));
    EXPECT_TRUE(
        contains(error("{fixed = '2nd'}"), "'fixed' must be the number of a fixed point, or its name"));
}

}  // namespace
}  // namespace gsim::apps::machine_points_test
