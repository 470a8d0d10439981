// Drawing of a run (--dxf), read back by the drawing reader and compared with the moves of the run.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/text/json.h"
#include "cam/drawing/dxf_reader.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::dxf_output_test {
namespace {

using drawing::Drawing;
using Eigen::Vector3d;
using geometry::Point;
using Line = std::vector<Vector3d>;
using nlohmann::json;

constexpr double kSamePoint_mm = 1e-9;
const std::string kMill = tests::source_path("samples/machines/unlimited.toml");

class DxfOutput : public Apps {
  protected:
    /// Runs a program; its drawing is p.dxf, its moves are m.jsonl.
    Ended draw(const std::string& gcode, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{
            write("part.nc", gcode), "--machine", kMill, "--quiet", "--dxf", "p.dxf", "--moves", "m.jsonl"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return gsim_run(arguments);
    }
    Drawing on(const std::vector<std::string>& layers) const {
        auto drawing = drawing::read_dxf(read("p.dxf"), {.layers = layers});
        EXPECT_TRUE(drawing) << (drawing ? "" : drawing.error().message);
        return drawing.value_or(Drawing{});
    }
    /// Returns the kinds of the entities on a layer, each followed by a blank.
    std::string kinds_on(const std::string& layer) const {
        std::istringstream file(read("p.dxf"));
        std::string kinds, kind;
        for (std::string code, value; std::getline(file, code) && std::getline(file, value);) {
            if (code == "0") kind = value;
            if (code == "8" && value == layer && kind != "VERTEX" && kind != "SEQEND") kinds += kind + " ";
        }
        return kinds;
    }
    std::vector<Line> polylines() const {
        std::istringstream file(read("p.dxf"));
        std::vector<Line> lines;
        std::string kind;
        for (std::string code, value; std::getline(file, code) && std::getline(file, value);) {
            if (code == "0") kind = value;
            if (code == "0" && kind == "POLYLINE") lines.emplace_back();
            if (code == "0" && kind == "VERTEX") lines.back().emplace_back();
            if (kind != "VERTEX") continue;
            if (code == "10") lines.back().back().x() = std::stod(value);
            if (code == "20") lines.back().back().y() = std::stod(value);
            if (code == "30") lines.back().back().z() = std::stod(value);
        }
        return lines;
    }
    std::vector<json> moves() const {
        std::istringstream file(read("m.jsonl"));
        std::vector<json> moves;
        for (std::string line; std::getline(file, line);) moves.push_back(text::parse_json<json>(line));
        return moves;
    }
};

double move_length(const Drawing& drawing) {
    double sum_mm = 0;
    for (const geometry::Contour& drawn_contour : drawing.drawn_contours) sum_mm += length_mm(drawn_contour);
    return sum_mm;
}

// Each move is an entity, in order, from the end of the move before to its own end.
TEST_F(DxfOutput, HasEntityForEachMoveWithItsEnds) {
    const Ended ended = draw(
        "G21 G90 F3000\nG0 X10 Y5\nG1 X40 Y5\nX40 Y25\nG3 X30 Y35 I-10\nG2 X10 Y15 I0 J-20\nG1 X10 Y5\n"
        "G91 G1 X5\nX2.5 Y-1\nM30\n");
    ASSERT_EQ(ended.status, 0) << ended.err;
    const std::vector<json> moves = this->moves();
    const Drawing drawing = on({"RAPID", "FEED"});
    ASSERT_EQ(drawing.entities.size(), 8U);
    ASSERT_EQ(moves.size(), drawing.entities.size());
    Point at{0, 0};
    for (std::size_t n = 0; n < moves.size(); ++n) {
        const Point to{moves[n]["to"]["X"], moves[n]["to"]["Y"]};
        const bool arc = moves[n].contains("center");
        EXPECT_EQ(drawing.entities[n].kind, arc ? "ARC" : "LINE") << n;
        Point first, last;
        double radius = 0;
        for (const geometry::Contour& drawn_contour : drawing.drawn_contours) {
            if (drawn_contour.vertices.front().source != n) continue;
            first = drawn_contour.vertices.front().position;
            last = drawn_contour.vertices.back().position;
            if (arc) radius = geometry::radius_mm(drawn_contour.edge(0));
        }
        if (moves[n]["kind"] == "arc_cw") std::swap(first, last);  // DXF knows them counter-clockwise alone
        EXPECT_LT(distance(first, at), kSamePoint_mm) << n;
        EXPECT_LT(distance(last, to), kSamePoint_mm) << n;
        if (arc) {
            const Point center{moves[n]["center"]["X"], moves[n]["center"]["Y"]};
            EXPECT_NEAR(radius, distance(center, to), kSamePoint_mm) << n;
        }
        at = to;
    }
}

TEST_F(DxfOutput, LengthsMatchReport) {
    ASSERT_EQ(
        draw("G21 G90 F3000\nG0 X10 Y5\nG1 X40\nG3 X30 Y15 I-10\nG2 I5\nG2 X30 Y15 I5 P3\nG0 X0 Y0\nM30\n",
             {"--report", "r.json", "--dialect", "rs274ngc"})
            .status,
        0);
    const json report = text::parse_json<json>(read("r.json"));
    EXPECT_NEAR(move_length(on({"RAPID"})), report["length"]["rapid_mm"].get<double>(), 1e-6);
    const double circle_mm = 2 * std::numbers::pi * 5;
    EXPECT_NEAR(move_length(on({"FEED"})), report["length"]["feed_mm"].get<double>() - 2 * circle_mm, 1e-6);
    EXPECT_EQ(kinds_on("FEED"), "LINE ARC CIRCLE CIRCLE ") << "three turns on one circle are drawn once";
}

TEST_F(DxfOutput, LayersSeparateProcessAndHeight) {
    ASSERT_EQ(
        gsim_run(
            {write("jet.nc", "F3000\nG0 X10\nM8\nG1 X20\nG3 X30 Y10 J10 I0\nM9\nG1 X40\nG1 Z5\nG0 Z0\nM30\n"),
             "--quiet", "--dxf", "p.dxf"})
            .status,
        0);
    EXPECT_EQ(kinds_on("RAPID"), "LINE ");
    EXPECT_EQ(kinds_on("CUT"), "LINE ARC ");
    EXPECT_EQ(kinds_on("FEED"), "LINE ");
    EXPECT_EQ(kinds_on("FEED_Z"), "LINE ");
    EXPECT_EQ(kinds_on("RAPID_Z"), "LINE ");
    EXPECT_FALSE(drawing::read_dxf(read("p.dxf"), {})) << "what rises is in no drawing of a part";
    EXPECT_EQ(on({"CUT"}).entities.size(), 2U);
}

// A helix about (10, 0), and an arc about X 30 Z -6 in an upright plane.
TEST_F(DxfOutput, ApproximatesOtherCurvesWithinTolerance) {
    ASSERT_EQ(draw("G21 G90 F3000\nG2 X20 Y0 Z-6 I10 J0\nG18\nG3 X40 Z-6 I10 K0\nM30\n").status, 0);
    EXPECT_EQ(kinds_on("FEED_Z"), "POLYLINE POLYLINE ");
    const std::vector<Line> lines = polylines();
    ASSERT_EQ(lines.size(), 2U);
    const auto deviation_mm = [](const Line& line, const auto& distance_from_axis) {
        double max = 0;
        for (std::size_t i = 1; i < line.size(); ++i) {
            max = std::max(max, std::abs(distance_from_axis(line[i]) - 10));
            max = std::max(max, std::abs(distance_from_axis((line[i - 1] + line[i]) / 2) - 10));
        }
        return max;
    };
    constexpr double kTolerance_mm = 0.005;
    EXPECT_LE(deviation_mm(lines[0], [](const Vector3d& p) { return std::hypot(p.x() - 10, p.y()); }),
              kTolerance_mm);
    EXPECT_LE(deviation_mm(lines[1], [](const Vector3d& p) { return std::hypot(p.x() - 30, p.z() + 6); }),
              kTolerance_mm);
    EXPECT_LT((lines[0].back() - Vector3d(20, 0, -6)).norm(), kSamePoint_mm);
    EXPECT_LT((lines[1].back() - Vector3d(40, 0, -6)).norm(), kSamePoint_mm);
    for (const Line& line : lines) EXPECT_LT(line.size(), 300U);
}

// The drawing has the path of the TCP on the part, not that of the axes: with a table that turns, a straight
// move is a curve.
TEST_F(DxfOutput, DrawsCurveForLineOnTurningTable) {
    const std::string machine = tests::source_path("samples/machines/mill-head-table.toml");
    ASSERT_EQ(gsim_run({write("turn.nc", "G21 G90 F3000\nG1 X10\nC90\nM30\n"), "--machine", machine,
                        "--quiet", "--dxf", "p.dxf"})
                  .status,
              0);
    EXPECT_NE(kinds_on("FEED").find("POLYLINE"), std::string::npos) << read("p.dxf").substr(400);
}

TEST_F(DxfOutput, IsEmptyWithoutMoves) {
    ASSERT_EQ(draw("G4 P1\nM30\n").status, 0);
    EXPECT_TRUE(on({}).entities.empty());
}

TEST_F(DxfOutput, HasMovesBeforeAlarm) {
    EXPECT_EQ(draw("G21 G90 F3000\nG1 X10\n#3000=1 (STOP)\nG1 X20\nM30\n").status, 1);
    EXPECT_EQ(on({"FEED"}).entities.size(), 1U);
}

TEST_F(DxfOutput, WritesDrawingForEachRobot) {
    write("two.toml", "[[robot]]\nname = \"left\"\n[[robot]]\nname = \"right\"\n");
    write("two.lua",
          "process('l', function() local _ENV = robot 'left' F(600) G1{x=10} end)\n"
          "process('r', function() local _ENV = robot 'right' F(600) G1{y=20} end)\n");
    ASSERT_EQ(gsim_run({"--robots", "two.toml", "two.lua", "--dxf", "p.dxf", "--quiet"}).status, 0);
    EXPECT_FALSE(exists("p.dxf"));
    for (const auto& [robot, length] : {std::pair("left", 10.0), {"right", 20.0}}) {
        const auto drawing = drawing::read_dxf(read(fmt::format("p.{}.dxf", robot).c_str()), {});
        ASSERT_TRUE(drawing) << drawing.error().message;
        EXPECT_NEAR(move_length(*drawing), length, kSamePoint_mm) << robot;
    }
}

}  // namespace
}  // namespace gsim::apps::dxf_output_test
