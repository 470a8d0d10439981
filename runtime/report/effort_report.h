#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "runtime/simulator/move.h"

namespace gsim::simulation {

/// What the motor of an axis had to do: N of a linear axis, Nm of a rotary one, in the sense of its value.
struct AxisEffort {
    char letter = 'X';
    bool rotary = false;
    double peak = 0;  ///< The greatest, either way.
    double peak_t_s = 0;
    Place peak_place = {};
    double rms = 0;  ///< Root mean square over the whole run, rests among it.
    double peak_power_w = 0;
    double in_j = 0;        ///< Work of the motor at the machine,
    double back_j = 0;      ///< and of the machine at the motor.
    double friction_j = 0;  ///< Of it what friction of the axis took.
    double impulse = 0;     ///< The greatest at a jump of speed, N s or Nm s.
    Place impulse_place = {};
    double motor_peak = std::numeric_limits<double>::infinity();
    double motor_continuous = std::numeric_limits<double>::infinity();
};

/// What the motors did while a program or subprogram ran, without those that it called.
struct ProgramEnergy {
    std::string program;  ///< "O2"; empty: the main program.
    double time_s = 0;
    double in_j = 0;
    double back_j = 0;
};

/// A motor is asked for more than it has.
struct EffortExcess {
    double t_s = 0;
    Place place = {};
    char letter = 'X';
    bool rotary = false;
    double effort = 0;  ///< That the move needs, without its sense.
    double limit = 0;   ///< Of the motor at that speed.
    /// With this share of its accelerations the move would be within the limit; none: with no acceleration.
    std::optional<double> acceleration_share = std::nullopt;
    bool continuous = false;  ///< It is the root mean square of the run, and of no place.
};

/// Of forces and torques what a report lists of them, at most.
inline constexpr std::size_t kMostExcesses = 1000;

/// What the motors of a run had to do.
struct EffortReport {
    std::vector<AxisEffort> axes;
    double in_j = 0;  ///< Of all axes: nothing is passed from one to another one.
    double back_j = 0;
    double friction_j = 0;
    double peak_power_w = 0;  ///< Of all axes together.
    double peak_power_t_s = 0;
    Place peak_power_place = {};
    /// What the same moves take with the accelerations of the axes, where the motors' peaks limit them.
    std::optional<double> time_by_axes_s = std::nullopt;
    std::uint64_t jumps = 0;              ///< Of speeds, for which no force is finite.
    std::vector<ProgramEnergy> programs;  ///< In the order in which they moved first.
    std::vector<EffortExcess> excesses;   ///< By time, kMostExcesses at most.
    std::uint64_t excess_count = 0;       ///< Of all.
};

/// "axis X needs 812 N of 600 N; 0.74 of its acceleration would do"
std::string excess_text(const EffortExcess& excess);

}  // namespace gsim::simulation
