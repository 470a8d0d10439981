#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "tests/accuracy/controller.h"
#include "tests/accuracy/path_distance.h"

namespace gsim::accuracy {

/// How the cycle time of a program fared.
struct TimeOutcome {
    std::string name;
    std::string note;
    bool counted = true;
    double recorded_s = 0;
    tl::expected<double, std::string> found_s = 0;  ///< Or why gsim has none.
    std::string known;                              ///< Why it is known to be off; empty if it is not.

    double error_s() const { return *found_s - recorded_s; }
    double error_percent() const;
};

enum class Mark { close, fair, off, refused, not_counted };

std::string_view name(Mark mark);
Mark mark(const TimeOutcome& outcome, const Controller& controller);

/// How the positions of a program fared.
struct PathOutcome {
    std::string name;
    tl::expected<Distance, std::string> distance;  ///< Or why it cannot be told.
    std::string known;

    bool good() const { return distance && distance->mm <= kGoodDistance_mm; }
};

/// How the programs of a controller fared together. What is not counted is in none of the figures.
struct Summary {
    std::size_t counted = 0;
    std::size_t close = 0;
    std::size_t fair = 0;                ///< Those that are close among them.
    std::size_t unknown = 0;             ///< Not fair and not known to be off.
    std::size_t close_percent = 0;       ///< As many shall be close,
    std::size_t fair_percent = 0;        ///< and as many fair or known.
    std::optional<TimeOutcome> largest;  ///< Of those that gsim ran, by percent.

    /// Whether as many are close and fair as the controller asks for.
    bool good() const;
};

Summary summarize(std::span<const TimeOutcome> outcomes, const Controller& controller);

}  // namespace gsim::accuracy
