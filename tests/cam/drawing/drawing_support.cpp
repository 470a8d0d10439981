#include "tests/cam/drawing/drawing_support.h"

#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cam/drawing/dxf_reader.h"
#include "cam/drawing/svg_reader.h"
#include "geometry/planar/chain.h"

namespace gsim::drawing {

std::string groups(Groups list) {
    std::string text;
    for (const auto& [code, value] : list) text += fmt::format("{:3}\n{}\n", code, value);
    return text;
}

std::string section(const std::string& name, const std::string& content) {
    return groups({{0, "SECTION"}, {2, name}}) + content + groups({{0, "ENDSEC"}});
}

std::string dxf_of(const std::string& entities, const std::string& before) {
    return before + section("ENTITIES", entities) + groups({{0, "EOF"}});
}

std::vector<double> areas_of(const Drawing& drawing) {
    const geometry::ChainResult chains = geometry::chain(drawing.drawn_contours, 0.01);
    EXPECT_TRUE(chains.open.empty());
    std::vector<double> areas;
    for (const geometry::Contour& contour : chains.closed) areas.push_back(std::abs(area_mm2(contour)));
    std::sort(areas.begin(), areas.end());
    return areas;
}

Drawing dxf_drawing(const std::string& text, const ReadOptions& options) {
    auto drawing = read_dxf(text, options);
    EXPECT_TRUE(drawing) << drawing.error().message;
    return drawing ? *drawing : Drawing{};
}

Drawing svg_drawing(const std::string& text, const ReadOptions& options) {
    auto drawing = read_svg(text, options);
    EXPECT_TRUE(drawing) << drawing.error().message;
    return drawing ? *drawing : Drawing{};
}

std::string dxf_fault(const std::string& text) {
    const auto drawing = read_dxf(text, {});
    EXPECT_FALSE(drawing);
    return drawing ? "" : drawing.error().message;
}

std::string svg_fault(const std::string& text) {
    const auto drawing = read_svg(text, {});
    EXPECT_FALSE(drawing);
    return drawing ? "" : drawing.error().message;
}

}  // namespace gsim::drawing
