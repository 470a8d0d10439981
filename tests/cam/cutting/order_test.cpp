#include "cam/cutting/order.h"

#include <gtest/gtest.h>

#include "tests/cam/cutting/cut_path.h"
#include "tests/geometry/planar/shapes.h"

namespace gsim::cutting::order_test {

namespace {

using geometry::Contour;

TEST(Order, CutsInnerContoursFirst) {
    std::mt19937 random(51);
    std::vector<Contour> contours;
    for (int x = 0; x < 4; ++x) {
        for (int y = 0; y < 4; ++y) {
            const geometry::Point at{60.0 * x, 60.0 * y};
            contours.push_back(geometry::rectangle(at, at + geometry::Point{50, 50}));
            contours.push_back(geometry::circle(at + geometry::Point{25, 25}, 15));
            contours.push_back(geometry::circle(at + geometry::Point{25, 25}, 8));
            contours.push_back(geometry::circle(at + geometry::Point{5, 5}, 2));
        }
    }
    std::shuffle(contours.begin(), contours.end(), random);
    const auto layout = make_layout(drawing_of(contours), {1, 0.02});
    ASSERT_TRUE(layout) << layout.error().message;
    const std::vector<Cut> cuts = add_leads(*layout, 1, 3);
    const std::vector<std::size_t> order = cutting_order(*layout, cuts, {0, 0});
    ASSERT_EQ(order.size(), cuts.size());
    std::vector<bool> cut(layout->outlines.size(), false);
    for (const std::size_t i : order) {
        for (std::size_t other = 0; other < layout->outlines.size(); ++other) {
            if (layout->outlines[other].parent == cuts[i].outline) {
                EXPECT_TRUE(cut[other]);
            }
        }
        cut[cuts[i].outline] = true;
    }
}

}  // namespace

}  // namespace gsim::cutting::order_test
