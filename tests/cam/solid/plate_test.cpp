#include "cam/solid/plate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cam/cutting/layout.h"
#include "geometry/planar/chain.h"
#include "tests/cam/solid/solids.h"

namespace gsim::solid::plate_test {

namespace {

using geometry::Contour;
using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

Plate plate_of(const std::filesystem::path& file, const PlateOptions& options = {}) {
    auto plate = read_plate(file, options);
    EXPECT_TRUE(plate) << plate.error().message;
    return plate ? *std::move(plate) : Plate{};
}

std::string error_of(const std::filesystem::path& file) {
    const auto plate = read_plate(file, {});
    return plate ? "" : plate.error().message;
}

// Areas of the closed contours, the largest first.
std::vector<double> areas_mm2(const std::vector<Contour>& contours) {
    std::vector<double> areas;
    areas.reserve(contours.size());
    for (const Contour& contour : contours) areas.push_back(std::abs(area_mm2(contour)));
    std::sort(areas.rbegin(), areas.rend());
    return areas;
}

std::vector<double> areas_mm2(const Plate& plate) {
    const geometry::ChainResult chains = geometry::chain(plate.drawing.drawn_contours, 0.02);
    EXPECT_TRUE(chains.open.empty());
    return areas_mm2(chains.closed);
}

// Returns the areas of the paths.
std::vector<double> offset_areas_mm2(const Plate& plate, double kerf_mm) {
    const auto layout = cutting::make_layout(plate.drawing, {kerf_mm, 0.02});
    EXPECT_TRUE(layout) << layout.error().message;
    std::vector<Contour> contours;
    if (!layout) return {};
    for (const cutting::Loop& loop : layout->loops) contours.push_back(loop.contour);
    return areas_mm2(contours);
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected_value) {
    ASSERT_EQ(found.size(), expected_value.size());
    for (std::size_t i = 0; i < expected_value.size(); ++i)
        EXPECT_NEAR(found[i], expected_value[i], 1e-3 * expected_value[i]) << i;
}

std::vector<double> bevels_deg(const Plate& plate) {
    std::vector<double> bevels;
    for (const drawing::Entity& entity : plate.drawing.entities) bevels.push_back(entity.bevel_deg);
    std::sort(bevels.begin(), bevels.end());
    return bevels;
}

// 100 x 60 x 8 with a round, an elliptic and a square hole.
TopoDS_Shape drilled_plate() {
    return without(box({0, 0, 0}, {100, 60, 8}),
                   {cylinder({20, 30, -1}, 10, 10), elliptic_cylinder({50, 30, -1}, 12, 6, 10),
                    box({70, 20, -1}, {90, 40, 9})});
}

double offset_ellipse_area(double a, double b, double inward_offset) {
    // Steiner: area - length * d + pi d^2; the length by Ramanujan's second formula.
    const double h = (a - b) * (a - b) / ((a + b) * (a + b));
    const double length = kPi * (a + b) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
    return kPi * a * b - length * inward_offset + kPi * inward_offset * inward_offset;
}

void expect_drilled_plate(const Plate& plate) {
    expect_near(areas_mm2(plate), {6000, 400, kPi * 100, kPi * 72});
    const double d = 0.5;
    expect_near(offset_areas_mm2(plate, 1),
                {6000 + 320 * d + kPi * d * d, 19.0 * 19.0, kPi * 9.5 * 9.5, offset_ellipse_area(12, 6, d)});
}

TEST(Plate, ReadsOutlinesOfUpperSide) {
    const SolidFolder folder;
    for (const auto& file :
         {folder.step("plate.step", drilled_plate()), folder.step("inch.stp", drilled_plate(), "INCH"),
          folder.iges("plate.igs", drilled_plate()),
          folder.iges("faces.iges", drilled_plate(), "M", false)}) {
        const Plate plate = plate_of(file);
        SCOPED_TRACE(file.string());
        EXPECT_NEAR(plate.thickness_mm, 8, 1e-3);
        expect_drilled_plate(plate);
        EXPECT_EQ(bevels_deg(plate), std::vector<double>(plate.drawing.entities.size(), 0.0));
        EXPECT_TRUE(plate.drawing.notes.empty());
    }
}

// Some programs write all surfaces and curves as splines.
TEST(Plate, AcceptsSplineSurfaces) {
    const SolidFolder folder;
    const Plate plate = plate_of(folder.step("a.step", as_splines(drilled_plate())));
    expect_drilled_plate(plate);
    EXPECT_EQ(bevels_deg(plate), std::vector<double>(plate.drawing.entities.size(), 0.0));
}

TEST(Plate, AcceptsAnyPlane) {
    const SolidFolder folder;
    const Plate upright = plate_of(folder.step("a.step", turned(drilled_plate(), {1, 0, 0}, kPi / 2)));
    expect_drilled_plate(upright);
    const Plate askew =
        plate_of(folder.step("b.step", turned(drilled_plate(), {1, 2, 3}, 1.1, {50, 60, -70})));
    EXPECT_NEAR(askew.thickness_mm, 8, 1e-6);
    expect_drilled_plate(askew);
}

TEST(Plate, KeepsFilePositionsIfLevel) {
    const SolidFolder folder;
    const TopoDS_Shape part = cylinder({30, -20, 5}, 10, 4);
    for (const bool flip : {false, true}) {
        const Plate plate = plate_of(folder.step("a.step", part), {0.005, flip, {}});
        geometry::Box box;
        for (const Contour& drawn_contour : plate.drawing.drawn_contours)
            box.add(bounding_box(drawn_contour));
        EXPECT_NEAR(box.low.x, 20, 1e-6);
        EXPECT_NEAR(box.high.x, 40, 1e-6);
        // Seen from below Y points down.
        EXPECT_NEAR(box.low.y, flip ? 10 : -30, 1e-6);
    }
}

TEST(Plate, AcceptsPlateThickerThanWideWithUpAxis) {
    const SolidFolder folder;
    // The largest faces are inner and outer sides.
    const auto file =
        folder.step("a.step", without(box({0, 0, 0}, {50, 50, 80}), {box({5, 5, -1}, {45, 45, 81})}));
    EXPECT_FALSE(read_plate(file, {}));
    for (const std::string along : {"z", "-z"}) {
        const Plate plate = plate_of(file, {0.005, false, along});
        EXPECT_NEAR(plate.thickness_mm, 80, 1e-6);
        expect_near(areas_mm2(plate), {2500, 1600});
    }
}

TEST(Plate, TiltedSidesHaveBevels) {
    const SolidFolder folder;
    // Larger below: the large side is the upper one, and the part is smaller below it.
    const auto file = folder.step("a.step", frustum({0, 0, 0}, 60, 40, 50, 36, 10));  // ruled spline surfaces
    const double x_bevel = std::atan(5.0 / 10) * 180 / kPi;
    const double y_bevel = std::atan(2.0 / 10) * 180 / kPi;
    const Plate plate = plate_of(file);
    expect_near(areas_mm2(plate), {2400});
    EXPECT_THAT(bevels_deg(plate),
                testing::Pointwise(testing::DoubleNear(1e-6), {y_bevel, y_bevel, x_bevel, x_bevel}));
    const Plate flipped = plate_of(file, {0.005, true, {}});
    expect_near(areas_mm2(flipped), {1800});
    EXPECT_THAT(bevels_deg(flipped),
                testing::Pointwise(testing::DoubleNear(1e-6), {-x_bevel, -x_bevel, -y_bevel, -y_bevel}));
    for (const drawing::Entity& entity : plate.drawing.entities) {
        // The long edges lie along X, below them the sides that face along Y.
        const auto source = static_cast<std::size_t>(&entity - plate.drawing.entities.data());
        EXPECT_NEAR(length_mm(plate.drawing.drawn_contours[source]), entity.bevel_deg > 20 ? 40 : 60, 1e-6);
    }
}

TEST(Plate, ConicalHolesHaveBevels) {
    const SolidFolder folder;
    // The upper side faces along Z; the hole is wider there by 4 mm in 10.
    const TopoDS_Shape part = without(box({-30, -30, 0}, {30, 30, 10}), {cone({0, 0, -5}, 10, 18, 20)});
    const Plate plate = plate_of(folder.step("a.step", part));
    // The larger of two faces is up: the lower one, with the smaller hole.
    expect_near(areas_mm2(plate), {3600, kPi * 144});
    const double bevel = std::atan(8.0 / 20) * 180 / kPi;
    const Plate flipped = plate_of(folder.step("a.step", part), {0.005, true, {}});
    expect_near(areas_mm2(flipped), {3600, kPi * 256});
    EXPECT_NEAR(bevels_deg(plate).back(), bevel, 1e-6);
    EXPECT_NEAR(bevels_deg(flipped).front(), -bevel, 1e-6);
}

// A side that is ruled between two lines that are not parallel turns along its edge.
TEST(Plate, DividesVaryingBevelIntoSteps) {
    const SolidFolder folder;
    const TopoDS_Shape part = loft({{-20, -20, 0}, {20, -20, 0}, {20, 15, 0}, {-20, 20, 0}},
                                   {{-20, -20, 5}, {20, -20, 5}, {20, 20, 5}, {-20, 20, 5}});
    const Plate plate = plate_of(folder.step("a.step", part));
    expect_near(areas_mm2(plate), {1600});
    std::size_t sections = 0;
    for (std::size_t i = 0; i < plate.drawing.entities.size(); ++i) {
        const geometry::Contour& drawn_contour = plate.drawing.drawn_contours[i];
        const geometry::Point middle = point_at(drawn_contour.edge(0), 0.5);
        if (std::abs(middle.y - 20) > 1e-6) continue;
        ++sections;
        // Below y = 20 there is 20 at x = -20 and 15 at x = 20, 5 mm deeper.
        const double wall_tilt_deg = std::atan((middle.x + 20) / 40) * 180 / kPi;
        EXPECT_NEAR(plate.drawing.entities[i].bevel_deg, wall_tilt_deg, 0.3);
    }
    EXPECT_GE(sections, 90U);
}

TEST(Plate, SeveralBodiesGiveSeveralParts) {
    const SolidFolder folder;
    const auto two = [](double z) {
        return together({cylinder({0, 0, 0}, 10, 5), box({20, 0, z}, {40, 30, 5 + z})});
    };
    expect_near(areas_mm2(plate_of(folder.step("a.step", two(0)))), {600, kPi * 100});
    EXPECT_THAT(error_of(folder.step("b.step", two(1))), HasSubstr(" is 1 mm below the upper side"));
}

TEST(Plate, AcceptsPlanarCurvesAndFaces) {
    const SolidFolder folder;
    const TopoDS_Shape level = largest_face(drilled_plate());
    const TopoDS_Shape askew = largest_face(turned(drilled_plate(), {1, 2, 2}, 0.7, {1, 2, 3}));
    for (const auto& file :
         {folder.step("face.step", askew), folder.step("curves.step", edges_of(askew)),
          folder.iges("face.igs", askew, "MM", false), folder.iges("curves.igs", edges_of(level), "INCH"),
          folder.iges("askew.igs", edges_of(askew))}) {
        const Plate plate = plate_of(file);
        SCOPED_TRACE(file.string());
        expect_drilled_plate(plate);
        EXPECT_EQ(plate.thickness_mm, 0);
    }
    const auto curves = together({edges_of(largest_face(box({0, 0, 0}, {10, 10, 2}))),
                                  edges_of(largest_face(box({20, 0, 3}, {30, 10, 5})))});
    EXPECT_THAT(error_of(folder.iges("b.igs", curves)),
                HasSubstr("the curves are not in one plane: curve D"));
}

TEST(Plate, RejectsNonPlateAndNamesFace) {
    const SolidFolder folder;
    const auto rejected = [&](const TopoDS_Shape& shape) { return error_of(folder.step("a.step", shape)); };
    EXPECT_THAT(rejected(sphere({1, 2, 3}, 10)),
                HasSubstr("has no planar face; only flat plates can be cut"));
    EXPECT_THAT(rejected(cone({0, 0, 0}, 20, 0, 5)),
                AllOf(HasSubstr("the conical face #"), HasSubstr("belongs to a body without a lower side")));
    const TopoDS_Shape block = box({0, 0, 0}, {50, 40, 10});
    EXPECT_THAT(rejected(without(block, {box({10, 10, 5}, {20, 20, 11})})), HasSubstr("the plane face #"));
    EXPECT_THAT(rejected(without(block, {cylinder({20, 20, 5}, 4, 10)})), HasSubstr(" face #"));
    EXPECT_THAT(
        rejected(without(block, {turned(cylinder({0, 0, 0}, 2, 100), {1, 0, 0}, -kPi / 2, {25, -10, 5})})),
        HasSubstr("the cylindrical face #"));
    EXPECT_THAT(
        rejected(without(block, {turned(cylinder({0, 0, -50}, 5, 100), {1, 0, 0}, 0.3, {25, 20, 5})})),
        AllOf(HasSubstr("the cylindrical face #"),
              HasSubstr("is not straight from the upper to the lower side")));
    EXPECT_THAT(rejected(without(block, {cylinder({50, 40, 10}, 4, 10), box({-1, -1, 8}, {51, 3, 11})})),
                HasSubstr("face #"));
    EXPECT_THAT(rejected(frustum({0, 0, 0}, 60, 40, 20, 38, 10)),
                HasSubstr("is tilted by 63.4 deg; a jet can be tilted by up to 60 deg"));
    EXPECT_THAT(rejected(without(cylinder({0, 0, -20}, 20, 20), {sphere({0, 0, -30}, 18)})),
                HasSubstr("spherical face #"));
    EXPECT_THAT(rejected(box({0, 0, 0}, {6e5, 40, 10})), HasSubstr("coordinates must not exceed 500000 mm"));
}

}  // namespace

}  // namespace gsim::solid::plate_test
