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

/// "completed", ...
GSIM_API std::string_view name(RunStatus status);

/// A place in a source; line 0: not known.
struct Place {
    std::string file = {};
    std::uint32_t line = 0;
};

/// A call of a program that had not ended.
struct OpenCall {
    std::string program;  ///< "O2"
    Place place = {};     ///< Of the call.
};

/// Why a run did not complete.
struct Alarm {
    std::string code;  ///< As Diagnostic::code.
    std::string message;
    Place place = {};
    std::vector<OpenCall> calls = {};  ///< From the innermost to the first.
    char axis = 0;                     ///< Letter, where one axis is to blame.
    std::optional<double> value = {};  ///< Of that axis, mm or deg.
    std::optional<double> limit = {};  ///< That it passed, mm or deg.
};

/// An axis past its range, or a tool where a zone does not allow it; the run went on.
struct Violation {
    double t_s = 0;
    Place place = {};
    std::string message = {};
    std::string zone = {};  ///< Its name; empty where the range of an axis is passed.
    char axis = 'X';
    bool rotary = false;  ///< Values are in deg, else in mm.
    double value = 0;
    double limit = 0;
};

/// Two bodies begin to touch.
struct Collision {
    double t_s = 0;
    Place place = {};
    std::string first = {}, second = {};  ///< Names of the bodies.
    std::array<double, 3> point_mm = {};  ///< In the world.
};

struct Event {
    double t_s = 0;
    Place place = {};
    std::string kind = {};  ///< "jet_on", "tool", "stop", ... (docs/report.md)
    std::string detail = {};
};

/// Of an axis of the machine: what it reached, and what it may; mm or deg.
struct AxisRange {
    char letter = 'X';
    bool rotary = false;
    double min = 0, max = 0;
    double limit_min = 0, limit_max = 0;
};

/// What a run did. Figures that people ask for are fields; json() and text() have everything
/// (docs/report.md).
struct GSIM_API Report {
    /// For the library itself.
    struct Whole;

    std::string program = {};
    std::string machine = {};
    RunStatus status = RunStatus::completed;
    std::optional<Alarm> alarm = {};  ///< Also why a run was stopped.
    double cycle_time_s = 0;
    /// Between these it is with a probability of 95 %, where the machine file tells how it was fitted.
    struct Interval {
        double least_s = 0;
        double most_s = 0;
    };
    std::optional<Interval> cycle_time_95 = {};
    double rapid_s = 0, feed_s = 0, dwell_s = 0;
    double rapid_mm = 0, feed_mm = 0, jet_on_mm = 0;
    std::uint64_t blocks = 0;
    std::uint64_t moves = 0;
    std::vector<AxisRange> ranges = {};
    std::vector<Violation> violations = {};  ///< The first ones by time.
    std::uint64_t violation_count = 0;       ///< Of all.
    std::vector<Collision> collisions = {};
    std::uint64_t process_findings = 0;  ///< What a program should not do: a rapid with the jet on, ...
    std::vector<Event> events = {};
    std::vector<std::string> warnings = {};
    std::vector<Diagnostic> diagnostics = {};  ///< All that there is to tell, the above among it, in the
                                               ///< order of docs/diagnostics.md.
    std::string robot = {};                    ///< Whose it is, where there are several.
    std::vector<Report> robots = {};           ///< Of a run of several: what each did; the rest is of all.
    std::shared_ptr<const Whole> whole = nullptr;

    /// Nothing went wrong: it completed, within limits and zones, and nothing touched.
    bool is_clean() const;
    /// Of a check: clean, and the program does nothing that it should not with the process.
    bool passes_check() const;
    /// It ended where a file that it needs cannot be read, which is no fault of the program.
    bool lacks_file() const;
    /// What went wrong, for people, in whole lines: collisions, violations, why it ended.
    std::string faults_text() const;
    /// The report as JSON, keys in a fixed order, without a line feed at its end.
    std::string json() const;
    /// A compact table for people, in whole lines.
    std::string text() const;
    /// The same report, with one more diagnostic of the program's text or of outputs.
    Report with(const Diagnostic& diagnostic) const;
};

}  // namespace gsim::engine
