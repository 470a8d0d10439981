// Random programs and a plain evaluator of the same blocks, written a second time: every move ends where its
// block says, stays on its line or arc, and keeps the limits.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>

#include "tests/lua_lib/run.h"

namespace gsim::script::random_programs_test {
namespace {

constexpr int kPrograms = 80;
constexpr int kBlocks = 80;
constexpr int kSamples = 24;
constexpr double kPi = std::numbers::pi;
constexpr double kPath_mm = 1e-6;
constexpr double kRelative = 1e-9;

using Vector5 = Eigen::Matrix<double, 5, 1>;
using Eigen::Vector3d;

constexpr std::array<char, 5> kLetters{'X', 'Y', 'Z', 'B', 'C'};
constexpr std::array<double, 5> kLow{300, 300, 100, -300, -80};
constexpr std::array<double, 5> kHigh{1500, 2000, 500, 300, 80};
constexpr std::array<std::array<int, 3>, 3> kPlanes{
    {{0, 1, 2}, {2, 0, 1}, {1, 2, 0}}};  // first, second, normal

// One move as it must come out, mm and deg.
struct Wanted {
    bool rapid = false, arc = false;
    Vector5 start, end;
    Vector3d center = Vector3d::Zero();
    int plane = 0;
    double radius = 0, turn = 0;  // turn: rad, positive counterclockwise
    double feed_per_s = 0;        // mm/s, or deg/s if only rotary axes move
};

class Generator {
  public:
    explicit Generator(unsigned seed) : random_(seed) {
        position_.setZero();
        for (Vector5& frame : frames_)
            for (int i = 0; i < 5; ++i) frame[i] = round(number(-40, 40));
        g52_.setZero();
        set_feed();
        line(true, 31);
        for (int i = 0; i < kBlocks; ++i) block();
    }

    std::string text;
    std::vector<Wanted> expected_value;
    machine::MachineData data() const {
        machine::MachineData data;
        for (std::size_t f = 0; f < 3; ++f)
            for (std::size_t i = 0; i < 5; ++i)
                data.offsets[std::to_string(54 + f)][kLetters[i]] = frames_[f][static_cast<Eigen::Index>(i)];
        return data;
    }

  private:
    double number(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    int random_integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
    static double round(double value) { return std::round(value * 1e4) / 1e4; }

    void block() {
        switch (random_integer(0, 11)) {
            case 0:
                unit_ = 25.4;
                text += "G20\n";
                break;
            case 1:
                unit_ = 1;
                text += "G21\n";
                break;
            case 2:
                incremental_ = !incremental_;
                text += incremental_ ? "G91\n" : "G90\n";
                break;
            case 3:
                frame_ = static_cast<std::size_t>(random_integer(0, 2));
                text += fmt::format("G{}\n", 54 + frame_);
                break;
            case 4: zero_point(); break;
            case 5: set_feed(); break;
            case 6: line(true, random_integer(1, 31)); break;
            case 7:
            case 8: line(false, random_integer(1, 31)); break;
            default: arc(); break;
        }
    }

    void set_feed() {
        const double f = round(number(200, 8000) / unit_);
        feed_mm_min_ = f * unit_;
        feed_deg_min_ = f;
        text += fmt::format("F{}\n", f);
    }

    void zero_point() {
        const auto axis = static_cast<std::size_t>(random_integer(0, 4));
        const double value = round(number(-30, 30) / (axis < 3 ? unit_ : 1));
        g52_[static_cast<Eigen::Index>(axis)] = value * (axis < 3 ? unit_ : 1);
        text += fmt::format("G52 {}{}\n", kLetters[axis], value);
    }

    // The word that brings an axis to `to`, to the digits that are written; `to` becomes what they mean.
    std::string word(std::size_t axis, double& to) {
        const auto i = static_cast<Eigen::Index>(axis);
        const double unit = axis < 3 ? unit_ : 1;
        const double base = incremental_ ? position_[i] : frames_[frame_][i] + g52_[i];
        const std::string digits = fmt::format("{:.9f}", (to - base) / unit);
        to = base + std::stod(digits) * unit;
        return fmt::format(" {}{}", kLetters[axis], digits);
    }

    void line(bool rapid, int axes) {
        Wanted move;
        move.rapid = rapid;
        move.start = move.end = position_;
        text += rapid ? "G0" : "G1";
        for (std::size_t axis = 0; axis < 5; ++axis) {
            if ((axes >> axis & 1) == 0) continue;
            double to = number(kLow[axis], kHigh[axis]);
            text += word(axis, to);
            move.end[static_cast<Eigen::Index>(axis)] = to;
        }
        text += '\n';
        move.feed_per_s = ((axes & 7) != 0 ? feed_mm_min_ : feed_deg_min_) / 60;
        add(move);
    }

    void arc() {
        Wanted move;
        move.arc = true;
        move.plane = random_integer(0, 2);
        const auto [first, second, normal] = kPlanes[static_cast<std::size_t>(move.plane)];
        move.radius = number(5, 90);
        const double from = number(0, 2 * kPi), sweep = number(0.2, 2 * kPi - 0.2);
        const bool ccw = random_integer(0, 1) == 1;
        move.turn = ccw ? sweep : -sweep;
        move.start = move.end = position_;
        // The centre is written in digits; all else follows from it.
        const std::string i = fmt::format("{:.9f}", -move.radius * std::cos(from) / unit_);
        const std::string j = fmt::format("{:.9f}", -move.radius * std::sin(from) / unit_);
        const Eigen::Vector2d out(-std::stod(i) * unit_, -std::stod(j) * unit_);
        move.radius = out.norm();
        move.center = position_.head<3>();
        move.center[first] -= out[0];
        move.center[second] -= out[1];
        move.end[first] = move.center[first] + std::cos(move.turn) * out[0] - std::sin(move.turn) * out[1];
        move.end[second] = move.center[second] + std::sin(move.turn) * out[0] + std::cos(move.turn) * out[1];
        if (random_integer(0, 2) == 0) move.end[normal] += number(-20, 20);
        if (random_integer(0, 2) == 0) move.end[3] += number(-30, 30);
        if (!fits(move)) return line(false, 31);
        text += fmt::format("G{} G{}", 17 + move.plane, ccw ? 3 : 2);
        for (std::size_t axis = 0; axis < 4; ++axis) {
            const auto n = static_cast<Eigen::Index>(axis);
            if (n == first || n == second || move.end[n] != position_[n]) text += word(axis, move.end[n]);
        }
        static constexpr char kCentre[] = "IJK";
        if (random_integer(0, 2) == 0 && std::abs(sweep - kPi) > 0.2) {
            text += fmt::format(" R{:.9f}\n", (sweep < kPi ? 1 : -1) * move.radius / unit_);
        } else {
            text += fmt::format(" {}{} {}{}\n", kCentre[first], i, kCentre[second], j);
        }
        move.feed_per_s = feed_mm_min_ / 60;
        add(move);
    }

    static bool fits(const Wanted& move) {
        for (int i = 0; i < 3; ++i) {
            if (move.center[i] - move.radius < 40 || move.center[i] + move.radius > (i == 2 ? 570 : 1700))
                return false;
        }
        return std::abs(move.end[3]) < 350 && move.end[2] > 40 && move.end[2] < 570;
    }

    void add(const Wanted& move) {
        expected_value.push_back(move);
        position_ = move.end;
    }

    std::mt19937 random_;
    Vector5 position_, g52_;
    std::array<Vector5, 3> frames_;
    std::size_t frame_ = 0;
    double unit_ = 1, feed_mm_min_ = 0, feed_deg_min_ = 0;
    bool incremental_ = false;
};

// Returns the arc's point after a part of its path, 0 to 1: the angle and the lift both grow in proportion to
// the path.
Vector3d arc_point(const Wanted& move, double part) {
    const auto [first, second, normal] = kPlanes[static_cast<std::size_t>(move.plane)];
    const Vector3d out = move.start.head<3>() - move.center;
    const double angle = move.turn * part;
    Vector3d point = move.center;
    point[first] += std::cos(angle) * out[first] - std::sin(angle) * out[second];
    point[second] += std::sin(angle) * out[first] + std::cos(angle) * out[second];
    point[normal] = move.start[normal] + part * (move.end[normal] - move.start[normal]);
    return point;
}

double move_length(const Wanted& move) {
    if (!move.arc) return (move.end - move.start).head<3>().norm();
    const int normal = kPlanes[static_cast<std::size_t>(move.plane)][2];
    return std::hypot(move.radius * move.turn, move.end[normal] - move.start[normal]);
}

void expect_limits(const Wanted& move, const motion::JointState& state, const machine::Machine& machine) {
    const Vector3d velocity = state.velocity.head<3>(), acceleration = state.acceleration.head<3>();
    const double degrees = 180 / kPi;
    const double rotary_speed = state.velocity.tail<2>().norm() * degrees;
    for (int i = 0; i < 5; ++i) {
        const machine::Axis& axis = machine.axes[static_cast<std::size_t>(i)];
        const double scale = i < 3 ? 1 : degrees;
        ASSERT_LE(std::abs(state.velocity[i]) * scale, axis.max_speed * (1 + kRelative)) << axis.letter;
        if (move.arc && i < 3) continue;
        ASSERT_LE(std::abs(state.acceleration[i]) * scale, axis.max_acceleration * (1 + kRelative))
            << axis.letter;
    }
    if (move.rapid) return;
    const bool turns_alone = move_length(move) == 0;
    ASSERT_LE(turns_alone ? rotary_speed : velocity.norm(),
              std::min(move.feed_per_s, turns_alone ? 1e9 : kFeed_mm_s) * (1 + kRelative));
    if (velocity.norm() > 1e-6) {
        ASSERT_LE(std::abs(acceleration.dot(velocity.normalized())), kAcceleration_mm_s2 * (1 + kRelative));
    }
}

void expect_path(const Wanted& move, const Vector3d& point, double distance_mm) {
    const double length = move_length(move);
    if (move.arc) {
        ASSERT_LT((point - arc_point(move, distance_mm / length)).norm(), kPath_mm);
        return;
    }
    const Vector3d direction =
        length > 0 ? Vector3d((move.end - move.start).head<3>() / length) : Vector3d::Zero();
    const Vector3d from_start = point - move.start.head<3>();
    ASSERT_LT((from_start - from_start.dot(direction) * direction).norm(), kPath_mm);
}

void expect_move(const Wanted& move, const Outcome& r, std::size_t n) {
    const simulation::RecordedMove& recorded = r.moves[n];
    for (std::size_t i = 0; i < 5; ++i)
        ASSERT_NEAR(r.to(n, kLetters[i]), move.end[static_cast<Eigen::Index>(i)], kPath_mm) << kLetters[i];
    ASSERT_NEAR(recorded.length_mm, move_length(move), kPath_mm);
    ASSERT_EQ(recorded.start_s, n == 0 ? 0 : r.moves[n - 1].end_s);
    const motion::Segment& segment = r.segments[n];
    ASSERT_EQ(segment.start_s, recorded.start_s);
    for (int k = 0; k <= kSamples; ++k) {
        const double t_s = segment.duration_s * k / kSamples;
        const motion::JointState state = segment.at(t_s);
        expect_path(move, state.position.head<3>(), segment.length_mm > 0 ? segment.master.at(t_s).s : 0);
        expect_limits(move, state, r.machine);
        if (testing::Test::HasFatalFailure()) return;
    }
}

TEST(RandomPrograms, EachMoveMatchesItsBlockAndKeepsLimits) {
    std::size_t moves = 0;
    for (unsigned seed = 1; seed <= kPrograms; ++seed) {
        const Generator program(seed);
        SCOPED_TRACE(fmt::format("seed {}\n{}", seed, program.text));
        Conditions setup;
        setup.options.data = program.data();
        const Outcome r = run(program.text, setup);
        ASSERT_TRUE(r.completed()) << r.line() << ": " << r.message();
        ASSERT_EQ(r.moves.size(), program.expected_value.size());
        ASSERT_EQ(r.segments.size(), program.expected_value.size());
        for (std::size_t n = 0; n < r.moves.size(); ++n) {
            SCOPED_TRACE(fmt::format("line {}", r.moves[n].info.location.line));
            expect_move(program.expected_value[n], r, n);
            if (HasFatalFailure()) return;
        }
        moves += r.moves.size();
    }
    EXPECT_GT(moves, static_cast<std::size_t>(kPrograms * kBlocks / 3));
}

}  // namespace
}  // namespace gsim::script::random_programs_test
