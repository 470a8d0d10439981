// Random paths: moves that leave the model early have the speeds that they would have with the complete path
// known.

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/motion/klipper/klipper_path.h"

namespace gsim::motion::klipper_random_test {
namespace {

/// A move of the path as the rules see it, speeds squared.
struct Step {
    Eigen::Vector3d along;
    double length, speed2, acceleration, gentle;  // the last one: of the second plan
    double cap2 = 0, gentle_cap2 = 0;
};

struct Speeds {
    double start, cruise, end;
};

/// Klipper's rules over a complete path at once, written for this test: entries of both plans from the end.
/// Then come, forward, the groups of moves that rise and fall together, each with its peak.
class WholePath {
  public:
    WholePath(const std::vector<Step>& steps, double corner_mm_s, double path_acceleration)
        : steps_(steps), deviation_(corner_mm_s * corner_mm_s * (std::sqrt(2.0) - 1) / path_acceleration) {
        for (std::size_t i = 1; i < steps_.size(); ++i) set_caps(i);
    }

    std::vector<Speeds> speeds() const {
        const std::size_t n = steps_.size();
        std::vector<double> entry(n + 1, 0), gentle(n + 1, 0);
        for (std::size_t i = n; i-- > 0;) {
            entry[i] = std::min(steps_[i].cap2, entry[i + 1] + rise(i));
            gentle[i] = std::min(steps_[i].gentle_cap2, gentle[i + 1] + gentle_rise(i));
        }
        std::vector<Speeds> speeds(n);
        double before = 0;
        for (std::size_t i = 0; i < n; ++i) {
            double cruise = std::min(before, entry[i]);
            if (rises(gentle, i)) {
                std::size_t top = i;  // the nearest move from here on at which the rise ends
                while (!ends_rise(gentle, top)) ++top;
                const double peak = (gentle[top] + gentle[top + 1] + gentle_rise(top)) / 2;
                cruise = std::min({peak, steps_[i].speed2, (entry[i] + entry[i + 1] + rise(i)) / 2});
            }
            speeds[i] = {std::sqrt(std::min(entry[i], cruise)), std::sqrt(cruise),
                         std::sqrt(std::min(entry[i + 1], cruise))};
            before = cruise;
        }
        return speeds;
    }

  private:
    double rise(std::size_t i) const { return 2 * steps_[i].length * steps_[i].acceleration; }
    double gentle_rise(std::size_t i) const { return 2 * steps_[i].length * steps_[i].gentle; }
    bool rises(const std::vector<double>& gentle, std::size_t i) const {
        return gentle[i] < gentle[i + 1] + gentle_rise(i);
    }
    bool ends_rise(const std::vector<double>& gentle, std::size_t i) const {
        if (!rises(gentle, i)) return false;
        const bool falls_behind = i + 1 < steps_.size() && !rises(gentle, i + 1);
        return falls_behind || gentle[i] + gentle_rise(i) > gentle[i + 1];
    }
    void set_caps(std::size_t i) {
        Step& to = steps_[i];
        const Step& from = steps_[i - 1];
        const double cosine = -from.along.dot(to.along);
        const double s = std::sqrt(std::max(0.0, (1 - cosine) / 2));
        const double k = std::sqrt(std::max(0.0, (1 + cosine) / 2));
        to.cap2 = std::min({to.speed2, from.speed2, from.cap2 + rise(i - 1)});
        if (s < 1 && k > 0) {
            for (const std::size_t one : {i - 1, i}) {
                to.cap2 = std::min(to.cap2, deviation_ * steps_[one].acceleration * s / (1 - s));
                to.cap2 = std::min(to.cap2, rise(one) * 0.25 * s / k);
            }
        }
        to.gentle_cap2 = std::min(to.cap2, from.gentle_cap2 + gentle_rise(i - 1));
    }

    std::vector<Step> steps_;
    double deviation_;
};

class RandomPath {
  public:
    explicit RandomPath(unsigned seed) : random_(seed) {
        path_.setup().controller.klipper.minimum_cruise_ratio = chance(0.2) ? 0 : 0.95 * share();
        path_.setup().controller.klipper.square_corner_velocity_mm_s = 20 * share();
        size_ = std::pow(10, 4 * share() - 3);
        bend_ = std::pow(10, 4 * share() - 4);
        climbs_ = chance(0.3);
    }

    void go(int count) {
        for (int i = 0; i < count; ++i) step();
        path_.standstill();
    }
    const KlipperPath& path() const { return path_; }
    std::vector<Speeds> expected_value() {
        const rrs::ControllerRules& rules = path_.setup().controller;
        return WholePath(steps_, rules.klipper.square_corner_velocity_mm_s, 1000).speeds();
    }

  private:
    double share() { return std::uniform_real_distribution<double>(0, 1)(random_); }
    bool chance(double share) { return std::bernoulli_distribution(share)(random_); }

    void step() {
        if (chance(0.02)) size_ = std::pow(10, 4 * share() - 3);
        if (chance(0.1)) speed_ = 200 * share() + 0.1;
        heading_ += chance(0.03) ? 2 * kPi * share() : bend_ * (share() - 0.3);
        const double length = size_ * (0.2 + share());
        const Eigen::Vector3d displacement(length * std::cos(heading_), length * std::sin(heading_),
                                           climbs_ && chance(0.3) ? length * (share() - 0.5) : 0);
        const Eigen::Vector3d from = path_.position();
        path_.line(rrs::JointPos(from + displacement), speed_);
        const Eigen::Vector3d gone = path_.position() - rrs::JointPos(from);
        add(gone);
    }

    void add(const Eigen::Vector3d& displacement) {
        const double length = displacement.norm();
        const double ascent = std::abs(displacement.z()) / length;
        Step step{displacement / length, length, 0, 1000, 0};
        double speed = std::min(speed_, 100.0);
        if (ascent > 0) {
            speed = std::min(speed, 20 / ascent);
            step.acceleration = std::min(1000.0, 200 / ascent);
        }
        step.speed2 = speed * speed;
        step.gentle =
            std::min(step.acceleration, 1000 * (1 - path_.setup().controller.klipper.minimum_cruise_ratio));
        steps_.push_back(step);
    }

    std::mt19937 random_;
    KlipperPath path_;
    std::vector<Step> steps_;
    double size_ = 1, bend_ = 0.01, heading_ = 0, speed_ = 80;
    bool climbs_ = false;
};

TEST(KlipperRandom, SpeedsEqualThoseOfCompletePath) {
    for (unsigned seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        RandomPath run(seed);
        run.go(600);
        const std::vector<Speeds> expected_value = run.expected_value();
        const auto& segments = run.path().segments();
        ASSERT_EQ(segments.size(), expected_value.size());
        double time_s = 0;
        for (std::size_t i = 0; i < expected_value.size(); ++i) {
            ASSERT_NEAR(segments[i].master.start_speed(), expected_value[i].start, 1e-6) << i;
            ASSERT_NEAR(segments[i].master.peak_speed(), expected_value[i].cruise, 1e-6) << i;
            ASSERT_NEAR(segments[i].master.end_speed(), expected_value[i].end, 1e-6) << i;
            const double a = segments[i].master_limits.acceleration;
            const auto& [start, cruise, end] = expected_value[i];
            const double displacement =
                segments[i].length_mm - (2 * cruise * cruise - start * start - end * end) / 2 / a;
            time_s += (2 * cruise - start - end) / a + displacement / cruise;
        }
        ASSERT_NEAR(run.path().time_s(), time_s, 1e-7 * time_s);
    }
}

// Moves of a long path leave the model during planning.
TEST(KlipperRandom, BuffersOnlyFewMovesOfLongPath) {
    KlipperPath path;
    for (int i = 1; i <= 20'000; ++i) {
        const double angle = i * 0.001;
        path.line(50 * std::sin(angle), 50 * (1 - std::cos(angle)));
        const std::size_t pending = static_cast<std::size_t>(i) - path.segments().size();
        ASSERT_LT(pending, 1000u) << i;  // 10 mm to brake on at 0.05 mm each
    }
}

}  // namespace
}  // namespace gsim::motion::klipper_random_test
