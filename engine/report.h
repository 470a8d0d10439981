#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/api.h"
#include "engine/diagnostic.h"

namespace gsim::engine {

enum class RunStatus : std::uint8_t {
#define GSIM_RUN_STATUS(name, number, constant) name = (number),
#include "base/kinds/run_status.def"
};

/// Returns "completed", ...
GSIM_API std::string_view name(RunStatus status);

/// A source location; line 0: not known.
struct SourceLocation {
    std::string file = {};
    std::uint32_t line = 0;
};

/// A program call that had not ended.
struct OpenCall {
    std::string program;           ///< "O2"
    SourceLocation location = {};  ///< Location of the call.
};

/// The reason why a run did not complete.
struct Alarm {
    std::string code;  ///< As Diagnostic::code.
    std::string message;
    SourceLocation location = {};
    std::vector<OpenCall> calls = {};  ///< From the innermost to the first.
    char axis = 0;                     ///< Letter, if one axis is the cause.
    std::optional<double> value = {};  ///< Value of that axis, mm or deg.
    std::optional<double> limit = {};  ///< That it passed, mm or deg.
};

/// An axis beyond its range, or a tool in a zone that forbids it; the run continued.
struct Violation {
    double t_s = 0;
    SourceLocation location = {};
    std::string message = {};
    std::string zone = {};  ///< Its name; empty for the range of an axis.
    char axis = 'X';
    bool rotary = false;  ///< Values are in deg, else in mm.
    double value = 0;
    double limit = 0;
};

/// The first contact of two bodies.
struct Collision {
    double t_s = 0;
    SourceLocation location = {};
    std::string first = {}, second = {};  ///< Names of the bodies.
    std::array<double, 3> point_mm = {};  ///< In the world.
};

struct Event {
    double t_s = 0;
    SourceLocation location = {};
    std::string kind = {};  ///< "process_on", "tool", "stop", ... (docs/report.md)
    std::string detail = {};
};

/// The range of a machine axis: the reached values and the limits; mm or deg.
struct AxisRange {
    char letter = 'X';
    bool rotary = false;
    double min = 0, max = 0;
    double limit_min = 0, limit_max = 0;
};

/// Parts of the cycle time.
struct ReportTimes {
    double rapid_s = 0, feed_s = 0, dwell_s = 0;
};

/// Distances of the TCP.
struct ReportDistances {
    double rapid_mm = 0, feed_mm = 0, process_on_mm = 0;
};

struct ReportCounts {
    std::uint64_t blocks = 0;
    std::uint64_t moves = 0;
};

/// The results of a run. Frequently needed values are fields; json() and text() have everything
/// (docs/report.md).
struct GSIM_API Report {
    /// For internal use.
    struct Full;

    std::string program = {};
    std::string machine = {};
    RunStatus status = RunStatus::completed;
    std::optional<Alarm> alarm = {};  ///< Also the reason for a stop.
    double cycle_time_s = 0;
    /// Interval with a probability of 95 %, if the machine file says how it was fitted.
    struct Interval {
        double min_s = 0;
        double max_s = 0;
    };
    std::optional<Interval> cycle_time_95 = {};
    ReportTimes times = {};
    ReportDistances distances = {};
    ReportCounts counts = {};
    std::vector<AxisRange> ranges = {};
    std::vector<Violation> violations = {};  ///< The first ones by time.
    std::uint64_t violation_count = 0;       ///< Number of all.
    std::vector<Collision> collisions = {};
    std::uint64_t process_findings = 0;  ///< Process errors of a program: a rapid with the jet on, ...
    std::vector<Event> events = {};
    std::vector<std::string> warnings = {};
    std::vector<Diagnostic> diagnostics =
        {};                  ///< All diagnostics, including those above, in the order of docs/diagnostics.md.
    std::string robot = {};  ///< Name of the robot, if the run has several.
    std::vector<Report> robots = {};  ///< Reports of several robots; the other fields are of all.
    std::shared_ptr<const Full> full = nullptr;

    /// Returns true if the run completed, within limits and zones, and nothing touched.
    bool is_clean() const;
    /// Returns true if a check passes: clean, and without process errors in the program.
    bool passes_check() const;
    /// Returns true if the run ended because a required file cannot be read, which is no error of the
    /// program.
    bool is_file_missing() const;
    /// Returns the errors for people, in full lines: collisions, violations, the reason for the end.
    std::string errors_text() const;
    /// Returns the report as JSON, keys in a fixed order, without a line feed at its end.
    std::string json() const;
    /// Returns a compact table for people, in full lines.
    std::string text() const;
    /// Returns the same report, with one more diagnostic of the program's text or of outputs.
    Report with(const Diagnostic& diagnostic) const;
};

}  // namespace gsim::engine
