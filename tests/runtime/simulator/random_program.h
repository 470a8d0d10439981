#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "runtime/simulator/simulator.h"

/// Random machines, and random programs of all kinds of moves.
namespace gsim::simulation {

/// Divisor of the tests under sanitizers, because each takes ten times as long.
#ifdef GSIM_SANITIZED
inline constexpr int kFewerBy = 10;
#else
inline constexpr int kFewerBy = 1;
#endif

inline double between(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// Spread evenly over the decades about `middle`.
inline double around(std::mt19937& random, double middle, double decades) {
    return middle * std::pow(10, between(random, -decades, decades));
}

/// Adds a tool with a mass off the turning head's axis, on a hose. The machine has a table of dynamics.
inline void add_tool_on_hose(machine::Machine& machine) {
    machine.dynamics->masses.push_back(
        {.on = "tool", .mass_kg = 5, .centre_mm = {20, 10, 80}, .inertia_kg_m2 = {0.02, 0.02, 0.01}});
    machine.dynamics->hoses.push_back({.on = "tool",
                                       .point_mm = {0, 0, 200},
                                       .anchor_mm = {0, 0, 1500},
                                       .free_length_mm = 900,
                                       .stiffness_n_per_mm = 0.05});
}

/// The machine without limits of ranges, speeds and accelerations.
inline machine::Machine unlimited(machine::Machine machine) {
    constexpr double kUnlimited = std::numeric_limits<double>::infinity();
    machine.path = {};
    for (machine::Axis& axis : machine.axes) {
        axis.min = -kUnlimited;
        axis.max = axis.max_speed = axis.max_acceleration = axis.max_jerk = kUnlimited;
    }
    return machine;
}

/// The machine with other limits, of which some are left out.
inline machine::Machine random_machine(std::mt19937& random, const machine::Machine& like) {
    machine::Machine machine = unlimited(like);
    for (machine::Axis& axis : machine.axes) {
        axis.max_speed = around(random, 200, 0.7);
        axis.max_acceleration = around(random, 500, 0.7);
        axis.max_jerk = around(random, 5000, 0.7);
        axis.max_speed_step = around(random, 2, 1);
    }
    if (random() % 2 == 0) machine.path.max_feed_mm_s = around(random, 150, 0.5);
    if (random() % 2 == 0) machine.path.max_rapid_mm_s = around(random, 250, 0.5);
    if (random() % 2 == 0) machine.path.max_acceleration_mm_s2 = around(random, 500, 0.5);
    return machine;
}

inline Eigen::Vector3d random_direction(std::mt19937& random) {
    Eigen::Vector3d direction;
    do {
        for (double& part : direction) part = between(random, -1, 1);
    } while (!(direction.norm() > 0.1 && direction.norm() < 1));
    return direction.normalized();
}

/// Returns a full circle from the machine's position.
inline ArcMove circle_at(const Simulator& simulator, double radius_mm, double feed_mm_min) {
    ArcMove move;
    move.center_mm = {simulator.position().axes()[0] + radius_mm, simulator.position().axes()[1], 0};
    move.sweep_rad = 2 * std::numbers::pi;
    move.target = simulator.position().axes();
    move.feed.linear_mm_min = feed_mm_min;
    return move;
}

class RandomMoves {
  public:
    RandomMoves(std::mt19937& random, Simulator& simulator) : random_(random), simulator_(simulator) {}

    void make(int count) {
        for (int i = 0; i < count; ++i) make_one();
    }

  private:
    void make_one() {
        switch (random_() % 12) {
            case 0: simulator_.dwells().enqueue(between(random_, 0, 0.2), {}); break;
            case 1:
                simulator_.program().settings().set_path_mode(static_cast<rrs::PathMode>(random_() % 3), 0,
                                                              0);
                break;
            case 2: line(MoveKind::rapid, any_axis()); break;
            case 3: line(MoveKind::linear, {3, 4}); break;
            case 4: line(MoveKind::rapid, {3, 4}); break;
            case 5: line(MoveKind::linear, {0, 4}); break;
            case 6:
            case 7:
            case 8: arc(); break;
            case 9: via(); break;
            default: line(MoveKind::linear, any_axis());
        }
    }

    struct Axes {
        int first;
        int last;
    };
    Axes any_axis() { return random_() % 3 == 0 ? Axes{0, 4} : Axes{0, 2}; }

    AxisVector target(Axes axes) {
        const double size = around(random_, 10, 1.5);
        AxisVector target = simulator_.position().axes();
        for (int axis = axes.first; axis <= axes.last; ++axis) {
            if (random_() % 3 != 0) target[axis] += between(random_, -size, size);
        }
        return target;
    }

    Feed feed() {
        Feed feed{around(random_, 3000, 1), around(random_, 3000, 1), {}};
        if (random_() % 8 == 0) feed.motion_s = around(random_, 0.3, 1);
        return feed;
    }

    void line(MoveKind kind, Axes axes) {
        simulator_.moves().enqueue(
            LineMove{.kind = kind, .target = target(axes), .feed = feed(), .location = {}});
    }

    // In one of the planes or an oblique one, with travel along its normal and of the rotary axes in some.
    void arc() {
        ArcMove move;
        move.normal = random_() % 2 == 0 ? plane_normal(static_cast<Plane>(random_() % 3))
                                         : canonical_normal(random_direction(random_));
        move.kind = random_() % 2 == 0 ? MoveKind::arc_cw : MoveKind::arc_ccw;
        const double radius = around(random_, 20, 1);
        const Eigen::Vector3d out = random_direction(random_).cross(move.normal).normalized();
        move.sweep_rad = between(random_, 0.05, 8);
        const AxisVector start = simulator_.position().axes();
        move.center_mm = start.head<3>() - radius * out;
        const Eigen::Vector3d ahead = move.axis().cross(out);
        move.target = start;
        move.target.head<3>() =
            move.center_mm + radius * (std::cos(move.sweep_rad) * out + std::sin(move.sweep_rad) * ahead);
        if (random_() % 2 == 0) move.target.head<3>() += between(random_, -3, 3) * radius * move.normal;
        if (random_() % 4 == 0) move.target[3] += between(random_, -20, 20);
        move.feed = feed();
        simulator_.moves().enqueue(move);
    }

    void via() {
        ViaMove move;
        move.via = target({0, 2});
        move.target = simulator_.position().axes();
        const double size = (move.via - move.target).norm() + 1;
        for (int axis = 0; axis < 3; ++axis) {
            move.via[axis] += between(random_, 0.1, 1) * size;
            move.target[axis] += between(random_, -1, -0.1) * size;
        }
        move.feed = feed();
        simulator_.moves().enqueue(move);
    }

    std::mt19937& random_;
    Simulator& simulator_;
};

inline void make_random_moves(std::mt19937& random, Simulator& simulator, int count) {
    RandomMoves(random, simulator).make(count);
}

}  // namespace gsim::simulation
