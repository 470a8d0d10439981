#include "studio/engine/series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/studio/engine/frames.h"

namespace gsim::studio {
namespace {

constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();

Frame frame_of(const Series& series) {
    Message message("series");
    series.add_columns(message);
    return read_frame(message.bytes());
}

TEST(Series, KeepsSamplesBelowLimit) {
    Series series(2, 8);
    EXPECT_TRUE(series.empty());
    series.add(0, std::array{1.0F, 2.0F});
    series.add(0.5, std::array{3.0F, kNoValue});
    EXPECT_FALSE(series.empty());
    const Frame frame = frame_of(series);
    EXPECT_EQ(frame.header["step_s"], 0);
    EXPECT_EQ(frame.column<double>("t_s"), (std::vector<double>{0, 0.5}));
    const auto values = frame.column<float>("values");
    EXPECT_EQ(std::vector(values.begin(), values.begin() + 3), (std::vector<float>{1, 2, 3}));
    EXPECT_TRUE(std::isnan(values[3]));
}

// A saw of a second, up by 1 and down at once, and a peak of no time in it.
TEST(Series, ReductionKeepsPeaksAndAddsNone) {
    Series series(1, 16);
    for (int second = 0; second < 1000; ++second) {
        series.add(second, std::array{0.0F});
        if (second == 700) {
            for (const float value : {0.5F, 9.0F, 0.5F}) series.add(700.5, std::array{value});
        }
        series.add(second + 1, std::array{1.0F});
    }
    const Frame frame = frame_of(series);
    const double step_s = frame.header["step_s"];
    const auto low = frame.column<float>("low");
    const auto high = frame.column<float>("high");
    ASSERT_LE(low.size(), 8U);
    ASSERT_EQ(low.size(), high.size());
    EXPECT_GE(step_s * static_cast<double>(low.size()), 1000);
    for (std::size_t step = 0; step + 1 < low.size(); ++step) {
        const bool has_peak = step == static_cast<std::size_t>(700.5 / step_s);
        EXPECT_EQ(low[step], 0) << step;
        EXPECT_EQ(high[step], has_peak ? 9 : 1) << step;
    }
}

// A long straight part has in each step its value there.
TEST(Series, InterpolatesStepsWithoutSamples) {
    Series series(1, 8);
    for (int i = 0; i <= 8; ++i) series.add(0.001 * i, std::array{0.0F});
    series.add(0.008, std::array{0.0F});
    series.add(1000.008, std::array{1000.0F});
    const Frame frame = frame_of(series);
    const double step_s = frame.header["step_s"];
    const auto low = frame.column<float>("low");
    const auto high = frame.column<float>("high");
    ASSERT_GE(low.size(), 3U);
    for (std::size_t step = 0; step < low.size(); ++step) {
        const double from_s = step_s * static_cast<double>(step);
        EXPECT_NEAR(low[step], std::max(from_s - 0.008, 0.0), 1e-3) << step;
        EXPECT_NEAR(high[step], std::min(from_s + step_s, 1000.008) - 0.008, 1e-3) << step;
    }
}

TEST(Series, KeepsGapsWithoutValues) {
    Series series(1, 4);
    for (const double t_s : {0.0, 1.0, 2.0, 3.0}) series.add(t_s, std::array{5.0F});
    series.add(4, std::array{kNoValue});
    series.add(100, std::array{kNoValue});
    const Frame frame = frame_of(series);
    const auto high = frame.column<float>("high");
    EXPECT_EQ(high.front(), 5);
    EXPECT_TRUE(std::isnan(high.back()));
}

}  // namespace
}  // namespace gsim::studio
