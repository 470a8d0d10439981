#include "geometry/mesh/mesh.h"

#include <cmath>
#include <map>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cam/solid/solids.h"

namespace gsim::solid::mesh_test {

namespace {

using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

Mesh read_solid_mesh(const std::filesystem::path& file, double tolerance_mm = 0.05) {
    auto mesh = read_mesh(file, tolerance_mm);
    EXPECT_TRUE(mesh) << mesh.error().message;
    return mesh ? *std::move(mesh) : Mesh{};
}

std::string error_of(const std::filesystem::path& file) {
    const auto mesh = read_mesh(file, 0.05);
    return mesh ? "" : mesh.error().message;
}

// Returns the volume by the divergence theorem; above 0 if the triangles face outwards.
double volume_mm3(const Mesh& mesh) {
    double sum = 0;
    for (const auto& corners : mesh.triangles) {
        const auto& [ax, ay, az] = mesh.vertices_mm[corners[0]];
        const auto& [bx, by, bz] = mesh.vertices_mm[corners[1]];
        const auto& [cx, cy, cz] = mesh.vertices_mm[corners[2]];
        sum += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
    }
    return sum / 6;
}

// Each edge of a closed surface is gone along once in each sense.
bool is_watertight(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const auto& corners : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) ++sides[{corners[i], corners[(i + 1) % 3]}];
    }
    for (const auto& [side, count] : sides) {
        const auto back = sides.find({side.second, side.first});
        if (count != 1 || back == sides.end()) return false;
    }
    return !sides.empty();
}

TopoDS_Shape drilled_plate() {
    return without(box({0, 0, -10}, {80, 50, 0}),
                   {cylinder({20, 25, -11}, 8, 12), cone({55, 25, -10.0001}, 6, 12, 10.0002)});
}

// A frustum of a cone: pi h (R^2 + R r + r^2) / 3.
const double kDrilledVolume = 80 * 50 * 10 - kPi * 64 * 10 - kPi * 10 * (36 + 72 + 144) / 3.0;

TEST(SolidMesh, KeepsVolumeAndIsWatertight) {
    const SolidFolder folder;
    for (const auto& file :
         {folder.step("plate.step", drilled_plate()), folder.step("plate.STP", drilled_plate()),
          folder.iges("plate.igs", drilled_plate())}) {
        const Mesh mesh = read_solid_mesh(file, 0.005);
        EXPECT_TRUE(is_watertight(mesh)) << file;
        EXPECT_NEAR(volume_mm3(mesh), kDrilledVolume, 1e-3 * kDrilledVolume) << file;
    }
}

TEST(SolidMesh, StaysWithinTolerance) {
    const SolidFolder folder;
    const auto file = folder.step("ball.step", sphere({1, 2, 3}, 40));
    for (const double tolerance : {0.5, 0.05}) {
        const Mesh mesh = read_solid_mesh(file, tolerance);
        double furthest = 0;
        for (const auto& corners : mesh.triangles) {
            Position middle{-1, -2, -3};
            for (const std::uint32_t corner : corners) {
                for (std::size_t i = 0; i < 3; ++i) middle[i] += mesh.vertices_mm[corner][i] / 3;
            }
            furthest = std::max(furthest, 40 - std::hypot(middle[0], middle[1], middle[2]));
        }
        EXPECT_LE(furthest, tolerance);
        EXPECT_TRUE(is_watertight(mesh));
    }
}

TEST(SolidMesh, ConvertsFileUnitsToMm) {
    const SolidFolder folder;
    const TopoDS_Shape body = box({0, 0, 0}, {10, 20, 30});
    for (const auto& file : {folder.step("inch.step", body, "INCH"), folder.step("m.step", body, "M"),
                             folder.iges("inch.iges", body, "INCH")})
        EXPECT_NEAR(volume_mm3(read_solid_mesh(file)), 6000, 1e-3) << file;
    const std::string text = read_file(folder.path("inch.step"));
    EXPECT_THAT(text, HasSubstr("INCH"));
}

TEST(SolidMesh, ReadsSeveralAndRotatedBodies) {
    const SolidFolder folder;
    const TopoDS_Shape body = box({0, 0, 0}, {10, 20, 30});
    const auto file = folder.step("two.step", together({body, turned(body, {1, 2, 3}, 1, {100, 0, 0})}));
    const Mesh mesh = read_solid_mesh(file);
    EXPECT_NEAR(volume_mm3(mesh), 12000, 1e-6);
    EXPECT_TRUE(is_watertight(mesh));
}

TEST(SolidMesh, ReportsErrorsOfFile) {
    const SolidFolder folder;
    EXPECT_THAT(error_of(folder.path("none.step")), HasSubstr("none.step': No such file"));
    EXPECT_THAT(error_of(folder.path("")), HasSubstr("it is not a regular file"));
    EXPECT_THAT(error_of(folder.write("a.step", "")), HasSubstr("a.step: the file is empty"));
    EXPECT_THAT(error_of(folder.write("a.step", "solid\n")),
                HasSubstr("this is not a STEP file: it does not begin with 'ISO-10303-21;'"));
    EXPECT_THAT(error_of(folder.write("a.iges", "solid\n")),
                HasSubstr("this is not an IGES file (fixed format): the first line has no 'S' in column 73"));
    const std::string step = read_file(folder.step("a.step", drilled_plate()));
    const std::string iges = read_file(folder.iges("a.iges", drilled_plate()));
    EXPECT_THAT(error_of(folder.write("b.step", step.substr(0, step.size() / 2))),
                HasSubstr("the file is truncated: it does not end with 'END-ISO-10303-21;'"));
    EXPECT_THAT(error_of(folder.write("b.iges", iges.substr(0, iges.size() / 2))),
                HasSubstr("the file is truncated: the last line has no 'T' in column 73"));
    std::string with_nul = step;
    with_nul[with_nul.find("DATA;")] = '\0';
    EXPECT_THAT(error_of(folder.write("c.step", with_nul)), HasSubstr("line 9 contains a NUL byte"));
    EXPECT_THAT(error_of(folder.write(
                    "d.step", "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n")),
                HasSubstr("d.step"));
    std::filesystem::resize_file(folder.write("e.step", step), std::uintmax_t{300} << 20U);
    EXPECT_THAT(error_of(folder.path("e.step")), HasSubstr("larger than 256 MiB"));
}

}  // namespace

}  // namespace gsim::solid::mesh_test
