// Round trip by the programs: the path that gsim-run records, path2gcode writes and gsim-run runs again has
// the same moves. Output of path2gcode comes back as it was.

#include <cmath>
#include <random>
#include <sstream>

#include <fmt/format.h>

#include "base/text/json.h"
#include "tests/apps/canon_ends.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"
#include "tests/toolpath/random_path.h"
#include "toolpath/json/json_writer.h"

namespace gsim::record::round_trip_test {
namespace {

using apps::contains;
using apps::Ended;
using nlohmann::json;

constexpr double kHalfDigit = 0.00051;  // of the third decimal

/// Post for writing programs, and the dialect that reads them.
struct Way {
    std::string post;
    std::string dialect;
};

class RecordRoundTrip : public apps::Apps {
  protected:
    Ended path2gcode(std::vector<std::string> arguments, const std::string& input = {}) const {
        arguments.emplace_back("--quiet");
        return apps::run_program(tests::program_path("path2gcode"), arguments, folder_, input);
    }
    std::vector<json> moves(const std::string& name) const {
        std::istringstream text(read(name));
        std::vector<json> moves;
        for (std::string line; std::getline(text, line);) {
            json move = text::parse_json<json>(line);
            const bool is_rest = move["kind"] == "dwell" && move["start_s"] == move["end_s"];
            if (!is_rest) moves.push_back(std::move(move));
        }
        return moves;
    }
    // A program's lines without numbers, comments, which hold names, and what is said of offsets.
    static std::vector<std::string> words(const std::string& program) {
        std::vector<std::string> lines;
        std::istringstream text(program);
        for (std::string line; std::getline(text, line);) {
            if (const auto comment = line.find('('); comment != std::string::npos) line.resize(comment);
            if (line.starts_with('N')) line.erase(0, line.find(' ') + 1);
            if (!line.starts_with("G92") && !line.empty()) lines.push_back(line);
        }
        return lines;
    }
    void expect_same_moves(const std::string& first, const std::string& second, double tolerance) const {
        const std::vector<json> expected = moves(first);
        const std::vector<json> found = moves(second);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            ASSERT_EQ(found[i]["kind"], expected[i]["kind"]) << i;
            for (const auto& [letter, value] : expected[i]["to"].items()) {
                if (!found[i]["to"].contains(letter)) continue;
                ASSERT_NEAR(found[i]["to"][letter].get<double>(), value.get<double>(), tolerance)
                    << i << letter << expected[i];
            }
            if (!expected[i]["feed"].is_null()) {
                EXPECT_NEAR(found[i]["feed"].get<double>(), expected[i]["feed"].get<double>(), 0.001);
            }
        }
    }
    // The built-in machine's axes without the ends of their ranges.
    std::string wide_machine() const {
        // The chain's first Z along the world's X, and each row of 90 and 90 turns it to the next one.
        std::string text =
            "[machine]\nname = \"wide\"\n[path]\nmax_rapid_mm_s = 1000\n"
            "[base]\nroll_deg = 90\nyaw_deg = 90\n";
        for (const char letter : {'X', 'Y', 'Z'}) {
            text += fmt::format(
                "[[axis]]\nletter = \"{}\"\nkind = \"linear\"\ndh = {{ theta_deg = 90, alpha_deg = 90 }}\n",
                letter);
        }
        for (const char letter : {'B', 'C'}) {
            text += fmt::format(
                "[[axis]]\nletter = \"{}\"\nkind = \"rotary\"\nmax_speed_deg_s = 90\ndh = {{}}\n", letter);
        }
        return write("wide.toml", text);
    }
    // Runs, records, writes by each post, runs again.
    void expect_way_round(const std::string& part, const std::string& dialect, const std::vector<Way>& ways,
                          const std::string& machine = tests::source_path("samples/machines/af5.toml")) {
        const Ended first = gsim_run({part, "--dialect", dialect, "--machine", machine, "--quiet", "--moves",
                                      "first.jsonl", "--record", "first.path.json"});
        ASSERT_EQ(first.status, 0) << first.err;
        for (const Way& write_mode : ways) {
            const Ended written = path2gcode({"first.path.json", "--machine", machine, "--rotary", "as-given",
                                              "--dialect", write_mode.post, "-o", "again.nc"});
            ASSERT_EQ(written.status, 0) << written.err;
            const Ended repeated = gsim_run({"again.nc", "--dialect", write_mode.dialect, "--machine",
                                             machine, "--quiet", "--moves", "again.jsonl"});
            ASSERT_EQ(repeated.status, 0) << write_mode.post << repeated.err;
            SCOPED_TRACE(write_mode.post);
            expect_same_moves("first.jsonl", "again.jsonl", kHalfDigit);
        }
    }
};

const std::vector<Way> kAllAxes{{"rs274ngc", "rs274ngc"}, {"ab9", "ab9"}, {"fanuc", "ab9"}};

/// Programs of the 9/Series with loops, subprograms, offsets, arcs in all planes, turning axes and dwells.
class RandomPart {
  public:
    explicit RandomPart(unsigned seed) : random_(seed) {}

    std::string text() {
        std::string text = "O1\nG21 G90 G94 F1500\nG0 X300 Y300 Z80\n";
        for (int i = 0; i < 12; ++i) text += block();
        text += "G52 X10 Y-5\n#1=0\nWHILE [#1 LT 3] DO 1\nG90 G0 X[250+10*#1] Y320\nM98 P2\n" + block() +
                "#1=[#1+1]\nEND 1\nG52 X0 Y0\nM98 P3 L2\nG90 G0 X300 Y300 Z80\nM98 P3\nG17 G90\nM30\n%\n";
        text += "O2\nM8\nG91\n" + increments() + "M9\nG90\nM99\n%\n";
        return text + "O3\nG90 G17 G0 X310 Y300 Z70\nM8\nG1 X320 F1234.5\n" + arc() + "G4 P0.2\nM9\nM99\n";
    }

  private:
    double number(double low, double high) {
        return std::round(std::uniform_real_distribution<double>(low, high)(random_) * 1000) / 1000;
    }
    std::string increments() {
        return fmt::format("G1 X{:.3f} Y{:.3f} F2000\nX{:.3f} Z{:.3f}\n", number(-9, 9), number(-9, 9),
                           number(-9, 9), number(-9, 9));
    }
    std::string arc() {
        const double x = number(5, 30);
        const double y = number(5, 30);
        static constexpr std::array<const char*, 3> kPlanes{"G17 G{} I{:.3f} J{:.3f} X{:.3f}\n",
                                                            "G18 G{} I{:.3f} K{:.3f} X{:.3f}\n",
                                                            "G19 G{} J{:.3f} K{:.3f} Y{:.3f}\n"};
        const char* form = kPlanes[random_() % 3];
        // The height is the same again after twice the distance to the centre.
        return "G91\n" +
               fmt::format(fmt::runtime(form), 2 + random_() % 2, x, random_() % 2 == 0 ? y : -y, 2 * x) +
               "G90 G17\n";
    }
    std::string block() {
        switch (random_() % 6) {
            case 0: return arc();
            case 1: return fmt::format("G4 P{:.2f}\n", number(0.1, 0.9));
            case 2: return fmt::format("G0 X{:.3f} Z{:.3f}\n", number(200, 400), number(60, 90));
            case 3:
                return fmt::format("G1 Y{:.3f} B{:.3f} C{:.3f} F{:.1f}\n", number(200, 400), number(-90, 90),
                                   number(-80, 80), number(500, 5000));
            case 4: return fmt::format("G1 B{:.3f} F{:.1f}\n", number(-90, 90), number(500, 5000));
            default:
                return fmt::format("G1 X{:.3f} Y{:.3f} F{:.1f}\n", number(200, 400), number(200, 400),
                                   number(500, 5000));
        }
    }

    std::mt19937 random_;
};

// Arcs through a point, and arcs in planes that a rotation turns, G68 of the 9/Series.
std::string oblique_part(std::mt19937& random) {
    const auto number = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    std::string text = "G21 G90 F1500\nG0 X400 Y400 Z100\n";
    for (int i = 0; i < 20; ++i) {
        if (random() % 2 == 0) {
            text +=
                fmt::format("G91 CIP X{:.3f} Y{:.3f} Z{:.3f} I1={:.3f} J1={:.3f} K1={:.3f}\n", number(10, 30),
                            number(-10, 10), number(-4, 4), number(0, 9), number(11, 30), number(-20, 20));
        } else {
            const double i_mm = number(5, 20), j_mm = number(-20, 20);
            text += fmt::format("G90 G{} G68 R{:.2f}\n", 18 + random() % 2, number(5, 85));
            text += fmt::format("G91 G17 G{} I{:.3f} J{:.3f} X{:.3f}\nG69\n", 2 + random() % 2, i_mm, j_mm,
                                2 * i_mm);
        }
        text += "G90 G1 X400 Y400 Z100\n";
    }
    return text + "M30\n";
}

TEST_F(RecordRoundTrip, ObliqueArcReturnsAsOneBlock) {
    std::mt19937 random(5);
    const std::string machine = wide_machine();
    for (int round = 0; round < 4; ++round) {
        const std::string text = oblique_part(random);
        expect_way_round(write("part.nc", text), "ab9", {{"ab9", "ab9"}}, machine);
        const std::vector<json> first = moves("first.jsonl"), repeated = moves("again.jsonl");
        int oblique = 0;
        for (std::size_t i = 0; i < first.size() && i < repeated.size(); ++i) {
            if (!first[i].contains("normal") || !first[i]["plane"].is_null()) continue;
            ++oblique;
            for (const char* letter : {"X", "Y", "Z"}) {
                EXPECT_NEAR(first[i]["center"][letter].get<double>(),
                            repeated[i]["center"][letter].get<double>(), 0.02)
                    << first[i] << repeated[i];
                EXPECT_NEAR(first[i]["normal"][letter].get<double>(),
                            repeated[i]["normal"][letter].get<double>(), 1e-3)
                    << first[i] << repeated[i];
            }
        }
        EXPECT_EQ(oblique, 20) << text;
        ASSERT_FALSE(HasFailure()) << text;
    }
}

TEST_F(RecordRoundTrip, PostSplitsRejectsOrWritesObliqueArc) {
    const std::string machine = wide_machine();
    const std::string part = write("part.nc", "F1000 G0 X100\nCIP X120 I1=110 J1=8 K1=6\nM30\n");
    ASSERT_EQ(gsim_run({part, "--machine", machine, "--quiet", "--record", "part.path.json"}).status, 0);
    const auto post = [&](const std::string& arcs) {
        std::string text = read(tests::source_path("samples/posts/rs274ngc.toml"));
        return write("own.toml", text.insert(text.find("turns ="), arcs));
    };
    const std::vector<std::string> common{"part.path.json", "--machine", machine, "--dialect"};
    const auto written = [&](const std::string& arcs) {
        std::vector<std::string> arguments = common;
        arguments.push_back(post(arcs));
        return path2gcode(arguments);
    };
    const Ended lines = written("");
    EXPECT_EQ(lines.status, 0) << lines.err;
    EXPECT_TRUE(contains(lines.out, "(an arc outside the planes of the axes as lines within 0.01 mm)"))
        << lines.out;
    const Ended rejected = written("oblique = \"refuse\"\n");
    EXPECT_EQ(rejected.status, 1);
    EXPECT_TRUE(contains(
        rejected.err,
        "this arc is outside the planes of X, Y and Z, and the post rejects such arcs ([arcs], oblique)"))
        << rejected.err;
    const Ended through = written("through_point = [\"G2.4\", \"I\", \"J\", \"K\"]\n");
    EXPECT_TRUE(contains(through.out, "G2.4 X120 I110 J8 K6 F1000\n")) << through.out;
}

TEST_F(RecordRoundTrip, RandomProgramsMoveEquallyInEachDialect) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE(seed);
        const std::string text = RandomPart(seed).text();
        expect_way_round(write("part.nc", text), "ab9", kAllAxes);
        ASSERT_FALSE(HasFailure()) << text;
    }
}

TEST_F(RecordRoundTrip, LinuxCncReachesSamePositions) {
    if (!apps::has_rs274()) GTEST_SKIP() << "LinuxCNC's rs274 is not installed";
    for (unsigned seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE(seed);
        const std::string text = RandomPart(seed).text();
        expect_way_round(write("part.nc", text), "ab9", {{"rs274ngc", "rs274ngc"}});
        const Ended canon = apps::run_rs274(folder_, "again.nc");
        ASSERT_EQ(canon.status, 0) << canon.err.substr(0, 2000);
        const apps::Ends ends = apps::ends_of_canon(canon.out);
        const apps::Ends first = apps::ends_of_moves(read("first.jsonl"));
        ASSERT_EQ(ends.size(), first.size()) << text;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            for (std::size_t k = 0; k < 5; ++k)
                ASSERT_NEAR(ends[i][k], first[i][k], 0.0001) << i << "XYZBC"[k];
        }
    }
}

// Steps shorter than the printed digits, lines and arcs: some vanish, and the others stay at their positions.
TEST_F(RecordRoundTrip, ErrorsOfShortMovesDoNotAccumulate) {
    const std::string part =
        write("part.nc",
              "G21 G91 F600\nG0 X300.0002 Y300 Z80\n#1=0\nWHILE [#1 LT 300] DO 1\nG1 X.0003 Y-.0002\n"
              "G2 X.0004 Y.0003 I.1502 J-.1998\nG3 X1.0003 I.50015\nG1 X-1\n#1=[#1+1]\nEND 1\nM30\n");
    const Ended first = gsim_run(
        {part, "--dialect", "ab9", "--quiet", "--moves", "first.jsonl", "--record", "first.path.json"});
    ASSERT_EQ(first.status, 0) << first.err;
    const apps::Ends expected_value = apps::ends_of_moves(read("first.jsonl"));
    for (const Way& write_mode : kAllAxes) {
        SCOPED_TRACE(write_mode.post);
        ASSERT_EQ(path2gcode({"first.path.json", "--dialect", write_mode.post, "-o", "again.nc"}).status, 0);
        const Ended repeated =
            gsim_run({"again.nc", "--dialect", write_mode.dialect, "--quiet", "--moves", "again.jsonl"});
        ASSERT_EQ(repeated.status, 0) << repeated.err;
        const apps::Ends found = apps::ends_of_moves(read("again.jsonl"));
        EXPECT_LE(found.size(), expected_value.size());
        const auto near = [](const std::array<double, 5>& a, const std::array<double, 5>& b) {
            return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) < std::sqrt(2) * kHalfDigit;
        };
        std::size_t at = 0;
        for (const auto& end : expected_value) {
            if (at + 1 < found.size() && near(found[at + 1], end)) ++at;
            ASSERT_TRUE(near(found[at], end)) << at;
        }
        EXPECT_EQ(at, found.size() - 1);
    }
}

TEST_F(RecordRoundTrip, ThreeAxisProgramReturnsThroughGrbl) {
    const std::string part =
        write("part.ngc",
              "G21\nG0 X10 Y10 Z-5\no100 sub\nG1 Z[#1-9] F300\nG2 X10 Y10 I5 J0\nG0 Z-5\n"
              "o100 endsub\no100 call [1]\no100 call [2]\no100 call [2]\nM2\n");
    expect_way_round(part, "rs274ngc", {{"grbl", "rs274ngc"}, {"rs274ngc", "rs274ngc"}},
                     tests::source_path("samples/machines/router3.toml"));
    const json program = text::parse_json<json>(read("first.path.json"));
    ASSERT_EQ(program["paths"].size(), 3U) << "two that differ, and the root";
    EXPECT_EQ(program["paths"][2]["targets"].back()["repeats"], 2);
}

// A path that has been written once: written again from the record, the same blocks come out.
TEST_F(RecordRoundTrip, RandomPathsReturnUnchanged) {
    const std::string machine = wide_machine();
    std::mt19937 random(3);
    for (int round = 0; round < 4; ++round) {
        const path::Program program =
            path::random_program(random, {.tilted_arcs = false, .extras = false, .sub_paths = round % 4});
        write("random.path.json", path::to_json(program));
        for (const Way& write_mode : kAllAxes) {
            SCOPED_TRACE(write_mode.post);
            // Numbers of the machine, as in a path that no run has recorded.
            const auto write_by_post = [&](const std::string& path) {
                std::vector<std::string> arguments{path,       "--machine", machine,         "--rotary",
                                                   "as-given", "--dialect", write_mode.post, "-o",
                                                   "random.nc"};
                if (path == "again.path.json") arguments.insert(arguments.end(), {"--offsets", "none"});
                const Ended e = path2gcode(arguments);
                ASSERT_EQ(e.status, 0) << e.err;
            };
            const auto run = [&](const std::string& moves, const std::string& path) {
                const Ended e = gsim_run({"random.nc", "--dialect", write_mode.dialect, "--machine", machine,
                                          "--quiet", "--moves", moves, "--record", path});
                ASSERT_EQ(e.status, 0) << e.err;
            };
            write_by_post("random.path.json");
            const std::string text = read("random.nc");
            run("first.jsonl", "again.path.json");
            write_by_post("again.path.json");
            run("again.jsonl", "last.path.json");
            EXPECT_EQ(words(read("random.nc")), words(text));
            ASSERT_FALSE(HasFailure());
            expect_same_moves("first.jsonl", "again.jsonl", kHalfDigit);
        }
    }
}

// They are recorded as many short paths of the TCP; when written again, each line of the axes is one block.
TEST_F(RecordRoundTrip, RotaryLinesReturnIfTcpIsOffAxes) {
    const std::string part =
        write("part.ngc",
              "G21 G90 G0 X1000 Y1000 Z600 C0 A0\nG1 X1100 Y1020 C60 A30 F2000\nX1150 C10\n"
              "M8\nC80 F1500\nG1 A-20 C-40\nG93 G1 X1100 C20 F30\nG94 G1 X1000 F1000\nM2\n");
    expect_way_round(part, "rs274ngc", {{"rs274ngc", "rs274ngc"}, {"ab9", "ab9"}},
                     tests::source_path("samples/machines/gantry-offset-head.toml"));
    const json program = text::parse_json<json>(read("first.path.json"));
    EXPECT_GT(program["paths"][0]["targets"].size(), 200U);
}

TEST_F(RecordRoundTrip, StandardOutputHasOnlyPath) {
    const std::string part = write("part.nc", "G1 X10 F600\nM2\n");
    const Ended e = gsim_run({part, "--record", "-"});
    EXPECT_EQ(e.status, 0);
    EXPECT_EQ(text::parse_json<json>(e.out)["paths"][0]["targets"].size(), 2U)
        << "where it stands, and the move";
    EXPECT_TRUE(contains(e.err, "part.nc")) << "the report goes to standard error";
    const Ended written = path2gcode({"--dialect", "rs274ngc", "-"}, e.out);
    EXPECT_EQ(written.status, 0) << written.err;
    EXPECT_TRUE(contains(written.out, "\nG01 X10 F600\n")) << written.out;
    EXPECT_EQ(gsim_run({part, "--record", "-", "--json"}).status, 2);
}

TEST_F(RecordRoundTrip, WritesPathUpToAlarm) {
    const std::string bad = write("bad.nc", "G0 X100\nM98 P2\nM30\n%\nO2\nG0 X200\nX9999\nM99\n");
    EXPECT_EQ(gsim_run({bad, "--quiet", "--stop-at-first", "--record", "bad.path.json"}).status, 1);
    const json program = text::parse_json<json>(read("bad.path.json"));
    EXPECT_EQ(program["paths"][0]["name"], "O2");
    EXPECT_EQ(program["paths"][0]["targets"].size(), 1U);
}

TEST_F(RecordRoundTrip, WritesNoFileWithoutPath) {
    write("old.path.json", "old");
    const Ended e = gsim_run({write("empty.nc", "M2\n"), "--quiet", "--record", "old.path.json"});
    EXPECT_EQ(e.status, 1);
    EXPECT_TRUE(contains(e.err, "no path is recorded")) << e.err;
    EXPECT_EQ(read("old.path.json"), "old");
    EXPECT_EQ(gsim_run({write("part.nc", "G0 X1\n"), "--record", "none/a.path.json"}).status, 2);
}

TEST_F(RecordRoundTrip, WheelSampleReturnsWithinTolerance) {
    expect_way_round(tests::source_path("samples/wheel.nc"), "ab9", kAllAxes);
    EXPECT_EQ(text::parse_json<json>(read("first.path.json"))["paths"].size(), 4U);
}

}  // namespace
}  // namespace gsim::record::round_trip_test
