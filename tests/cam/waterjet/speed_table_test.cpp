// Table 2.1 of the thesis: speeds for 50 mm. It gives neither the jet nor the edge, so a jet of its time is
// assumed, and the fastest cut. The assumption decides by a row more or less; the ratios of the rows are the
// model's own.
#include <cmath>

#include <gtest/gtest.h>

#include "sample.h"

namespace gsim::waterjet::table_of_speeds_test {
namespace {

struct Row {
    const char* material;
    double speed_mm_min;
    double ratio;  // of the model's speed to the table's, as docs/waterjet.md has it
};

constexpr Row kTable[] = {
    {"17-4PH stainless steel", 51, 1.05},
    {"HY-80 steel", 51, 1.14},
    {"titanium", 51, 1.55},
    {"nickel-chromium superalloy", 51, 1.05},
    {"aluminum", 102, 1.58},
    {"lead", 457, 0.92},
    {"glass", 457, 1.15},
};

// 50 kpsi, 0.012 in, 0.036 in, 0.6 lb/min.
CuttingRequest make_request(const Row& row) {
    CuttingRequest request;
    request.material = row.material;
    request.thickness_mm = 50;
    request.quality = 1;
    request.pressure_mpa = 345;
    request.orifice_mm = 0.30;
    request.mixing_tube_mm = 0.91;
    request.abrasive_g_min = 272;
    return request;
}

TEST(SpeedTable, EachRowIsWithinExpectedFactor) {
    for (const Row& row : kTable) {
        const double speed = plan_cutting(sample_materials(), make_request(row)).value().cutting_speed_mm_min;
        EXPECT_NEAR(speed / row.speed_mm_min, row.ratio, 0.01) << row.material;
        EXPECT_LT(std::abs(std::log(speed / row.speed_mm_min)), std::log(1.6)) << row.material;
    }
}

}  // namespace
}  // namespace gsim::waterjet::table_of_speeds_test
