// The files that gsim-run writes: moves, trajectory, report and plot.

#include <cctype>
#include <cmath>
#include <regex>
#include <sstream>

#include <fmt/format.h>

#include "base/text/json.h"
#include "tests/apps/output_options.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::outputs_test {
namespace {

using nlohmann::json;

class Outputs : public Apps {
  protected:
    std::vector<std::string> lines(const std::string& name) {
        std::istringstream text(read(name));
        std::vector<std::string> lines;
        for (std::string line; std::getline(text, line);) lines.push_back(line);
        return lines;
    }
    const std::string part_ = write("part.nc", "G0 X100 Y100\nG1 X110 F3000\n\nG3 X100 Y110 I-10\nG4 P2\n");
};

TEST_F(Outputs, MovesHaveSourceLinesAndTimes) {
    EXPECT_EQ(gsim_run({part_, "--quiet", "--moves", "moves.jsonl"}).status, 0);
    const std::vector<std::string> moves = lines("moves.jsonl");
    ASSERT_EQ(moves.size(), 4U);
    double end_s = 0;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const json move = text::parse_json<json>(moves[i]);
        EXPECT_EQ(move["n"], i + 1);
        EXPECT_EQ(move["file"], "part.nc");
        EXPECT_NEAR(move["start_s"].get<double>(), end_s, 1e-9);
        end_s = move["end_s"];
    }
    const json arc = text::parse_json<json>(moves[2]);
    EXPECT_EQ(arc["kind"], "arc_ccw");
    EXPECT_EQ(arc["line"], 4);
    EXPECT_EQ(arc["plane"], "xy");
    EXPECT_EQ(arc["turns"], 1);
    EXPECT_EQ(arc["feed"], 3000);
    EXPECT_NEAR(arc["center"]["X"].get<double>(), 100, 1e-9);
    EXPECT_NEAR(arc["to"]["Y"].get<double>(), 110, 1e-9);
    EXPECT_TRUE(text::parse_json<json>(moves[0])["feed"].is_null());
    EXPECT_EQ(text::parse_json<json>(moves[1])["limited_by"], "feed");
    EXPECT_EQ(text::parse_json<json>(moves[3])["kind"], "dwell");
    EXPECT_TRUE(text::parse_json<json>(moves[3])["limited_by"].is_null());
}

// The run would end at an alarm in line 1: it does not begin.
TEST_F(Outputs, RejectInvalidNamesBeforeRun) {
    const std::string alarms = write("alarms.nc", "#3000=1 (NOT RUN)\n");
    std::vector<std::string> options = output_options();
    options.insert(options.end(), {"--save-machine-data", "--variables"});
    for (const std::string& option : options) {
        const Ended ended = gsim_run({alarms, "--quiet", option, "no/such/file"});
        EXPECT_EQ(ended.status, 2) << option;
        EXPECT_EQ(ended.err, "gsim-run: cannot write 'no/such/file': No such file or directory\n") << option;
    }
    EXPECT_EQ(gsim_run({alarms, "--quiet", "--plot", "no/such/p.svg"}).err,
              "gsim-run: cannot write 'no/such/p.svg': No such file or directory\n");
    EXPECT_EQ(gsim_run({alarms, "--quiet", "--plot", "p.pdf"}).err,
              "gsim-run: cannot draw 'p.pdf': the name of a picture must end in .svg or .png\n");
    EXPECT_TRUE(contains(gsim_run({alarms, "--quiet", "--plot", "p.svg", "--plot-plane", "xz"}).err,
                         "xz not in {xy,zx,yz}"));
}

TEST_F(Outputs, HaveNoNegativeZero) {
    const std::string part =
        write("zero.nc",
              "G21 G90 F1000\nG0 X100 Y100\nG3 X100 Y100 I-10\nG19 G68 Y0 Z0 R-90\nG0 X-0. Y-0. Z0\nPOPEN\n"
              "#1=-0.0\nDPRNT[Z#1[53]]\nPCLOS\nM30\n");
    const std::string machine = tests::source_path("samples/machines/unlimited.toml");
    std::vector<std::string> command = {part, "--machine", machine};
    for (const std::string& option : output_options())
        command.insert(command.end(), {option, file_of_option(option)});
    const Ended run = gsim_run(command);
    ASSERT_EQ(run.status, 0) << run.err;
    const Ended check =
        gsim_run({"--check-machine", tests::source_path("samples/machines/mill-head-table.toml")});
    const Ended lua = run_program(tests::program_path("gcode2lua"), {part}, folder_);
    std::vector<std::string> texts = {run.out, check.out, lua.out};
    for (const std::string& option : output_options()) texts.push_back(read(file_of_option(option)));
    for (const std::string& text : texts) {
        EXPECT_FALSE(text.empty());
        static const std::regex zero(R"((^|[^0-9eE.])-0+(\.0*)?([^0-9.]|$))");
        std::smatch found;
        EXPECT_FALSE(std::regex_search(text, found, zero))
            << found.prefix().str().substr(
                   found.prefix().length() > 60 ? static_cast<std::size_t>(found.prefix().length()) - 60 : 0)
            << found.str();
    }
}

TEST_F(Outputs, GoToStandardOutput) {
    for (const std::string& option : document_options()) {
        const Ended ended = gsim_run({part_, option, "-"});
        ASSERT_EQ(ended.status, 0) << ended.err;
        EXPECT_TRUE(contains(ended.err, "cycle time")) << "the report for people makes way: " << ended.err;
        EXPECT_EQ(gsim_run({part_, "--quiet", option, "file"}).status, 0);
        EXPECT_EQ(ended.out, read("file"));
    }
    const Ended report = gsim_run({part_, "--quiet", "--report", "-"});
    EXPECT_EQ(text::parse_json<json>(report.out)["status"], "completed");
    EXPECT_FALSE(exists("-"));
}

TEST_F(Outputs, RejectSharedStandardOutput) {
    const Ended two = gsim_run({part_, "--moves", "-", "--trajectory", "-"});
    EXPECT_EQ(two.status, 2);
    EXPECT_TRUE(contains(two.err, "--moves - and --trajectory - both use standard output")) << two.err;
    const Ended as_json = gsim_run({part_, "--json", "--moves", "-"});
    EXPECT_EQ(as_json.status, 2);
    EXPECT_TRUE(contains(as_json.out, "both use standard output")) << as_json.out;
    const Ended plot = gsim_run({part_, "--plot", "-"});
    EXPECT_EQ(plot.status, 2);
    EXPECT_TRUE(contains(plot.err, "--plot requires a file name")) << plot.err;
}

TEST_F(Outputs, ReportDeviationOfRoundedCorners) {
    std::string machine = "[machine]\nname = \"blends\"\n[controller]\nmodel = \"blend\"\n";
    for (const char letter : {'X', 'Y', 'Z'}) {
        machine += fmt::format(
            "[[axis]]\nletter = \"{}\"\nkind = \"linear\"\nmax_speed_mm_s = 500\n"
            "max_acceleration_mm_s2 = 2000\nmax_jerk_mm_s3 = 1e5\ndirection = \"{}\"\n",
            letter, static_cast<char>(std::tolower(letter)));
    }
    const std::string file = write("blends.toml", machine);
    const std::string square =
        write("square.ngc", "G21 G64 P0.05 F1000\nG1 X20\nY20\nX0\nY0\nG61.1\nX5\nM2\n");
    EXPECT_EQ(gsim_run({square, "--dialect", "rs274ngc", "--machine", file, "--quiet", "--moves",
                        "moves.jsonl", "--report", "report.json"})
                  .status,
              0);
    const json report = text::parse_json<json>(read("report.json"));
    EXPECT_EQ(report["blends"]["count"], 4);
    EXPECT_NEAR(report["blends"]["max_deviation_mm"].get<double>(), 0.05, 1e-9);
    const std::vector<std::string> moves = lines("moves.jsonl");
    ASSERT_EQ(moves.size(), 5U);
    EXPECT_FALSE(text::parse_json<json>(moves[0]).contains("deviation_mm"));
    const json second = text::parse_json<json>(moves[1]);
    const double deviation_mm = second["deviation_mm"];
    const json corner = text::parse_json<json>(moves[0])["to"];
    EXPECT_NEAR(std::hypot(corner["X"].get<double>() - 20, corner["Y"].get<double>()), deviation_mm, 1e-8);
    EXPECT_GT(report["time"]["dwell_s"], 0.05) << "the last stop is exact and waits for the axes";
}

TEST_F(Outputs, TrajectoryHasRisingTimesAndEndPosition) {
    EXPECT_EQ(gsim_run({part_, "--quiet", "--trajectory", "path.csv", "--step", "0.5"}).status, 0);
    const std::vector<std::string> rows = lines("path.csv");
    ASSERT_GT(rows.size(), 6U);
    EXPECT_EQ(rows[0], "t_s,line,x_mm,y_mm,z_mm,b_deg,c_deg,speed_mm_s");
    EXPECT_TRUE(rows[1].starts_with("0,")) << rows[1];
    EXPECT_TRUE(contains(rows.back(), ",100,110,0,0,0,0")) << rows.back();
    double before = -1;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double t_s = std::stod(rows[i]);
        EXPECT_GT(t_s, before);
        before = t_s;
    }
}

TEST_F(Outputs, ReportFileMatchesJsonOnStandardOutput) {
    const Ended e = gsim_run({part_, "--json", "--report", "report.json"});
    EXPECT_EQ(e.status, 0);
    EXPECT_EQ(text::parse_json<json>(read("report.json")), text::parse_json<json>(e.out));
}

TEST_F(Outputs, ReportFileHasExplanation) {
    EXPECT_EQ(gsim_run({part_, "--quiet", "--explain", "--report", "report.json"}).status, 0);
    EXPECT_TRUE(text::parse_json<json>(read("report.json")).contains("lower_bound_s"));
}

TEST_F(Outputs, PlotIsSvgAndRejectsUnknownFormat) {
    const Ended e = gsim_run({part_, "--quiet", "--plot", "path.svg"});
    if (e.status != 0 && contains(e.err, "gnuplot")) GTEST_SKIP() << e.err;
    EXPECT_EQ(e.status, 0) << e.err;
    EXPECT_TRUE(contains(read("path.svg"), "<svg"));
    EXPECT_EQ(files(), 2U);
    const Ended wrong = gsim_run({part_, "--quiet", "--plot", "path.xyz"});
    EXPECT_EQ(wrong.status, 2);
    EXPECT_TRUE(contains(wrong.err, ".svg")) << wrong.err;
}

TEST_F(Outputs, AreWrittenUpToAlarm) {
    const std::string bad = write("bad.nc", "G0 X100\nG0 X9999\n");
    EXPECT_EQ(
        gsim_run({bad, "--stop-at-first", "--quiet", "--moves", "moves.jsonl", "--report", "report.json"})
            .status,
        1);
    EXPECT_EQ(lines("moves.jsonl").size(), 1U);
    EXPECT_EQ(text::parse_json<json>(read("report.json"))["status"], "alarm");
}

TEST_F(Outputs, KeepOldFilesIfNothingRan) {
    write("moves.jsonl", "old");
    EXPECT_EQ(gsim_run({write("bad.nc", "G999\n"), "--quiet", "--moves", "moves.jsonl"}).status, 1);
    EXPECT_EQ(read("moves.jsonl"), "old");
}

}  // namespace
}  // namespace gsim::apps::outputs_test
