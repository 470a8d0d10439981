#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/error.h"
#include "tests/accuracy/controller.h"
#include "tests/accuracy/path_distance.h"

namespace gsim::accuracy {

/// Result of the comparison of a program's cycle time.
struct TimeOutcome {
    std::string name;
    std::string note;
    bool counted = true;
    double recorded_s = 0;
    Result<double> found_s = 0;  ///< Or why gsim has no time.
    std::string known;           ///< Reason of a known deviation; empty if none.

    double error_s() const { return *found_s - recorded_s; }
    double error_percent() const;
};

enum class Mark { close, fair, off, rejected, not_counted };

std::string_view name(Mark mark);
Mark mark(const TimeOutcome& outcome, const Controller& controller);

/// Result of the comparison of a program's positions.
struct PathOutcome {
    std::string name;
    Result<Distance> distance;  ///< Or why it is unknown.
    std::string known;

    bool good() const { return distance && distance->mm <= kGoodDistance_mm; }
};

/// Results of all programs of a controller. Programs that are not counted are in none of the values.
struct Summary {
    std::size_t counted = 0;
    std::size_t close = 0;
    std::size_t fair = 0;                ///< Those that are close among them.
    std::size_t unknown = 0;             ///< Not fair and not known to be off.
    std::size_t close_percent = 0;       ///< As many shall be close,
    std::size_t fair_percent = 0;        ///< and as many fair or known.
    std::optional<TimeOutcome> largest;  ///< Largest of those that gsim ran, by percent.

    /// Returns true if as many programs are close and fair as the controller requires.
    bool good() const;
};

Summary summarize(std::span<const TimeOutcome> outcomes, const Controller& controller);

}  // namespace gsim::accuracy
