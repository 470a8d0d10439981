// Blanks that are engraved on the moving belt (samples/cell/cell.lua), compared with times and positions from
// geometry.

#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <vector>

#include "base/text/json.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::belt_test {
namespace {

using nlohmann::json;
using ConveyorTracking = Apps;

// The conveyor and the right gantry, 1000 mm further on (robots.toml, router3.toml).
constexpr double kBelt_mm_s = 20;
constexpr double kBase_mm = 1000;
constexpr double kCatch_mm = 950;  // travel of a blank when the gantry starts to follow the belt
constexpr double kAcceleration_mm_s2 = 500;
constexpr double kRapid_mm_s = 150;
constexpr double kFeed_mm_s = 100;
constexpr double kTakeUp_s = kBelt_mm_s / kAcceleration_mm_s2;  // from standstill to the belt's speed
constexpr double kCorner_mm = 100;                              // X and Y of the blank where it is laid
constexpr double kTime_s = 1e-8;                                // reports have nine decimals

struct Stroke {
    int line;                                       // of cell.lua
    double from_x_mm, from_y_mm, to_x_mm, to_y_mm;  // on the blank, from its corner

    double length_mm() const { return std::hypot(to_x_mm - from_x_mm, to_y_mm - from_y_mm); }
};
constexpr std::array<Stroke, 4> kStrokes{
    {{35, 20, 20, 80, 20}, {36, 80, 20, 80, 40}, {37, 80, 40, 20, 40}, {38, 20, 40, 20, 20}}};

double rest_to_rest_s(double distance_mm, double speed_mm_s) {
    return distance_mm / speed_mm_s + speed_mm_s / kAcceleration_mm_s2;
}

// Returns the distance of a motion from standstill to standstill after a time.
double way_after(double t_s, double distance_mm, double speed_mm_s) {
    const double total_s = rest_to_rest_s(distance_mm, speed_mm_s);
    const double ramp_s = speed_mm_s / kAcceleration_mm_s2;
    if (t_s > total_s / 2) return distance_mm - way_after(total_s - t_s, distance_mm, speed_mm_s);
    if (t_s < ramp_s) return kAcceleration_mm_s2 * t_s * t_s / 2;
    return speed_mm_s * (t_s - ramp_s / 2);
}

/// A run of the sample, with what its right gantry has done.
class BeltRun {
  public:
    explicit BeltRun(const Ended& ended) : report_(text::parse_json<json>(ended.out)) {
        for (const json& signal : report_["signals"]) {
            const std::string name = signal["signal"];
            if (name.rfind("laid", 0) != 0) continue;
            laid_mm_.push_back(std::stod(signal["value"].get<std::string>()));
            EXPECT_NEAR(laid_mm_.back(), kBelt_mm_s * signal["t_s"].get<double>(), 1e-4) << name;
        }
    }
    const std::vector<double>& laid_mm() const { return laid_mm_; }
    double caught_s(std::size_t blank) const { return (laid_mm_[blank] + kCatch_mm) / kBelt_mm_s; }

  private:
    json report_;
    std::vector<double> laid_mm_;  ///< Travel of the belt when each blank was laid on it.
};

// When the strokes of a blank begin, the first one and so on, and when the last one ends.
std::array<double, 5> stroke_times(double caught_s) {
    std::array<double, 5> times{caught_s + kTakeUp_s + rest_to_rest_s(kCorner_mm + 20, kRapid_mm_s)};
    for (std::size_t i = 0; i < kStrokes.size(); ++i)
        times[i + 1] = times[i] + rest_to_rest_s(kStrokes[i].length_mm(), kFeed_mm_s);
    return times;
}

std::vector<std::string> sample(std::vector<std::string> more) {
    const std::string folder = tests::source_path("samples/cell/");
    more.insert(more.end(), {"--robots", folder + "robots.toml", folder + "cell.lua", "--json"});
    return more;
}

TEST_F(ConveyorTracking, EngravesEachBlankAtComputedTime) {
    const Ended ended = gsim_run(sample({"--moves", "m.jsonl"}));
    ASSERT_EQ(ended.status, 0) << ended.err;
    const BeltRun run(ended);
    ASSERT_EQ(run.laid_mm().size(), 3U);
    std::istringstream moves(read("m.right.jsonl"));
    std::map<int, std::vector<json>> by_line;
    for (std::string line; std::getline(moves, line);) {
        json move = text::parse_json<json>(line);
        if (move["kind"] == "linear") by_line[move["line"]].push_back(std::move(move));
    }
    for (std::size_t blank = 0; blank < 3; ++blank) {
        const std::array<double, 5> times = stroke_times(run.caught_s(blank));
        for (std::size_t i = 0; i < kStrokes.size(); ++i) {
            ASSERT_EQ(by_line[kStrokes[i].line].size(), 3U);
            const json& move = by_line[kStrokes[i].line][blank];
            EXPECT_NEAR(move["start_s"].get<double>(), times[i], 1e-5) << blank;  // by the signal's digits
            EXPECT_NEAR(move["end_s"].get<double>() - move["start_s"].get<double>(), times[i + 1] - times[i],
                        kTime_s);
        }
    }
}

// In the world the blank has moved as far as the belt since it was laid. On the blank the tool moves from
// standstill to standstill.
TEST_F(ConveyorTracking, ToolFollowsStrokesOnMovingBlank) {
    const Ended ended = gsim_run(sample({"--trajectory", "t.csv", "--step", "0.01"}));
    ASSERT_EQ(ended.status, 0) << ended.err;
    const BeltRun run(ended);
    std::istringstream rows(read("t.right.csv"));
    std::string row;
    std::getline(rows, row);
    ASSERT_EQ(row, "t_s,line,x_mm,y_mm,z_mm,speed_mm_s");
    int checked_bodies = 0;
    while (std::getline(rows, row)) {
        double t_s = 0, line = 0, x_mm = 0, y_mm = 0;
        char comma = 0;
        std::istringstream(row) >> t_s >> comma >> line >> comma >> x_mm >> comma >> y_mm;
        for (std::size_t blank = 0; blank < 3; ++blank) {
            const std::array<double, 5> times = stroke_times(run.caught_s(blank));
            for (std::size_t i = 0; i < kStrokes.size(); ++i) {
                if (t_s < times[i] || t_s > times[i + 1]) continue;
                const Stroke& stroke = kStrokes[i];
                const double share =
                    way_after(t_s - times[i], stroke.length_mm(), kFeed_mm_s) / stroke.length_mm();
                const double travelled_mm = kBelt_mm_s * t_s - run.laid_mm()[blank];
                EXPECT_NEAR(kBase_mm + x_mm - kCorner_mm - travelled_mm,
                            stroke.from_x_mm + share * (stroke.to_x_mm - stroke.from_x_mm), 1e-3)
                    << t_s;
                EXPECT_NEAR(y_mm - kCorner_mm, stroke.from_y_mm + share * (stroke.to_y_mm - stroke.from_y_mm),
                            1e-3)
                    << t_s;
                ++checked_bodies;
            }
        }
    }
    EXPECT_GT(checked_bodies, 3 * 2.4 / 0.01 - 20);
}

}  // namespace
}  // namespace gsim::apps::belt_test
