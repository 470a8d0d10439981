// Contours that other programs drew, if their drawings are installed. The areas within their offsets are
// those that the Clipper library computes from points along them.

#include <filesystem>

#include <gtest/gtest.h>

#include "cam/drawing/drawing_file.h"
#include "geometry/planar/chain.h"
#include "geometry/planar/crossing.h"
#include "geometry/planar/offset.h"
#include "tests/geometry/planar/clipper_area.h"

namespace gsim::cutting::foreign_offset_test {

namespace {

namespace fs = std::filesystem;

using geometry::Contour;

// Returns the number of contours of a drawing that were compared.
int compare_offsets(const fs::path& path) {
    constexpr double kKerf_mm = 0.8;
    const auto drawing = drawing::read_drawing(path, {});
    if (!drawing) return 0;  // entities without a size, which are refused
    int count = 0;
    for (Contour& contour : geometry::chain(drawing->drawn_contours, 0.01).closed) {
        if (contour.vertices.size() < 2 || geometry::find_crossing({&contour, 1}, 0.001)) continue;
        if (area_mm2(contour) < 0) reverse(contour);
        if (area_mm2(contour) < 1) continue;
        for (const double distance_mm : {kKerf_mm / 2, -kKerf_mm / 2}) {
            const auto loops = geometry::offset(contour, distance_mm);
            EXPECT_TRUE(loops) << path;
            if (!loops) continue;
            double area = 0;
            for (const Contour& loop : *loops) area += area_mm2(loop);
            EXPECT_NEAR(area, geometry::clipper_offset_area_mm2(contour, distance_mm, 1e-4),
                        1e-3 * area_mm2(contour))
                << path;
        }
        ++count;
    }
    return count;
}

int compare_folder(const fs::path& folder, const std::string& extension, int max) {
    int count = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (count < max && entry.path().extension() == extension) count += compare_offsets(entry.path());
    }
    return count;
}

TEST(ExternalOffset, MatchesClipperForLibreCadLibrary) {
    const fs::path library = "/usr/share/librecad/library";
    if (!fs::exists(library)) GTEST_SKIP() << "librecad-data is not installed";
    EXPECT_GT(compare_folder(library, ".dxf", 2000), 100);
}

TEST(ExternalOffset, MatchesClipperForInkscapeSymbols) {
    const fs::path symbols = "/usr/share/inkscape/symbols";
    if (!fs::exists(symbols)) GTEST_SKIP() << "the symbols of Inkscape are not installed";
    compare_folder(symbols, ".svg", 2000);
}

}  // namespace

}  // namespace gsim::cutting::foreign_offset_test
