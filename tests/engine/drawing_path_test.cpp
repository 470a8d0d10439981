#include "engine/drawing_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/text/json.h"
#include "engine/path_translation.h"
#include "tests/engine/memory_files.h"

namespace gsim::engine::drawing_path_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

constexpr double kInch_mm = 25.4;

std::string svg(const std::string& content) {
    return "<svg width='100mm' height='100mm' viewBox='0 0 100 100'>" + content + "</svg>";
}

const std::string kPart = svg("<rect width='50' height='30'/><circle cx='20' cy='15' r='5'/>");

/// A drawing and how it is cut, by figures alone.
DrawingRequest request_of_drawing(const std::string& name, std::map<std::string, std::string> files) {
    DrawingRequest request;
    request.drawing = name;
    request.cutting.speed_mm_min = 300;
    request.cutting.kerf_mm = 0.8;
    request.host.files = given(std::move(files));
    return request;
}

/// The same by a material.
DrawingRequest request_of_material(std::map<std::string, std::string> files) {
    DrawingRequest request = request_of_drawing("part.svg", std::move(files));
    request.cutting = {.material = "aluminum", .thickness_mm = 12};
    return request;
}

/// A square of 20 mm, 8 mm thick, whatever file is asked for.
tl::expected<Plate, std::string> square_plate(const std::string&, const PlateReadOptions&) {
    Plate plate{.sources = {{.kind = "edge"}}, .thickness_mm = 8};
    Plate::Outline outline{.closed = true};
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {20.0, 0.0}, {20.0, 20.0}, {0.0, 20.0}})
        outline.vertices.push_back({.position_mm = {x, y}});
    plate.outlines.push_back(outline);
    return plate;
}

tl::expected<DrawingPath, Error> result(DrawingRequest request, const DiagnosticHandler& on_diagnostic = {}) {
    return DrawingPath::open(std::move(request))
        .and_then([&](DrawingPath path) -> tl::expected<DrawingPath, Error> {
            if (auto read = path.read(); !read) return tl::unexpected(read.error());
            if (auto done = path.make(on_diagnostic); !done) return tl::unexpected(done.error());
            return path;
        });
}

std::string rejection(DrawingRequest request) {
    const auto path = result(std::move(request));
    return path ? "a path" : path.error().code + ": " + path.error().message;
}

std::string path_text(const DrawingPath& path) {
    std::string text;
    path.write([&](std::string_view part) {
        text += part;
        return true;
    });
    return text;
}

TEST(DrawingPath, DrawingInMemoryBecomesPathWithMetrics) {
    const auto path = result(request_of_drawing("part.svg", {{"part.svg", kPart}}));
    ASSERT_TRUE(path) << path.error().message;
    EXPECT_EQ(path->metrics().outlines, 2U);
    EXPECT_EQ(path->metrics().pierces, 2U);
    EXPECT_GT(path->metrics().cut_mm, 160 + 31);
    EXPECT_THAT(path->summary(), StartsWith("2 contours, 2 pierces, "));
    EXPECT_FALSE(path->is_solid());
    EXPECT_FALSE(path->job());
    EXPECT_EQ(path->job_report(), "");
    EXPECT_EQ(text::parse_json<json>(path_text(*path))["name"], "part");
}

TEST(DrawingPath, PathCanBePlannedAsProgram) {
    DrawingRequest drawing = request_of_drawing("part.svg", {{"part.svg", kPart}});
    drawing.cutting_path.origin_mm = {500, 500, 100};
    const std::string path = path_text(result(drawing).value());
    PathRequest request;
    request.path = "part.path.json";
    request.post = "ab9";
    request.host.files = given({{"part.path.json", path}});
    auto program = PathTranslation::open(std::move(request)).value();
    ASSERT_TRUE(program.read());
    const auto planned = program.plan();
    EXPECT_TRUE(planned) << planned.error().message;
}

TEST(DrawingPath, StopsWritingIfSinkReturnsFalse) {
    const auto path = result(request_of_drawing("part.svg", {{"part.svg", kPart}})).value();
    int chunk_count = 0;
    path.write([&](std::string_view) { return ++chunk_count < 1; });
    EXPECT_EQ(chunk_count, 1);
}

TEST(DrawingPath, UnitOptionReplacesUnitOfDrawing) {
    const std::string dxf =
        "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\n0\n10\n0\n20\n0\n40\n1\n0\nENDSEC\n0\nEOF\n";
    DrawingRequest request = request_of_drawing("hole.dxf", {{"hole.dxf", dxf}});
    request.cutting_path.lead_mm = 0.1;
    request.reading.unit_mm = 1;
    const double in_mm = result(request).value().metrics().cut_mm;
    request.reading.unit_mm = kInch_mm;
    EXPECT_GT(result(request).value().metrics().cut_mm, 10 * in_mm);
}

TEST(DrawingPath, MaterialGivesParametersAndPrice) {
    const auto path = result(request_of_material({{"part.svg", kPart}}));
    ASSERT_TRUE(path) << path.error().message;
    const auto job = path->job();
    ASSERT_TRUE(job);
    EXPECT_EQ(job->thickness_mm, 12);
    EXPECT_GT(job->speed_mm_min, 0);
    EXPECT_GT(job->price, 0);
    EXPECT_NEAR(job->jet_s, path->metrics().cut_s + 2 * job->pierce_s, 1e-9);
    EXPECT_THAT(path->job_report(), StartsWith("Cutting aluminum, 12 mm\n"));
}

TEST(DrawingPath, ReadsMaterialsFromGivenFiles) {
    DrawingRequest request =
        request_of_material({{"part.svg", kPart}, {"mine.toml", "[jet]\nnonsense = 1\n"}});
    request.cutting.materials = "mine.toml";
    const auto path = DrawingPath::open(request);
    ASSERT_FALSE(path);
    EXPECT_THAT(path.error().message, StartsWith("mine.toml:2:1: unknown key 'nonsense' in [jet]; "));
    EXPECT_EQ(path.error().file, "mine.toml");
}

TEST(DrawingPath, RejectsConflictingOptions) {
    DrawingRequest request = request_of_drawing("part.svg", {{"part.svg", kPart}});
    request.cutting.kerf_mm.reset();
    EXPECT_EQ(rejection(request), "usage: give --material and --thickness, or --speed and --kerf");
    request = request_of_drawing("part.svg", {{"part.svg", kPart}});
    request.reading.flip = true;
    EXPECT_EQ(rejection(request), "input-file: --up and --flip apply to STEP and IGES files");
    request = request_of_drawing("part.step", {});
    request.reading.layers = {"0"};
    EXPECT_EQ(rejection(request),
              "input-file: --unit and --layer apply to drawings; a STEP or IGES file defines its unit");
}

TEST(DrawingPath, NamesMissingOrUnknownDrawing) {
    EXPECT_EQ(rejection(request_of_drawing("none.svg", {})),
              "input-file: cannot read 'none.svg': file not found");
    EXPECT_EQ(rejection(request_of_drawing("part.txt", {{"part.txt", ""}})),
              "input-file: 'part.txt' is neither a .dxf nor an .svg file");
}

TEST(DrawingPath, MarksErrorOfDrawingAsInProgram) {
    const auto path =
        result(request_of_drawing("part.svg", {{"part.svg", svg("<path id='p' d='M0 0L10 10L10 0'/>")}}));
    ASSERT_FALSE(path);
    EXPECT_TRUE(path.error().in_program);
    EXPECT_EQ(path.error().code, "path");
    EXPECT_EQ(path.error().file, "part.svg");
    EXPECT_THAT(path.error().message, StartsWith("part.svg: "));
    EXPECT_THAT(path.error().message, HasSubstr("not closed"));
}

TEST(DrawingPath, RejectsSolidsWithoutReader) {
    EXPECT_EQ(rejection(request_of_drawing("part.step", {})),
              "input-file: part.step: STEP and IGES files are not supported here, only DXF and SVG files");
}

TEST(DrawingPath, TakesPlateAndThicknessFromHost) {
    DrawingRequest request = request_of_drawing("part.step", {});
    request.host.read_plate = square_plate;
    request.cutting = {.material = "aluminum"};
    const auto path = result(request);
    ASSERT_TRUE(path) << path.error().message;
    EXPECT_TRUE(path->is_solid());
    EXPECT_EQ(path->job()->thickness_mm, 8);
    EXPECT_EQ(path->metrics().outlines, 1U);
}

TEST(DrawingPath, ReportsDifferentPlateThickness) {
    DrawingRequest request = request_of_drawing("part.step", {});
    request.host.read_plate = square_plate;
    request.cutting = {.material = "aluminum", .thickness_mm = 10};
    std::vector<std::string> reported;
    ASSERT_TRUE(
        result(request, [&](const Diagnostic& note) { reported.push_back(note.file + ": " + note.text); }));
    ASSERT_FALSE(reported.empty());
    EXPECT_EQ(reported.front(), "part.step: the solid is 8 mm thick, but --thickness is 10 mm");
}

TEST(DrawingPath, PassesReadOptionsToHost) {
    PlateReadOptions requested;
    DrawingRequest request = request_of_drawing("part.iges", {});
    request.host.read_plate = [&](const std::string& file, const PlateReadOptions& options) {
        requested = options;
        return square_plate(file, options);
    };
    request.reading.up = "-z";
    request.reading.flip = true;
    request.reading.curve_tolerance_mm = 0.125;
    ASSERT_TRUE(result(request));
    EXPECT_EQ(requested.up, "-z");
    EXPECT_TRUE(requested.flip);
    EXPECT_EQ(requested.tolerance_mm, 0.125);
}

// A square hole of 20 mm in the face z = 0, with upright walls.
tl::expected<Contours, std::string> square_hole(const std::string&, const ContourSelection&) {
    using Vec3 = Contours::Vec3;
    const std::array<Vec3, 4> corners{{{0, 0, 0}, {0, 20, 0}, {20, 20, 0}, {20, 0, 0}}};
    const std::array<Vec3, 4> tangents{{{0, 1, 0}, {1, 0, 0}, {0, -1, 0}, {-1, 0, 0}}};
    const std::array<Vec3, 4> wastes{{{1, 0, 0}, {0, -1, 0}, {-1, 0, 0}, {0, 1, 0}}};
    Contours::Contour hole{.face = "the plane face #1", .is_hole = true};
    for (std::size_t i = 0; i < 4; ++i) {
        Contours::Edge edge{.name = "edge #" + std::to_string(i + 2)};
        const Vec3& from = corners[i];
        const Vec3& to = corners[(i + 1) % 4];
        for (const double share : {0.0, 0.5, 1.0}) {
            edge.points.push_back(
                {.position_mm = {from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1]), 0},
                 .normal = {0, 0, 1},
                 .tangent = tangents[i],
                 .wall_normal = wastes[i],
                 .along_wall = {0, 0, -1},
                 .depth_mm = 6,
                 .exit_normal = wastes[i]});
        }
        hole.edges.push_back(edge);
    }
    return Contours{
        .contours = {hole}, .low_mm = {-9, -9, -6}, .high_mm = {29, 29, 4}, .notes = {"half is left"}};
}

DrawingRequest request_of_contours() {
    DrawingRequest request = request_of_drawing("part.step", {});
    request.host.read_contours = square_hole;
    request.cutting = {.speed_mm_min = 300, .kerf_mm = 1};
    request.surface = SurfaceCuttingOptions{};
    return request;
}

TEST(DrawingPath, TakesContoursFromHost) {
    std::vector<std::string> reported;
    const auto path =
        result(request_of_contours(), [&](const Diagnostic& note) { reported.push_back(note.text); });
    ASSERT_TRUE(path) << path.error().message;
    EXPECT_EQ(path->metrics().pierces, 1U);
    EXPECT_NEAR(path->metrics().cut_mm, 4 * 19 + 2 * 3 * 1.5708, 0.01);  // and two leads of three kerfs
    EXPECT_EQ(reported, std::vector<std::string>{"half is left"});
}

TEST(DrawingPath, OpenEdgeChainMustNotCutOtherEdges) {
    DrawingRequest request = request_of_contours();
    ContourSelection requested;
    request.surface->contours.kind = "edges";
    request.surface->contours.edges = {"#2"};
    const auto one_side = [&](const std::string& file, const ContourSelection& options) {
        requested = options;
        Contours hole = square_hole(file, options).value();
        Contours::Contour& contour = hole.contours.front();
        for (std::size_t i = 1; i < 4; ++i) {
            Contours::PartEdge other{.name = contour.edges[i].name};
            for (const Contours::Point& point : contour.edges[i].points)
                other.points_mm.push_back(point.position_mm);
            hole.other_edges.push_back(other);
        }
        contour.edges.resize(1);
        contour.is_hole = false;
        contour.is_open = true;
        return hole;
    };
    request.host.read_contours = one_side;
    EXPECT_THAT(rejection(request),
                HasSubstr("edge #2 cannot be cut: at (0, 0, 0) the jet would cut 0.5 mm into edge #5"));
    EXPECT_EQ(requested.edges, std::vector<std::string>{"#2"});
    request.host.read_contours = [&](const std::string& file, const ContourSelection& options) {
        Contours standalone = one_side(file, options);
        standalone.other_edges.clear();
        return tl::expected<Contours, std::string>(standalone);
    };
    const auto path = result(request);
    ASSERT_TRUE(path) << path.error().message;
    EXPECT_NEAR(path->metrics().cut_mm, 20 + 2 * 3, 0.01);  // and three kerfs beyond each end
}

TEST(DrawingPath, RejectsOptionsNotForContours) {
    DrawingRequest drawing = request_of_contours();
    drawing.drawing = "part.svg";
    EXPECT_THAT(rejection(drawing), HasSubstr("--contours applies to STEP and IGES files"));
    DrawingRequest flipped = request_of_contours();
    flipped.reading.flip = true;
    EXPECT_THAT(rejection(flipped), HasSubstr("--up and --flip apply to flat parts, without --contours"));
    DrawingRequest bevelled = request_of_contours();
    bevelled.cutting_path.bevel_deg = 10;
    EXPECT_THAT(rejection(bevelled), HasSubstr("--bevel applies to flat parts"));
    DrawingRequest leaned = request_of_contours();
    leaned.surface->tilt_deg = 10;
    EXPECT_THAT(rejection(leaned), HasSubstr("--tilt-angle is relative to the face normal"));
    DrawingRequest edges = request_of_contours();
    edges.surface->contours.kind = "edges";
    EXPECT_THAT(rejection(edges), HasSubstr("--contours edges requires the numbers of edges (--edge)"));
    DrawingRequest standalone = request_of_contours();
    standalone.host.read_contours = {};
    EXPECT_THAT(rejection(standalone),
                HasSubstr("STEP and IGES files are not supported here, only DXF and SVG files"));
}

}  // namespace
}  // namespace gsim::engine::drawing_path_test
