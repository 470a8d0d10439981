#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "runtime/simulation/move.h"

namespace gsim::simulation {

enum class RunStatus { completed, stopped, alarm };
std::string_view name(RunStatus status);

/// A call of a program that had not ended.
struct OpenCall {
    std::string program;  ///< "O2"
    Place place = {};     ///< Of the call.
};

/// Why a run did not complete, as a sentence, and where.
struct Alarm {
    std::string message;
    Place place = {};
    std::vector<OpenCall> calls = {};  ///< From the innermost to the first.
    char axis = 0;                     ///< Letter, where one axis is to blame.
    std::optional<double> value;       ///< Of that axis (mm or deg).
    std::optional<double> limit;       ///< That it passed (mm or deg).
};

struct Event {
    double t_s = 0;
    Place place = {};
    std::string kind;    ///< jet_on, jet_off, abrasive_on, abrasive_off, stop, optional_stop, tool, ...
    std::string detail;  ///< Free text for people; may be empty.
};

struct AxisBounds {
    char letter = 'X';
    bool rotary = false;
    double min = 0, max = 0;              ///< Reached, from the start position on (mm or deg).
    double limit_min = 0, limit_max = 0;  ///< Of the machine.
};

/// Corners that the controller has rounded.
struct Blends {
    std::uint64_t count = 0;
    double max_deviation_mm = 0;  ///< Of the tool from the programmed corner.
    Place place = {};             ///< Of the move with the greatest one.
};

struct SlowBlock {
    Place place = {};
    MoveKind kind = MoveKind::linear;
    double duration_s = 0;
    double length_mm = 0;
    std::string limited_by = {};  ///< What kept it from being faster (describe()); empty in a dwell.
};

/// How long something was what kept the machine from being faster.
struct LimitTime {
    std::string limited_by;  ///< As describe() names it, or "dwell".
    double time_s = 0;
};

/// Why the run took as long as it did.
struct Explanation {
    std::vector<LimitTime> time_by_limit;  ///< The most time first; together the cycle time.
    /// In which no controller could go the same path (PathBound); none of a motion that is known by samples.
    std::optional<double> lower_bound_s = 0;
};

/// Two bodies of the cell begin to touch.
struct Collision {
    double t_s = 0;
    Place place = {};
    std::string first, second;            ///< Names of the bodies.
    std::array<double, 3> point_mm = {};  ///< Where, in the world.
    bool penetrating = false;             ///< Else they only touch.
};

/// The smallest distance of a block, where it is below what the cell asks for.
struct BlockClearance {
    Place place = {};
    double clearance_mm = 0;
    std::string first, second;
    std::array<double, 3> point_mm = {};  ///< On the second body, in the world.
};

/// What a run did in its cell.
struct CellFindings {
    std::string name;
    double clearance_mm = 0;  ///< That is asked for.
    std::vector<Collision> collisions;
    std::vector<BlockClearance> clearances;
    std::uint64_t dropped = 0;  ///< Entries past the most that a report lists.
};

/// What became of a process of the run.
struct ProcessSummary {
    std::string name;
    std::string robot;        ///< That it moved last; empty where it moved none.
    std::string state;        ///< "done", "waiting" or, where the run ended before it did, "stopped".
    bool background = false;  ///< The run did not wait for its end.
    double start_s = 0;
    double end_s = 0;
    double idle_s = 0;  ///< In which its robots waited for others.
};

/// A signal that a process has changed.
struct SignalChange {
    double t_s = 0;
    Place place = {};
    std::string process;
    std::string signal;
    std::string value;  ///< As scripts write it.
};

/// The whole result of a run; units are in the names, and in the JSON as well.
struct Report {
    std::string program;
    std::string machine;
    std::string controller;  ///< The model that its machine file names; empty where a module plans.
    RunStatus status = RunStatus::completed;
    std::optional<Alarm> alarm;  ///< Also why a run was stopped.
    double cycle_time_s = 0;
    double rapid_s = 0, feed_s = 0, dwell_s = 0;
    double rapid_mm = 0, feed_mm = 0, jet_on_mm = 0;
    std::uint64_t blocks = 0;
    std::uint64_t moves = 0;
    Blends blends;
    std::vector<AxisBounds> bounds;
    std::vector<Event> events;
    std::vector<std::string> warnings;
    std::vector<SlowBlock> slowest;  ///< At most ten, longest first.
    std::optional<Explanation> explanation;
    std::optional<CellFindings> cell;
    std::vector<ProcessSummary> processes;  ///< None where there was but the program.
    std::vector<SignalChange> signals;
    std::vector<std::string> files;  ///< Names that Place::file indexes.
};

/// The report as the JSON of the design (docs/report.md); keys in a fixed order, doubles in shortest form.
std::string to_json(const Report& report);

/// The report as a compact table for people.
std::string to_text(const Report& report);

}  // namespace gsim::simulation
