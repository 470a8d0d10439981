// Drawings with bytes changed, left out and doubled: they are read or rejected, without any other effect.

#include <random>

#include <gtest/gtest.h>

#include "cam/drawing/dxf_reader.h"
#include "cam/drawing/svg_reader.h"
#include "geometry/planar/chain.h"
#include "tests/cam/drawing/drawing_support.h"

namespace gsim::drawing::mangled_drawing_test {

namespace {

const std::string kSvg = R"svg(<svg width="100mm" height="50mm" viewBox="0 0 100 50">
<g transform="translate(1,2) rotate(30)"><path d="M0 0H10V10A5 5 0 0 1 0 10C1 2 3 4 5 6Z"/></g>
<rect x="3" y="4" width="5" height="6" rx="2"/><use href="#c"/><circle id="c" r="3"/></svg>)svg";

std::string dxf() {
    return dxf_of(groups({{0, "LWPOLYLINE"},
                          {90, "3"},
                          {70, "1"},
                          {10, "0"},
                          {20, "0"},
                          {42, "0.5"},
                          {10, "9"},
                          {20, "1"},
                          {10, "5"},
                          {20, "7"},
                          {0, "INSERT"},
                          {2, "b"},
                          {10, "3"},
                          {20, "4"},
                          {41, "2"},
                          {50, "30"},
                          {70, "2"},
                          {44, "9"}}),
                  section("BLOCKS", groups({{0, "BLOCK"},
                                            {2, "b"},
                                            {10, "0"},
                                            {20, "0"},
                                            {0, "ARC"},
                                            {10, "0"},
                                            {20, "0"},
                                            {40, "2"},
                                            {50, "10"},
                                            {51, "200"},
                                            {0, "ELLIPSE"},
                                            {10, "0"},
                                            {20, "0"},
                                            {11, "3"},
                                            {21, "1"},
                                            {40, "0.3"},
                                            {0, "ENDBLK"}})));
}

std::string mangled(std::string text, std::mt19937& random) {
    static const std::string kBytes = std::string("09-.e\n <>\"/Mz,") + '\0' + '\xff';
    for (unsigned i = 0; i <= random() % 4; ++i) {
        const std::size_t at = random() % text.size();
        switch (random() % 4) {
            case 0: text[at] = kBytes[random() % kBytes.size()]; break;
            case 1: text.insert(at, 1, kBytes[random() % kBytes.size()]); break;
            case 2: text.erase(at, 1 + random() % 8); break;
            default: text.insert(at, text.substr(random() % text.size(), random() % 40)); break;
        }
        if (text.empty()) return text;
    }
    return text;
}

void expect_sound(const Result<Drawing>& drawing) {
    if (!drawing) {
        EXPECT_FALSE(drawing.error().message.empty());
        return;
    }
    for (const geometry::Contour& drawn_contour : drawing->drawn_contours) {
        for (const geometry::Vertex& vertex : drawn_contour.vertices) {
            ASSERT_TRUE(is_finite(vertex.position));
            ASSERT_LE(std::abs(vertex.bulge), 1 + 1e-9);
            ASSERT_LT(vertex.source, drawing->entities.size());
        }
    }
    geometry::chain(drawing->drawn_contours, 0.01);
}

TEST(CorruptDrawing, IsReadOrRejected) {
    std::mt19937 random(71);
    const std::string plain = dxf();
    for (int i = 0; i < 3000; ++i) {
        expect_sound(read_dxf(mangled(plain, random), {}));
        expect_sound(read_svg(mangled(kSvg, random), {}));
    }
}

}  // namespace

}  // namespace gsim::drawing::mangled_drawing_test
