// Work frames that a program finds by touches: written by each post, run in a cell with a body, and compared
// with the position of that body.
#include <fstream>
#include <regex>

#include "base/text/json.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::probe_offset_test {
namespace {

using nlohmann::json;

const std::string kRouter = tests::source_path("samples/machines/router3.toml");

/// A block with its lower left corner at X 300, Y 100 and its upper face at Z -70, and a ball of 6 mm. The
/// lowest point of the ball is the end of the tool.
const char* const kCell = R"(
[cell]
name = "a block"
[[object]]
name = "block"
role = "workpiece"
shape = { box_mm = [80.0, 60.0, 20.0] }
frame = { x_mm = 340.0, y_mm = 130.0, z_mm = -80.0 }
[[shape]]
name = "stylus"
on = "tool"
shape = { sphere_mm = 6.0 }
frame = { z_mm = 3.0 }
)";

const std::string kTouches = R"("probe_offset": [
    {"axis": "Z", "from_mm": [20, 20, 15], "to_mm": -10, "surface_mm": 0, "feed_mm_min": 120},
    {"axis": "X", "from_mm": [-15, 20, -10], "to_mm": 10, "surface_mm": 0, "feed_mm_min": 60, "probe_radius_mm": 3},
    {"axis": "Y", "from_mm": [20, 90, -10], "to_mm": 55, "surface_mm": 60, "feed_mm_min": 60, "probe_radius_mm": 3}])";

std::string path_with(const std::string& keys) {
    return R"({"paths": [{"name": "p", "work_offset": "G55", )" + keys + R"(, "targets": [
        {"motion": "rapid", "position_mm": [10, 20, 30]}, {"position_mm": [10, 20, 7], "feed_mm_min": 600},
        {"motion": "rapid", "position_mm": [10, 20, 30]}]}]})";
}

class ProbeOffset : public Apps {
  protected:
    Ended path2gcode(std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"--machine", kRouter});
        return run_program(tests::program_path("path2gcode"), arguments, folder_);
    }
    std::string written(const std::string& dialect, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> options = {"p.path.json", "--quiet", "--dialect", dialect};
        options.insert(options.end(), more.begin(), more.end());
        const Ended ended = path2gcode(options);
        EXPECT_EQ(ended.status, 0) << ended.err;
        return ended.out;
    }
    Ended run(const std::string& program, const std::string& dialect, std::vector<std::string> more) const {
        const std::string run_dialect = dialect == "fanuc" ? "ab9" : dialect == "grbl" ? "rs274ngc" : dialect;
        more.insert(more.end(), {write("x.nc", program), "--machine", kRouter, "--dialect", run_dialect,
                                 "--cell", write("cell.toml", kCell), "--json", "--moves", "m.jsonl"});
        return gsim_run(more);
    }
    /// X, Y and Z of G55 in a file of machine data.
    std::array<double, 3> frame(const std::string& data) const {
        std::array<double, 3> xyz{};
        for (std::size_t i = 0; i < 3; ++i) {
            const Ended got = gsim_data({data, "get", "OFFSET", "55", std::string(1, "XYZ"[i])});
            EXPECT_EQ(got.status, 0) << got.err;
            xyz[i] = std::stod(got.out);
        }
        return xyz;
    }
    /// Returns the target of the path's only move at feed.
    json cut() const {
        json found;
        std::istringstream lines(read("m.jsonl"));
        for (std::string line; std::getline(lines, line);) {
            const json move = text::parse_json<json>(line);
            if (move["kind"] == "linear") found = move["to"];
        }
        return found;
    }
};

// After the touches the frame is the body's, whatever the controller had for it or the program sets first.
TEST_F(ProbeOffset, FrameMatchesBodyPosition) {
    for (const std::string dialect : {"ab9", "fanuc", "rs274ngc"}) {
        for (const bool set : {false, true}) {
            for (const bool inch : {false, true}) {
                write("p.path.json",
                      path_with((set ? R"("set_offset_mm": [304, 97, -66], )" : "") + kTouches));
                write("d.txt", set ? "NCFILE\nOFFSET\n55 1 2 3\nENDFILE\n"
                                   : "NCFILE\nOFFSET\n55 304 97 -66\nENDFILE\n");
                const std::string program =
                    written(dialect, inch ? std::vector<std::string>{"--inch"} : std::vector<std::string>{});
                const Ended ran =
                    run(program, dialect, {"--machine-data", "d.txt", "--save-machine-data", "s.txt"});
                ASSERT_EQ(ran.status, 0) << ran.err << ran.out << program;
                const json report = text::parse_json<json>(ran.out);
                EXPECT_TRUE(report["collisions"].empty()) << report["collisions"];
                const double resolution_mm = inch ? 0.00254 : 2e-6;  // that of a contact
                const std::array<double, 3> expected_value{300, 100, -70}, got = frame("s.txt");
                for (std::size_t i = 0; i < 3; ++i)
                    EXPECT_NEAR(got[i], expected_value[i], resolution_mm) << "XYZ"[i] << program;
                EXPECT_NEAR(cut()["X"], 310, resolution_mm + 1e-3);
                EXPECT_NEAR(cut()["Y"], 120, resolution_mm + 1e-3);
                EXPECT_NEAR(cut()["Z"], -63, resolution_mm + 1e-3);
            }
        }
    }
}

// grbl has no words for the position of the contact: its frame is off by the braking distance, v^2 / 2a.
TEST_F(ProbeOffset, GrblFrameIsAtStandstillPosition) {
    write("p.path.json", path_with(R"("set_offset_mm": [304, 97, -66], )" + kTouches));
    const Ended ran = run(written("grbl"), "grbl", {"--save-machine-data", "s.txt"});
    ASSERT_EQ(ran.status, 0) << ran.err << ran.out;
    const std::array<double, 3> got = frame("s.txt");
    EXPECT_NEAR(got[0], 300 + 1.0 / (2 * 500), 2e-6);
    EXPECT_NEAR(got[1], 100 - 1.0 / (2 * 500), 2e-6);
    EXPECT_NEAR(got[2], -70 - 4.0 / (2 * 300), 2e-6);
}

TEST_F(ProbeOffset, EachPostWritesItsWords) {
    write("p.path.json", path_with(R"("set_offset_mm": [304, 97, -66], )" + kTouches));
    const std::string behind_z = "G53 G00 Z0\nG00 X-15 Y20\nG00 Z-10\n";
    EXPECT_TRUE(contains(
        written("rs274ngc"),
        "G10 L2 P2 X304 Y97 Z-66 R0\nG53 G00 Z0\nG55\nG00 X20 Y20\nG00 Z15\nG38.2 Z-10 F120\nG1 Z#5063\n"
        "G10 L20 P2 Z0\nG00 Z15\n" +
            behind_z + "G38.2 X10 F60\nG1 X#5061\nG10 L20 P2 X-3\nG00 X-15\n"))
        << written("rs274ngc");
    EXPECT_TRUE(
        contains(written("grbl"), "G38.2 Y55 F60\nG10 L20 P2 Y63\nG00 Y90\nG53 G00 Z0\nX10 Y20 Z30\n"))
        << written("grbl");
    EXPECT_TRUE(contains(
        written("fanuc"),
        "G31 Z-10. F120.\nN90 IF [ABS[#5063-[-10.]] LT 0.001] THEN #3000=1 (THE PROBE TOUCHED NOTHING)\n"
        "N100 G91 G10 L2 P2 Z[#5063-[0.]]\nN110 G90\nN120 G55\nN130 G00 Z15.\n"))
        << written("fanuc");
}

// The probe meets no body: each controller stops, and no frame is moved.
TEST_F(ProbeOffset, RaisesAlarmIfNothingIsTouched) {
    write("p.path.json",
          path_with(R"("probe_offset": [{"axis": "Z", "from_mm": [-50, 20, 15], "to_mm": -10, "surface_mm": 0,
                        "feed_mm_min": 120}])"));
    write("d.txt", "NCFILE\nOFFSET\n55 304 97 -66\nENDFILE\n");
    for (const auto& [dialect, message] :
         {std::pair<std::string, std::string>{"ab9", "THE PROBE TOUCHED NOTHING"},
          {"rs274ngc", "the probe has not made contact"},
          {"grbl", "the probe has not made contact"}}) {
        const Ended ran =
            run(written(dialect), dialect, {"--machine-data", "d.txt", "--save-machine-data", "s.txt"});
        EXPECT_EQ(ran.status, 1) << dialect;
        EXPECT_TRUE(contains(ran.out, message)) << ran.out;
        EXPECT_EQ(frame("s.txt"), (std::array<double, 3>{304, 97, -66}));
    }
}

// The tool that touches comes first, then that of the path; each with its length.
TEST_F(ProbeOffset, UsesSeparateProbeTool) {
    std::string touches = kTouches;
    touches = std::regex_replace(touches, std::regex("\"feed_mm_min\""), "\"tool\": 9, \"feed_mm_min\"");
    write("p.path.json", path_with(R"("set_offset_mm": [304, 97, -66], "tool": 3, )" + touches));
    const std::string program = written("rs274ngc");
    EXPECT_TRUE(contains(program, "R0\nG53 G00 Z0\nT9\nM6\nG43 H9\nG55\nG00 X20 Y20\n")) << program;
    EXPECT_TRUE(contains(program, "G00 Y90\nG53 G00 Z0\nT3\nM6\nG43 H3\nX10 Y20 Z30\n")) << program;
    EXPECT_EQ(program.find("T9"), program.rfind("T9")) << program;
    // In the model the lengths count, and the stylus is there with each tool: the frame is off by the
    // probe's.
    write("d.txt", "NCFILE\nTOOL\n3 11 6\n9 2 6\nENDFILE\n");
    for (const std::string dialect : {"rs274ngc", "ab9"}) {
        const Ended ran =
            run(written(dialect), dialect, {"--machine-data", "d.txt", "--save-machine-data", "s.txt"});
        ASSERT_EQ(ran.status, 0) << ran.err << ran.out << program;
        EXPECT_NEAR(frame("s.txt")[2], -70 - 2, 3e-6) << dialect;
        EXPECT_NEAR(cut()["Z"], -72 + 11 + 7, 3e-6) << dialect;
    }
}

// Once for each frame, in the order of the file, wherever the paths that are in them come.
TEST_F(ProbeOffset, MeasuresEachFrameOnceFirst) {
    const std::string touch =
        R"("probe_offset": [{"axis": "Z", "from_mm": [0, 0, 15], "to_mm": -9, "surface_mm": 1,
        "feed_mm_min": 120}])";
    const std::string use = R"({"path": "p", "work_offset": "G56", )" + touch + "}";
    write("p.path.json", R"({"root": "job", "paths": [{"name": "job", "work_offset": "G54", "targets": [)" +
                             use + R"(, {"path": "p", "work_offset": "G55", )" + touch + "}, " + use + R"(]},
        {"name": "p", "targets": [{"motion": "rapid", "position_mm": [1, 2, 3]}]}]})");
    const std::string program = written("grbl");
    std::string order;
    const std::regex word("G38.2|G5[4-9]");
    for (std::sregex_iterator each(program.begin(), program.end(), word), end; each != end; ++each)
        order += each->str() == "G53" ? "" : each->str() + " ";
    EXPECT_EQ(order, "G54 G56 G38.2 G55 G38.2 G56 G55 G56 G54 ") << program;
}

TEST_F(ProbeOffset, RejectsImpossibleTouches) {
    const auto rejected = [this](const std::string& keys, const std::vector<std::string>& more = {}) {
        write("p.path.json", path_with(keys));
        std::vector<std::string> options = {"p.path.json"};
        options.insert(options.end(), more.begin(), more.end());
        const Ended ended = path2gcode(options);
        EXPECT_EQ(ended.status, 1) << ended.out;
        return ended.err;
    };
    std::ifstream file(tests::source_path("samples/posts/grbl.toml"));
    const std::string post{std::istreambuf_iterator<char>(file), {}};
    write("mine.toml", std::regex_replace(post, std::regex("\\[probe\\]\ntouch.*\n"), ""));
    EXPECT_TRUE(contains(rejected(kTouches, {"--dialect", "mine.toml"}),
                         "the post 'grbl' has no words to measure a work offset by touches ([probe] touch)"));
    EXPECT_TRUE(contains(rejected(R"("set_offset_mm": [304, 97, 0], )" + kTouches),
                         "p.path.json:1:12: error: out of reach: Z 15 is outside -120 to 0"));
    std::string with_tool = kTouches;
    with_tool.replace(with_tool.find("\"axis\""), 0, "\"tool\": 9, ");
    EXPECT_TRUE(contains(rejected(with_tool),
                         "a touch has a tool, so the first path of the program must have a tool, too"));
    EXPECT_TRUE(
        contains(rejected(with_tool + R"(, "tool": 3)", {"--dialect", "grbl"}),
                 "the post 'grbl' has no words for 'tool_change T3', 'tool_change T9', 'tool_length H3', "
                 "'tool_length H9'"));
}

}  // namespace
}  // namespace gsim::apps::probe_offset_test
