// Whatever is done to a file, it is read or refused with its name; what is read is finite.

#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cam/solid/contours.h"
#include "cam/solid/plate.h"
#include "geometry/mesh/mesh.h"
#include "tests/cam/solid/solids.h"

namespace gsim::solid::mangled_solid_test {

namespace {

using testing::HasSubstr;

std::size_t any(std::mt19937& random, std::size_t below) {
    return std::uniform_int_distribution<std::size_t>(0, below - 1)(random);
}

std::string mangled(std::string text, std::mt19937& random) {
    const std::vector<std::string> words = {"1E999", "#1", "$", "-1", "nan", "(", "99999999999", "''", ";"};
    for (std::size_t change = 0; change <= any(random, 4); ++change) {
        const std::size_t from = 1000 + any(random, text.size() - 2000);
        const std::string& word = words[any(random, words.size())];
        if (any(random, 3) == 0) {
            text.erase(from, any(random, 40));
        } else {
            text.replace(from, word.size(), word);
        }
    }
    return text;
}

void expect_sound(const Result<Mesh>& mesh, const std::string& name) {
    if (!mesh) {
        EXPECT_THAT(mesh.error().message, HasSubstr(name));
        return;
    }
    for (const auto& vertex : mesh->vertices_mm) {
        for (const double coordinate : vertex) ASSERT_TRUE(std::isfinite(coordinate));
    }
}

void expect_sound(const Result<Plate>& plate, const std::string& name) {
    if (!plate) {
        EXPECT_THAT(plate.error().message, HasSubstr(name));
        return;
    }
    for (const geometry::Contour& drawn_contour : plate->drawing.drawn_contours) {
        for (const geometry::Vertex& vertex : drawn_contour.vertices) ASSERT_TRUE(is_finite(vertex.position));
    }
}

void expect_sound(const Result<WallContours>& part, const std::string& name) {
    if (!part) {
        EXPECT_THAT(part.error().message, HasSubstr(name));
        return;
    }
    for (const WallContour& contour : part->contours) {
        for (const WallEdge& edge : contour.edges) {
            ASSERT_GE(edge.points.size(), 2U);
            for (const WallPoint& point : edge.points) {
                for (const double coordinate : point.position_mm) ASSERT_TRUE(std::isfinite(coordinate));
            }
        }
    }
}

TEST(CorruptSolid, IsReadOrRejectedWithFileName) {
    const SolidFolder folder;
    std::mt19937 random(20);
    const TopoDS_Shape body = without(box({0, 0, -10}, {80, 50, 0}),
                                      {cylinder({20, 25, -11}, 8, 12), cone({55, 25, -15}, 4, 10, 20)});
    const std::vector<std::pair<std::string, std::string>> files = {
        {"a.step", read_file(folder.step("a.step", body))},
        {"a.iges", read_file(folder.iges("a.iges", body))}};
    for (int i = 0; i < 12; ++i) {
        SCOPED_TRACE(i);
        const auto& [name, full] = files[static_cast<std::size_t>(i) % 2];
        const auto file = folder.write(name, mangled(full, random));
        if (any(random, 2) == 0) {
            expect_sound(read_mesh(file, 0.5), name);
        } else {
            expect_sound(read_plate(file, {}), name);
            expect_sound(read_contours(file, {}), name);
            expect_sound(read_contours(file, {.kind = "edges", .edges = {"21"}}), name);
        }
    }
}

}  // namespace

}  // namespace gsim::solid::mangled_solid_test
