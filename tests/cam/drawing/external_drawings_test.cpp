// Drawings of other programs, if those are installed.

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "cam/drawing/drawing_file.h"
#include "tests/cam/drawing/drawing_support.h"

namespace gsim::drawing::foreign_test {

namespace {

namespace fs = std::filesystem;

class ExternalDrawings : public testing::Test {
  protected:
    ExternalDrawings() : folder_(fs::temp_directory_path() / fmt::format("gsim-foreign-{}", ::getpid())) {
        fs::create_directories(folder_);
    }
    ~ExternalDrawings() override { fs::remove_all(folder_); }

    static bool installed(const std::string& program) {
        return std::system(fmt::format("command -v {} >/dev/null", program).c_str()) == 0;
    }
    void run(const std::string& command) const {
        const std::string quiet = fmt::format("cd '{}' && HOME='{}' {} >/dev/null 2>&1", folder_.string(),
                                              folder_.string(), command);
        EXPECT_EQ(std::system(quiet.c_str()), 0) << command;
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }
    Drawing read(const std::string& name) const {
        const auto drawing = read_drawing(folder_ / name, {});
        EXPECT_TRUE(drawing) << drawing.error().message;
        return drawing ? *drawing : Drawing{};
    }

    fs::path folder_;
};

// Returns the area of a polygon in a circle.
double polygon_area(double radius, int corners) {
    return corners * radius * radius / 2 * std::sin(2 * std::numbers::pi / corners);
}

TEST_F(ExternalDrawings, ReadsOpenScadFiles) {
    if (!installed("openscad")) GTEST_SKIP() << "openscad is not installed";
    write("part.scad",
          "difference() { square([80, 50]); translate([20, 25]) circle(r = 10, $fn = 64);"
          " translate([55, 25]) rotate(30) square(12, center = true); }");
    for (const char* name : {"part.dxf", "part.svg"}) {
        run(fmt::format("openscad -o {} part.scad", name));
        EXPECT_THAT(areas_of(read(name)), testing::ElementsAre(testing::DoubleNear(144, 0.1),
                                                               testing::DoubleNear(polygon_area(10, 64), 0.1),
                                                               testing::DoubleNear(4000, 0.1)))
            << name;
    }
}

TEST_F(ExternalDrawings, ReadsInkscapeFile) {
    if (!installed("inkscape")) GTEST_SKIP() << "inkscape is not installed";
    write("part.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' width='80mm' height='50mm' viewBox='0 0 80 50'>"
          "<rect x='5' y='5' width='60' height='40' rx='4'/><circle cx='30' cy='25' r='10' "
          "transform='rotate(20)'/></svg>");
    run("inkscape --actions='select-all;object-to-path' --export-plain-svg --export-filename=out.svg "
        "part.svg");
    EXPECT_THAT(areas_of(read("out.svg")),
                testing::ElementsAre(testing::DoubleNear(100 * std::numbers::pi, 0.1),
                                     testing::DoubleNear(2400 - (4 - std::numbers::pi) * 16, 0.1)));
}

// All parts of LibreCAD are read. Some hold entities without a size, which cannot be cut.
TEST_F(ExternalDrawings, ReadsLibreCadLibrary) {
    const fs::path library = "/usr/share/librecad/library";
    if (!fs::exists(library)) GTEST_SKIP() << "librecad-data is not installed";
    std::size_t count = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(library)) {
        if (entry.path().extension() != ".dxf") continue;
        const auto drawing = read_drawing(entry.path(), {});
        if (!drawing) {
            EXPECT_THAT(drawing.error().message, testing::AnyOf(testing::HasSubstr("has no length"),
                                                                testing::HasSubstr("has the radius 0")));
            continue;
        }
        ++count;
    }
    EXPECT_GT(count, 100U);
}

}  // namespace

}  // namespace gsim::drawing::foreign_test
