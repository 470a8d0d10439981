#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "runtime/simulator/move.h"

namespace gsim::simulation {

/// Effort of an axis motor: N for a linear axis, Nm for a rotary one, in the sense of its value.
struct AxisEffort {
    char letter = 'X';
    bool rotary = false;
    double peak = 0;  ///< Largest, in either direction.
    double peak_t_s = 0;
    SourceLocation peak_location = {};
    double rms = 0;  ///< Root mean square over the full run, standstill included.
    double peak_power_w = 0;
    double drive_j = 0;        ///< Work of the motor at the machine,
    double regenerated_j = 0;  ///< and of the machine at the motor.
    double friction_j = 0;     ///< Part of it that axis friction took.
    double impulse = 0;        ///< The greatest at a jump of speed, N s or Nm s.
    SourceLocation impulse_location = {};
    double motor_peak = std::numeric_limits<double>::infinity();
    double motor_continuous = std::numeric_limits<double>::infinity();
};

/// Work of the motors while a program or subprogram ran, without those that it called.
struct ProgramEnergy {
    std::string program;  ///< "O2"; empty: the main program.
    double time_s = 0;
    double drive_j = 0;
    double regenerated_j = 0;
};

/// Effort that exceeds the limit of a motor.
struct EffortExcess {
    double t_s = 0;
    SourceLocation location = {};
    char letter = 'X';
    bool rotary = false;
    double effort = 0;  ///< That the move needs, without its sense.
    double limit = 0;   ///< Motor limit at that speed.
    /// Share of its accelerations with which the move would be within the limit; nullopt: with no
    /// acceleration.
    std::optional<double> acceleration_share = std::nullopt;
    bool continuous = false;  ///< It is the root mean square of the run, without a location.
};

/// Max number of forces and torques that a report lists.
inline constexpr std::size_t kMaxExcesses = 1000;

/// Efforts of the motors of a run.
struct EffortReport {
    std::vector<AxisEffort> axes;
    double drive_j = 0;  ///< Over all axes: no energy is passed from one to another.
    double regenerated_j = 0;
    double friction_j = 0;
    double peak_power_w = 0;  ///< Sum over all axes.
    double peak_power_t_s = 0;
    SourceLocation peak_power_location = {};
    /// Time of the same moves with the accelerations of the axes, if the motors' peaks limit them.
    std::optional<double> time_by_axis_accelerations_s = std::nullopt;
    std::uint64_t jumps = 0;              ///< Jumps of speed, for which no force is finite.
    std::vector<ProgramEnergy> programs;  ///< In the order in which they moved first.
    std::vector<EffortExcess> excesses;   ///< By time, kMaxExcesses at most.
    std::uint64_t excess_count = 0;       ///< Total count.
};

/// "axis X needs 812 N of 600 N; 0.74 of its acceleration would do"
std::string excess_text(const EffortExcess& excess);

}  // namespace gsim::simulation
