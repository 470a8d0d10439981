// Parts that are not flat, from their STEP files to what a machine that runs the program leaves of them.

#include "tests/cam/solid/surface_program.h"

#include <BRepGProp.hxx>
#include <Eigen/Geometry>
#include <GProp_GProps.hxx>
#include <STEPControl_Reader.hxx>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "base/units.h"
#include "tests/build_files/build_files.h"
#include "tests/cam/solid/part_models.h"
#include "tests/cam/solid/solids.h"
#include "tests/cam/solid/wheel_path.h"

namespace gsim::apps::surface_program_test {

namespace {

using namespace solid::models;
using Eigen::Vector3d;
// A slot with round ends along y, in the plane: 0 to 1 round it.
Eigen::Vector2d slot(double half_mm, double radius_mm, double share) {
    const double quarter = share * 4;
    const double part = quarter - std::floor(quarter);
    const double turn = part * kTurn_rad / 2;
    if (quarter < 1) return {radius_mm, -half_mm + 2 * half_mm * part};
    if (quarter < 2) return {radius_mm * std::cos(turn), half_mm + radius_mm * std::sin(turn)};
    if (quarter < 3) return {-radius_mm, half_mm - 2 * half_mm * part};
    return {-radius_mm * std::cos(turn), -half_mm - radius_mm * std::sin(turn)};
}

constexpr int kStepsOfEdge = 40;
constexpr int kFineSteps = 1000;

// Returns positions at a depth, for each edge of a pocket.
std::vector<Points> edges_at(const std::vector<WheelStep>& pocket, double depth_mm, int steps) {
    std::vector<Points> edges;
    for (const WheelStep& step : pocket) {
        Points& points = edges.emplace_back();
        for (int n = 0; n <= steps; ++n) {
            const auto position = step.at(static_cast<double>(n) / steps);
            const auto axis = step.axis(static_cast<double>(n) / steps);
            points.emplace_back(position[0] - depth_mm * axis[0] / axis[2],
                                position[1] - depth_mm * axis[1] / axis[2], -depth_mm);
        }
    }
    return edges;
}

Points together(const std::vector<Points>& edges) {
    Points all;
    for (const Points& points : edges) all.insert(all.end(), points.begin(), points.end());
    return all;
}

// Returns true if a jet along the wall can pass a position of an edge without cutting into another position.
bool is_long_enough(const WheelStep& step, std::size_t n, const Points& edge, const Points& all,
                    double kerf_mm, double near_mm) {
    const auto values = step.axis(static_cast<double>(n) / kStepsOfEdge);
    const Vector3d axis(values[0], values[1], values[2]);
    const Vector3d along = edge[std::min(n + 1, edge.size() - 1)] - edge[n == 0 ? 0 : n - 1];
    const Vector3d waste_direction = along.cross(axis).normalized();  // the program runs round clockwise
    const Vector3d middle = edge[n] + kerf_mm / 2 * waste_direction;
    return std::none_of(all.begin(), all.end(), [&](const Vector3d& position) {
        return (position - middle).cross(axis).norm() < kerf_mm / 2 - near_mm;
    });
}

TEST_F(SurfaceProgram, CutsHolesOfBentBracketAtTheirPositions) {
    using B = Bracket;
    const auto jet_path = jets(sample("parts/bracket.step"), {600, 600, 120},
                               {"--contours", "holes", "--speed", "400", "--cut-height", "1"});
    EXPECT_TRUE(contains(told_, "4 contours, 4 pierces")) << told_;
    const double bend = B::kBend_deg * kRadPerDeg;
    const double inner = B::kOuterRadius_mm - B::kThickness_mm;
    const Vector3d up(-std::sin(bend), 0, std::cos(bend));
    const Vector3d rising(std::cos(bend), 0, std::sin(bend));
    const auto on_rising = [&](double mm, double y) -> Vector3d {
        return Vector3d(0, y, B::kOuterRadius_mm) - inner * up + mm * rising;
    };
    for (const double depth : {0.0, B::kThickness_mm / 2, B::kThickness_mm}) {
        const std::string at = fmt::format(" at {} mm", depth);
        expect_cut("the upright hole" + at, along([&](double share) {
                       const double turn = share * kTurn_rad;
                       return Vector3d(B::kHoleX_mm + B::kHoleRadius_mm * std::cos(turn),
                                       B::kHoleY_mm + B::kHoleRadius_mm * std::sin(turn),
                                       B::kThickness_mm - depth);
                   }),
                   jet_path);
        expect_cut("the slot" + at, along([&](double share) {
                       const Eigen::Vector2d off = slot(B::kSlotHalf_mm, B::kSlotRadius_mm, share);
                       return Vector3d(B::kSlotX_mm + off.x(), B::kSlotY_mm + off.y(),
                                       B::kThickness_mm - depth);
                   }),
                   jet_path);
        const auto round = [&](const Vector3d& middle, double radius) {
            return along([=](double share) -> Vector3d {
                const double turn = share * kTurn_rad;
                return middle - depth * up + radius * std::cos(turn) * rising +
                       Vector3d(0, radius * std::sin(turn), 0);
            });
        };
        expect_cut("the hole in the rising flange" + at,
                   round(on_rising(B::kFarAlong_mm, B::kFarY_mm), B::kFarRadius_mm), jet_path);
        expect_cut("the tapered hole" + at,
                   round(on_rising(B::kTaperAlong_mm, B::kTaperY_mm),
                         B::kTaperRadius_mm - depth * std::tan(B::kTaper_deg * kRadPerDeg)),
                   jet_path);
    }
}

TEST_F(SurfaceProgram, CutsSlotThroughSideOfCone) {
    using F = Frustum;
    const auto jet_path =
        jets(sample("parts/frustum.step"), {300, 900, 150},
             {"--contours", "holes", "--speed", "400", "--cut-height", "1", "--box-low", "55", "-50", "0"});
    EXPECT_TRUE(contains(told_, "1 contours, 1 pierces")) << told_;
    const double fall = (F::kLowerRadius_mm - F::kUpperRadius_mm) / F::kHeight_mm;
    const double tilt = std::atan2(1, fall);  // of the side's normal
    const double less = F::kWall_mm / std::sin(tilt);
    const Vector3d middle((F::kLowerRadius_mm + F::kUpperRadius_mm) / 2, 0, F::kHeight_mm / 2);
    const Vector3d x(std::cos(tilt), 0, -std::sin(tilt));
    const Vector3d up(std::sin(tilt), 0, std::cos(tilt));
    // The slot's wall at a height over the middle of the side.
    const auto wall = [&](double share, double height) -> Vector3d {
        const double radius = F::kSlotRadius_mm + height * std::tan(F::kTaper_deg * kRadPerDeg);
        const Eigen::Vector2d off = slot(F::kSlotHalf_mm, radius, share);
        return middle + off.x() * x + Vector3d(0, off.y(), 0) + height * up;
    };
    const auto on_cone = [&](double share, double inside_mm) {
        double low = -12;
        double high = 12;
        while (high - low > 1e-9) {
            const double height = (low + high) / 2;
            const Vector3d at = wall(share, height);
            const bool outside = std::hypot(at.x(), at.y()) > F::kLowerRadius_mm - inside_mm - fall * at.z();
            (outside ? high : low) = height;
        }
        return wall(share, low);
    };
    expect_cut("the outer edge", along([&](double share) { return on_cone(share, 0); }), jet_path);
    expect_cut("the inner edge", along([&](double share) { return on_cone(share, less); }), jet_path);
}

TEST_F(SurfaceProgram, WheelFromModelMatchesThesis) {
    const auto pockets = wheel_pockets(sample("wheel.path.json"));
    const auto& at = kWheelMiddle_mm;
    const auto jet_path = jets(sample("parts/wheel.step"), {at[0], at[1], at[2]},
                               {"--contours", "all", "--cut-height", "0", "--max-tilt", "72", "--speed",
                                "6350", "--cell", sample("cell/wheel.toml")},
                               sample("cell/wheel.toml"), "af5");
    EXPECT_TRUE(contains(told_, "6 contours, 6 pierces")) << told_;
    // The machine's home is below the table, with clamps between.
    EXPECT_TRUE(contains(told_, "1 of 7 linking moves were rerouted")) << told_;
    // The control that was measured rounds the corners of B and C; its time is of interest.
    const Ended measured =
        gsim_run({"part.nc", "--machine", "af5-measured", "--cell", sample("cell/wheel.toml")});
    EXPECT_EQ(measured.status, 0) << measured.err;
    fmt::print("{}", measured.out.substr(0, measured.out.find("blocks")));
    ASSERT_EQ(pockets.size(), 4U);
    int unreachable_count = 0;
    const auto ring = [](double radius, double depth) {
        return along(
            [=](double share) {
                return Vector3d(radius * std::cos(share * kTurn_rad), radius * std::sin(share * kTurn_rad),
                                -depth);
            },
            720);
    };
    for (const double depth : {0.0, kWheelThickness_mm}) {
        const std::string where = fmt::format(" at {} mm", depth);
        expect_cut("the rim" + where, ring(kRimRadius_mm, depth), jet_path);
        expect_cut("the bore" + where, ring(kBoreRadius_mm, depth), jet_path);
        for (std::size_t i = 0; i < pockets.size(); ++i) {
            const std::vector<Points> edges = edges_at(pockets[i], depth, kStepsOfEdge);
            const Points all = together(edges_at(pockets[i], depth, kFineSteps));
            for (std::size_t k = 0; k < edges.size(); ++k) {
                const std::string what = fmt::format("pocket {}, edge {}{}", i + 1, k + 1, where);
                const Deviation off = deviation(edges[k], jet_path, kKerf_mm);
                EXPECT_GE(off.min_mm, -kNear_mm) << what;
                Points open;
                for (std::size_t n = 0; n < edges[k].size(); ++n) {
                    if (is_long_enough(pockets[i][k], n, edges[k], all, kKerf_mm, kNear_mm))
                        open.push_back(edges[k][n]);
                }
                unreachable_count += static_cast<int>(edges[k].size() - open.size());
                expect_cut(what, open, jet_path);
            }
        }
    }
    // Lower edges meet at corners of up to 147 degrees, into which no jet comes.
    fmt::print("{} places of lower edges are narrower than the jet\n", unreachable_count);
    EXPECT_LT(unreachable_count, 30);
    EXPECT_TRUE(contains(told_, "corners of lower edges are narrower than the jet")) << told_;
}

TEST_F(SurfaceProgram, RejectsUncuttableContourWithEdgeAndReason) {
    const std::string bracket = sample("parts/bracket.step");
    const Ended tilt = autopath(sample("parts/wheel.step"), {"--contours", "all"});
    EXPECT_EQ(tilt.status, 1);
    EXPECT_TRUE(contains(tilt.err, "edge #")) << tilt.err;
    EXPECT_TRUE(contains(tilt.err, "deg from the face normal, more than 60 deg (--max-tilt)")) << tilt.err;
    const Ended wide = autopath(bracket, {"--contours", "holes", "--box-low", "-45", "0", "0"}, "19");
    EXPECT_TRUE(contains(wide.err, "cannot be cut")) << wide.err;
    const Ended standalone = autopath(bracket, {"--side", "y"});
    EXPECT_TRUE(contains(standalone.err, "--side requires --contours")) << standalone.err;
    const Ended nameless = autopath(bracket, {"--contours", "holes", "--face", "sheet"});
    EXPECT_TRUE(contains(nameless.err, "it has no face with the number, name, layer or colour 'sheet'"))
        << nameless.err;
    EXPECT_FALSE(exists("part.path.json"));
    // Out of reach: X ends at 1828.8 mm.
    EXPECT_EQ(autopath(bracket, {"--contours", "holes", "--at", "1850", "600", "120"}).status, 0);
    const Ended far =
        run_program(tests::program_path("path2gcode"), {"part.path.json", "-o", "part.nc"}, folder_);
    EXPECT_NE(far.status, 0);
    EXPECT_TRUE(contains(far.err, "X")) << far.err;
}

TEST_F(SurfaceProgram, ScriptSelectsContours) {
    const auto autopath = [&](const std::string& script) {
        write("choose.lua", script);
        return run_program(tests::program_path("autopath"),
                           {sample("parts/bracket.step"), "--contours", "holes", "--choose", "choose.lua",
                            "--kerf", "0.8", "--speed", "400", "-o", "part.path.json"},
                           folder_);
    };
    // One of the bracket's holes is tapered, by 12 degrees.
    const Ended one =
        autopath("return function(contour) return contour.tilt_deg > 10 and contour.tilt_deg < 14 end");
    EXPECT_EQ(one.status, 0) << one.err;
    EXPECT_TRUE(contains(one.err, "1 contours, 1 pierces")) << one.err;
    std::filesystem::remove(folder_ / "part.path.json");
    const Ended none = autopath("return function(contour) return contour.length_mm < 1 end");
    EXPECT_EQ(none.status, 1);
    EXPECT_TRUE(contains(none.err, "choose.lua:1: the script selects 0 of the 4 contours")) << none.err;
    EXPECT_FALSE(exists("part.path.json"));
    const Ended lonely = run_program(tests::program_path("autopath"),
                                     {sample("plate.svg"), "--choose", "choose.lua"}, folder_);
    EXPECT_TRUE(contains(lonely.err, "--choose requires --contours")) << lonely.err;
}

TEST_F(SurfaceProgram, SelectsFacesByName) {
    std::string text = solid::read_file(sample("parts/bracket.step"));
    for (std::size_t at = 0; (at = text.find("ADVANCED_FACE(''", at)) != std::string::npos; at += 20)
        text.replace(at, 16, "ADVANCED_FACE('sheet'");
    const std::string named = write("named.step", text);
    const Ended ended = run_program(tests::program_path("autopath"),
                                    {named, "--contours", "holes", "--face", "sheet", "--kerf", "0.8",
                                     "--speed", "400", "-o", "part.path.json"},
                                    folder_);
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_TRUE(contains(ended.err, "4 contours")) << ended.err;
}

TEST_F(SurfaceProgram, SelectsFacesByColourAndLayer) {
    std::string text = solid::read_file(sample("parts/bracket.step"));
    // `face` is the face of a hole, as the error names it.
    const auto run = [&](const std::string& file, const std::string& face) {
        return run_program(tests::program_path("autopath"),
                           {file, "--contours", "holes", "--face", face, "--box-low", "-45", "0", "0",
                            "--kerf", "19", "--speed", "400", "-o", "part.path.json"},
                           folder_);
    };
    const std::size_t face = text.find(" = ADVANCED_FACE(''");
    ASSERT_NE(face, std::string::npos);
    std::string styled;
    for (std::size_t at = face, number = 900000; at != std::string::npos;
         at = text.find(" = ADVANCED_FACE(''", at + 1), number += 10) {
        const std::string label = text.substr(text.rfind('#', at), at - text.rfind('#', at));
        styled += fmt::format("#{} = STYLED_ITEM('',(#800007),{});\n", number, label);
        styled += fmt::format("#{} = PRESENTATION_LAYER_ASSIGNMENT('cut','',({}));\n", number + 1, label);
    }
    const std::string colour =
        "#800001 = COLOUR_RGB('',1.,0.501960784,0.);\n#800002 = FILL_AREA_STYLE_COLOUR('',#800001);\n"
        "#800003 = FILL_AREA_STYLE('',(#800002));\n#800004 = SURFACE_STYLE_FILL_AREA(#800003);\n"
        "#800005 = SURFACE_SIDE_STYLE('',(#800004));\n#800006 = SURFACE_STYLE_USAGE(.BOTH.,#800005);\n"
        "#800007 = PRESENTATION_STYLE_ASSIGNMENT((#800006));\n";
    text.insert(text.rfind("ENDSEC;"), colour + styled);
    const std::string file = write("styled.step", text);
    for (const std::string name : {"255,128,0", "cut"})
        EXPECT_TRUE(contains(run(file, name).err, "cannot be cut")) << name << run(file, name).err;
    EXPECT_TRUE(contains(run(file, "0,128,0").err, "no face with")) << run(file, "0,128,0").err;
}

TEST_F(SurfaceProgram, SamplesMatchModels) {
    const auto volume_of = [](const std::string& file) {
        STEPControl_Reader reader;
        EXPECT_EQ(reader.ReadFile(file.c_str()), IFSelect_RetDone);
        reader.TransferRoots();
        GProp_GProps properties;
        BRepGProp::VolumeProperties(reader.OneShape(), properties);
        return properties.Mass();
    };
    const solid::SolidFolder folder;
    const auto expect_same = [&](const std::string& name, const TopoDS_Shape& model) {
        const double volume_mm3 = volume_of(folder.step(name, model).string());
        EXPECT_NEAR(volume_of(sample("parts/" + name)), volume_mm3, 1e-6 * volume_mm3) << name;
    };
    expect_same("bracket.step", bracket());
    expect_same("frustum.step", frustum());
    expect_same("wheel.step", wheel(sample("wheel.path.json")));
}

}  // namespace
}  // namespace gsim::apps::surface_program_test
