#include "tests/lua_lib/roundtrip/roundtrip_control.h"

#include <cmath>
#include <numbers>

namespace gsim::roundtrip {

namespace {

using Eigen::Vector2d;

constexpr double kTurn_rad = 2 * std::numbers::pi;
constexpr double kSecondsPerMinute = 60;
constexpr std::array<char, 3> kCentreWords{'I', 'J', 'K'};

// The angle from a to b in the sense of travel, above 0 and up to a turn.
double sweep_angle(const Vector2d& a, const Vector2d& b, bool ccw) {
    double angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    if (!ccw) angle = -angle;
    return angle <= 0 ? angle + kTurn_rad : angle;
}

// Left of a, as far as a is long.
Vector2d left_normal(const Vector2d& a) {
    return {-a.y(), a.x()};
}

}  // namespace

Point Control::to_machine(const Point& program) const {
    Point machine = program + other_offsets();
    machine.head<3>() = space() * Eigen::Vector3d(program.head<3>());
    return machine;
}

Point Control::to_program(const Point& machine) const {
    Point program = machine - other_offsets();
    program.head<3>() = space().inverse() * Eigen::Vector3d(machine.head<3>());
    return program;
}

void Control::select_plane(const ReadBlock& block) {
    for (int plane = 0; plane < 3; ++plane)
        if (block.has("G" + std::to_string(17 + plane))) plane_ = plane;
}

void Control::select_units(const ReadBlock& block) {
    if (block.has("G20")) unit_mm_ = 25.4;
    if (block.has("G21")) unit_mm_ = 1;
}

void Control::select_distance(const ReadBlock& block) {
    if (block.has("G90")) incremental_ = false;
    if (block.has("G91")) incremental_ = true;
}

void Control::select_system(const ReadBlock& block) {
    for (std::size_t i = 0; i < std::size(kSystems); ++i)
        if (block.has(kSystems[i])) system_ = i;
}

void Control::select_feed_mode(const ReadBlock& block) {
    if (block.has("G93")) inverse_time_ = true;
    if (block.has("G94")) inverse_time_ = false;
}

void Control::set_feed(const ReadBlock& block) {
    if (const auto f = block.word("F")) {
        feed_ = *f;
        feed_unit_mm_ = unit_mm_;
    }
}

void Control::dwell(double seconds) {
    Move move;
    move.kind = Kind::dwell;
    move.end = position_;
    move.time_s = seconds;
    moves_.push_back(move);
}

Point Control::program_target(const ReadBlock& block) const {
    Point target = program_point();
    each_axis(block, [&](std::size_t axis, double value) {
        double& coordinate = target[static_cast<Eigen::Index>(axis)];
        coordinate = incremental_ ? coordinate + value : value;
    });
    return target;
}

void Control::add(Move move) {
    const bool still = move.kind != Kind::arc && (move.end - position_).norm() < kNoMove_mm;
    if (!still) moves_.push_back(move);
    position_ = move.end;
}

void Control::go(bool rapid, const Point& machine) {
    Move move;
    move.kind = rapid ? Kind::rapid : Kind::linear;
    move.end = machine;
    const Point displacement = machine - position_;
    move.length_mm = displacement.head<3>().norm();
    if (!rapid) {
        const bool is_rotary_only = move.length_mm < kNoMove_mm && displacement.tail<3>().norm() < kNoMove_mm;
        const double length = is_rotary_only ? displacement.norm() : move.length_mm;
        if (inverse_time_) move.time_s = kSecondsPerMinute / feed_;
        move.feed_per_min = inverse_time_ ? length * feed_ : feed_ * (is_rotary_only ? 1 : feed_unit_mm_);
    }
    add(move);
}

void Control::line(bool rapid, const ReadBlock& block) {
    if (!block.has("G53")) return go(rapid, to_machine(program_target(block)));
    Point target = position_;
    each_axis(block,
              [&](std::size_t axis, double value) { target[static_cast<Eigen::Index>(axis)] = value; });
    go(rapid, target);
}

Control::Circle Control::circle_by_centre(const ReadBlock& block, const Vector2d& from, const Vector2d& to,
                                          bool ccw) const {
    Vector2d centre = arc_centre_is_point_ ? Vector2d::Zero().eval() : from;
    for (Eigen::Index i = 0; i < 2; ++i) {
        const auto axis =
            static_cast<std::size_t>(kPlanes[static_cast<std::size_t>(plane_)][static_cast<std::size_t>(i)]);
        centre[i] += block.word(std::string(1, kCentreWords[axis])).value_or(0) * unit_mm_;
    }
    const bool full = (to - from).norm() < kNoMove_mm;
    return {centre, full ? kTurn_rad : sweep_angle(from - centre, to - centre, ccw)};
}

// Two circles pass through both ends: returns the arc of at most half a turn, or the other one if R is below
// 0.
Control::Circle Control::circle_by_radius(double radius, const Vector2d& from, const Vector2d& to, bool ccw) {
    const Vector2d half = (to - from) / 2;
    const double lateral = std::sqrt(std::max(radius * radius - half.squaredNorm(), 0.0));
    const bool centre_on_left = ccw == (radius > 0);
    const Vector2d centre =
        from + half + (centre_on_left ? 1 : -1) * lateral * left_normal(half).normalized();
    return {centre, sweep_angle(from - centre, to - centre, ccw)};
}

// Worked out in program coordinates; what comes of it in the machine is found at the end.
void Control::arc(bool ccw, const ReadBlock& block) {
    const auto [first, second, normal] = kPlanes[static_cast<std::size_t>(plane_)];
    const Point start = program_point(), end = program_target(block);
    const Vector2d from(start[first], start[second]), to(end[first], end[second]);
    const auto radius = block.word("R");
    Circle circle =
        radius ? circle_by_radius(*radius * unit_mm_, from, to, ccw) : circle_by_centre(block, from, to, ccw);
    circle.sweep_rad += kTurn_rad * (block.word("P").value_or(1) - 1);

    Move move;
    move.kind = Kind::arc;
    move.end = to_machine(end);
    move.turns = static_cast<int>(std::ceil(circle.sweep_rad / kTurn_rad - 1e-9));
    Eigen::Vector3d centre = start.head<3>();
    centre[first] = circle.centre[0];
    centre[second] = circle.centre[1];
    move.centre = space() * centre;
    const Eigen::Matrix3d turn = space().linear();
    move.axis = (ccw ? 1 : -1) * turn.col(first).cross(turn.col(second)).normalized();
    const Eigen::Vector3d out = position_.head<3>() - move.centre;
    const Eigen::Vector3d displacement = move.end.head<3>() - position_.head<3>();
    move.length_mm = std::hypot(out.cross(move.axis).norm() * circle.sweep_rad, displacement.dot(move.axis));
    if (inverse_time_) move.time_s = inverse_time_of_arc_s(circle.sweep_rad) / feed_;
    move.feed_per_min =
        inverse_time_ ? move.length_mm / *move.time_s * kSecondsPerMinute : feed_ * feed_unit_mm_;
    add(move);
}

}  // namespace gsim::roundtrip
